"""Each level fails alone, with its exit code, and names what grew. Nothing else makes it fail."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from gate_world import WORLD, World, fact, first, with_valgrind

from gate import levels
from gate.findings import ERROR, GOOD, REGRESSION, WRONG_ANSWER, GateError, LevelResult, Weight
from gate.verdict import as_json, as_markdown, as_text, of_level


def test_equal_revisions_are_good_at_every_level(world: World) -> None:
    verdict = world.gate(levels=(0, 1, 3, 4))
    assert verdict.exit_code == GOOD and verdict.findings == []
    assert [level.compared for level in verdict.levels] == [4, 4, 4, 4]
    assert as_text(verdict).startswith("good: head against base\n")


def test_wrong_answer_is_shown_first_and_exits_2(world: World) -> None:
    def change(head: dict[str, Any]) -> None:
        fact("ich", "outcome", "wrong answer")(head)
        fact("mmp", "propagations", 20_000)(head)

    verdict = world.gate(change)
    assert verdict.exit_code == WRONG_ANSWER
    assert first(verdict) == "ich/cube/src:0: wrong answer: vertex 7 is off"
    assert as_text(verdict).startswith("WRONG ANSWER: ")
    assert verdict.levels[0].table[1] == ["ich", "0 of 2", "-", "WRONG ANSWER on 2"]


@pytest.mark.parametrize(
    ("key", "value", "code", "failed"),
    [
        ("outcome", "wrong answer", WRONG_ANSWER, 0),
        ("propagations", 10_500, REGRESSION, 1),
        ("instructions", 1_050_000, REGRESSION, 2),
        ("peak_bytes", 11_000_000, REGRESSION, 3),
    ],
)
def test_when_a_level_has_failed_the_later_ones_are_measured_only_if_all_are_asked_for(
    world: World, monkeypatch: pytest.MonkeyPatch, key: str, value: object, code: int, failed: int
) -> None:
    with_valgrind(monkeypatch)
    verdict = world.gate(fact("mmp", key, value), levels=(0, 1, 2, 3, 4))
    assert verdict.exit_code == code and [one.level for one in verdict.levels] == [0, 1, 2, 3, 4]
    skipped = f"skipped: level {failed} has failed, so that the verdict is certain"
    left = [4] if failed == 2 else [2, 4]
    assert [one.level for one in verdict.levels if one.result.startswith(skipped)] == left
    assert f"Level 4. CPU time, interleaved pairs: {skipped}" in as_text(verdict)
    assert world.measured == ({"instruction counts": 4} if failed == 2 else {})

    verdict = world.gate(fact("mmp", key, value), levels=(0, 1, 2, 3, 4), everything=True)
    assert verdict.exit_code == code and not any(one.skipped for one in verdict.levels)
    assert world.measured["timed processes"] == (60 if failed == 0 else 120)


def test_the_lines_of_a_level_appear_before_the_next_level_is_measured(
    world: World, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with_valgrind(monkeypatch)
    world.gate(fact("mmp", "instructions", 1_010_000), levels=(0, 1, 2, 3, 4))
    said = [line.partition(":")[0] for line in capsys.readouterr().err.splitlines()]
    assert said == [
        "levels 0, 1 and 3",
        "the environments agree",
        "Level 0. Distances against the oracles",
        "Level 1. The algorithms' counters against the committed baseline",
        "Level 3. Solver's peak memory",
        "level 2",
        "Level 2. Instructions inside solve, counted by callgrind",
        "  level 2 warning",
        "level 4",
        "Level 4. CPU time, interleaved pairs, margin 1.1",
        "  level 4 note",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("outcome", "code"), [("crashed", WRONG_ANSWER), ("unsupported", REGRESSION)]
)
def test_no_answer_where_the_base_has_one_is_a_failure(
    world: World, outcome: str, code: int
) -> None:
    verdict = world.gate(fact("mmp", "outcome", outcome))
    assert verdict.exit_code == code
    assert first(verdict).endswith(f"{outcome}: vertex 7 is off (the base solves it)")


def test_what_is_said_of_several_rows_is_said_once_with_the_rows(world: World) -> None:
    text = as_text(world.gate(fact("mmp", "outcome", "crashed")))
    assert text.splitlines()[1:4] == [
        "  level 0 FAILED: mmp/cube/src:0; mmp/hill/src:0: crashed: vertex 7 is off (the base solves it)",
        "  the environments agree: processor, compiler, compiler flags, threads",
        "",
    ]
    many = LevelResult(1, "t", compared=9)
    for row in "abcdefg":
        many.add(Weight.NOTE, row, remark="less")
    for row in "hi":
        many.add(Weight.NOTE, row)
    assert of_level(many)[1:] == [
        "  level 1 note: a; b; c; and 4 more, in the table: less",
        "  level 1 note: h",
        "  level 1 note: i",
    ]


def test_no_answer_as_in_the_base_is_a_warning(world: World) -> None:
    crashed = fact("mmp", "outcome", "crashed")
    verdict = world.gate(crashed, crashed, levels=(0, 3))
    assert verdict.exit_code == GOOD and "as in the base" in first(verdict)


@pytest.mark.parametrize(
    ("solver", "key", "value", "code", "found"),
    [
        ("mmp", "propagations", 10_101, REGRESSION, [(1, Weight.FAILURE)]),
        ("mmp", "propagations", 10_100, GOOD, [(1, Weight.WARNING)]),
        ("mmp", "propagations", 9_000, GOOD, [(1, Weight.NOTE)]),
        ("mmp", "peak_bytes", 10_200_001, REGRESSION, [(3, Weight.FAILURE)]),
        ("mmp", "peak_bytes", 10_200_000, GOOD, []),
        ("ich", "peak_bytes", 1_065_537, REGRESSION, [(3, Weight.FAILURE)]),
        ("ich", "peak_bytes", 1_065_536, GOOD, []),
    ],
)
def test_counters_fail_above_one_percent_and_memory_above_two_percent_and_64_kib(
    world: World, solver: str, key: str, value: int, code: int, found: list[tuple[int, Weight]]
) -> None:
    """Every change of a counter is reported, on both meshes."""
    verdict = world.gate(fact(solver, key, value))
    assert verdict.exit_code == code
    assert [(finding.level, finding.weight) for finding in verdict.findings] == 2 * found
    change = f"{WORLD['solvers'][solver][key]} to {value}"
    assert all(change in finding.text for finding in verdict.findings)


@pytest.mark.parametrize(
    ("count", "code", "weights"),
    [
        (1_004_999, GOOD, []),
        (1_005_001, GOOD, [Weight.WARNING]),
        (1_019_999, GOOD, [Weight.WARNING]),
        (1_020_001, REGRESSION, [Weight.FAILURE]),
        (900_000, GOOD, []),
    ],
)
def test_instructions_warn_above_half_a_percent_and_fail_above_two(
    world: World, monkeypatch: pytest.MonkeyPatch, count: int, code: int, weights: list[Weight]
) -> None:
    with_valgrind(monkeypatch)
    verdict = world.gate(fact("mmp", "instructions", count), levels=(0, 2))
    assert verdict.exit_code == code
    assert [finding.weight for finding in verdict.findings] == weights


def test_instructions_of_another_compiler_are_not_comparable(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    with_valgrind(monkeypatch)
    verdict = world.gate(lambda head: head.update(compiler="Clang 14"), levels=(0, 2))
    assert world.measured == {}
    assert verdict.exit_code == GOOD
    assert verdict.levels[1].skipped.startswith("not comparable: GNU 12.2.0 built the base")


def test_without_valgrind_level_2_is_skipped_and_says_why(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("shutil.which", lambda name: None)
    verdict = world.gate(levels=(0, 2))
    assert "Level 2. Instructions inside solve, counted by callgrind: skipped: valgrind" in as_text(
        verdict
    )


def test_level_2_is_skipped_where_valgrind_cannot_run_the_program(
    world: World, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    tool = tmp_path / "valgrind"
    tool.write_text("#!/bin/sh\necho 'valgrind: Unrecognised instruction at 0x1.' >&2; exit 132\n")
    tool.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    monkeypatch.setattr(levels, "CALLGRIND_MESHES", ("cube",))
    without = fact("mmp", "instructions", None)
    assert world.gate(without, without, levels=(0, 2)).levels[1].skipped.startswith("valgrind lacks an instruction")


def test_renamed_solver_is_an_error_that_says_so(world: World) -> None:
    def rename(head: dict[str, Any]) -> None:
        head["solvers"]["better"] = head["solvers"].pop("ich")

    verdict = world.gate(rename)
    assert verdict.exit_code == ERROR
    texts = [finding.line for finding in verdict.findings]
    assert texts[0].startswith("ich: in the baseline and not in the head: removed, or renamed?")
    assert any("better: only in the head: new" in text for text in texts)
    assert any("ich: only in the base: removed or renamed" in text for text in texts)


def test_new_solver_is_good_and_warned_about_until_the_baseline_has_it(world: World) -> None:
    def add(head: dict[str, Any]) -> None:
        head["solvers"]["newest"] = dict(head["solvers"]["mmp"])

    verdict = world.gate(add, levels=(0, 1, 3))
    assert verdict.exit_code == GOOD
    assert first(verdict).startswith("not in the baseline yet, so not judged: newest on cube")
    world.keep_baseline(add)
    assert first(world.gate(add)) == "newest: only in the head: new, nothing to compare with"


def test_removed_mesh_is_an_error_that_says_so(world: World) -> None:
    verdict = world.gate(lambda head: head.update(meshes=["cube"]))
    assert verdict.exit_code == ERROR
    assert first(verdict).startswith("hill: in the baseline and no mesh of the suite any more")


def test_comparing_nothing_is_an_error(world: World) -> None:
    crashed = fact("mmp", "outcome", "unsupported")
    with pytest.raises(GateError, match="no row was compared"):
        world.gate(crashed, crashed, solvers=("mmp",), levels=(0, 3))


def test_unknown_solver_lists_the_known_ones(world: World) -> None:
    with pytest.raises(GateError, match=r"the head: no solver named 'mpm' \(did you mean 'mmp'"):
        world.gate(solvers=("mpm",))


def test_a_solver_that_runs_by_name_only_is_judged_when_it_is_asked_for(world: World) -> None:
    def with_wrong_variant(one: dict[str, Any]) -> None:
        one["solvers"]["variant"] = one["solvers"]["mmp"] | {"outcome": "wrong answer"}
        one["by_name_only"] = ["variant"]

    assert world.gate(with_wrong_variant, with_wrong_variant).exit_code == GOOD
    named = world.gate(with_wrong_variant, with_wrong_variant, solvers=("variant", "mmp"))
    assert named.exit_code == WRONG_ANSWER and "variant" in first(named)


def test_reports_say_the_verdict_first_and_hold_every_level(world: World) -> None:
    verdict = world.gate(fact("mmp", "peak_bytes", 20_000_000))
    text = as_markdown(verdict)
    assert text.startswith("## REGRESSION: head against base\n\n- level 3 FAILED: mmp/cube")
    assert "| mmp/cube/src:0 | 10000000 | 20000000 | +100.00% |" in text
    data = json.loads(as_json(verdict))
    assert data["exit_code"] == REGRESSION and [x["level"] for x in data["levels"]] == [0, 1, 3]
