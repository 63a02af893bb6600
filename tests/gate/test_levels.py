"""Each level fails by itself, with its exit code, and says what grew; nothing else turns it red."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from gate_world import World

from gate import check, levels, machine, noise, pairs
from gate.errors import ERROR, GOOD, INCONCLUSIVE, REGRESSION, WRONG, GateError
from gate.findings import Weight
from gate.program import Cell, Program
from gate.verdict import Verdict, as_json, as_markdown, as_text

Change = Callable[[dict[str, Any]], object]


def fact(solver: str, key: str, value: object) -> Change:
    def change(world: dict[str, Any]) -> None:
        world["solvers"][solver][key] = value

    return change


def first(verdict: Verdict) -> str:
    return verdict.findings[0].text


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
    assert verdict.exit_code == WRONG
    assert first(verdict) == "ich/cube/src:0: wrong answer: vertex 7 is off"
    assert as_text(verdict).startswith("WRONG ANSWER: ")


@pytest.mark.parametrize(("outcome", "code"), [("crashed", WRONG), ("unsupported", REGRESSION)])
def test_no_answer_where_the_base_has_one_is_a_failure(
    world: World, outcome: str, code: int
) -> None:
    verdict = world.gate(fact("mmp", "outcome", outcome))
    assert verdict.exit_code == code
    assert first(verdict).endswith(f"{outcome}: vertex 7 is off (the base solves it)")


def test_no_answer_as_in_the_base_is_a_warning(world: World) -> None:
    crashed = fact("mmp", "outcome", "crashed")
    verdict = world.gate(crashed, crashed, levels=(0, 3))
    assert verdict.exit_code == GOOD and "as in the base" in first(verdict)


@pytest.mark.parametrize(
    ("propagations", "code", "weight"),
    [
        (10_101, REGRESSION, Weight.FAILURE),
        (10_100, GOOD, Weight.WARNING),
        (9_000, GOOD, Weight.NOTE),
    ],
)
def test_counters_above_one_percent_fail_and_every_change_is_reported(
    world: World, propagations: int, code: int, weight: Weight
) -> None:
    verdict = world.gate(fact("mmp", "propagations", propagations))
    assert verdict.exit_code == code
    assert verdict.findings[0].weight == weight and verdict.findings[0].level == 1
    assert f"10000 to {propagations}" in first(verdict)


@pytest.mark.parametrize(
    ("solver", "peak", "code"),
    [
        ("mmp", 10_200_000, GOOD),
        ("mmp", 10_200_001, REGRESSION),
        ("ich", 1_065_536, GOOD),
        ("ich", 1_065_537, REGRESSION),
    ],
)
def test_memory_fails_above_two_percent_and_64_kib(
    world: World, solver: str, peak: int, code: int
) -> None:
    verdict = world.gate(fact(solver, "peak_bytes", peak))
    assert verdict.exit_code == code
    assert [finding.level for finding in verdict.findings] == [3, 3][: 2 * bool(code)]


def test_time_fails_only_above_the_margin(world: World) -> None:
    assert world.gate(fact("mmp", "cpu_ms", 54.0), levels=(4,)).exit_code == GOOD
    verdict = world.gate(fact("mmp", "cpu_ms", 56.0), levels=(4,))
    assert verdict.exit_code == REGRESSION
    assert first(verdict) == (
        "mmp/cube/src:0: 1.120 times as long (median of pairs), again in a second session"
    )


def test_time_needs_a_millisecond(world: World) -> None:
    small = fact("mmp", "cpu_ms", 10.5), fact("mmp", "cpu_ms", 10.0)
    assert world.gate(*small, levels=(4,), margin=1.01).exit_code == GOOD
    grown = fact("mmp", "cpu_ms", 11.5), small[1]
    assert world.gate(*grown, levels=(4,), margin=1.01).exit_code == REGRESSION


def test_rows_that_are_too_short_or_too_long_are_not_timed(world: World) -> None:
    def base(either: dict[str, Any]) -> None:
        fact("mmp", "cpu_ms", pairs.LEAST_MS - 1)(either)
        fact("ich", "cpu_ms", pairs.MOST_MS + 1)(either)

    verdict = world.gate(base, base, levels=(0, 4))
    assert verdict.levels[-1].compared == 0 and verdict.exit_code == GOOD


def sessions(monkeypatch: pytest.MonkeyPatch, *made: pairs.Session) -> None:
    """What the next sessions will have measured."""
    left = list(made)
    monkeypatch.setattr(pairs, "measure", lambda base, head, cell: left.pop(0))


def session(*ratios: float) -> pairs.Session:
    return pairs.Session([100.0] * len(ratios), [100 * ratio for ratio in ratios], 0, "")


SLOW = session(*[1.05, 1.05, *[1.2] * 13])
FAST = session(*[1.05, 1.05, 1.05, *[1.2] * 12])
LOST = pairs.Session([], [], 4, "9% of the time was stolen by the hypervisor")


def test_third_smallest_of_the_ratios_decides() -> None:
    assert SLOW.slower(1.1) and not FAST.slower(1.1)


def only_mmp_on_cube(head: dict[str, Any]) -> None:
    head["meshes"] = ["cube"]
    del head["solvers"]["ich"]


def test_one_slow_session_alone_is_not_red(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    sessions(monkeypatch, SLOW, FAST)
    verdict = world.gate(only_mmp_on_cube, only_mmp_on_cube, levels=(4,))
    assert verdict.exit_code == GOOD and first(verdict).endswith("but not in a second session")


def test_one_slow_session_is_red_when_a_counter_is_up_too(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    def change(head: dict[str, Any]) -> None:
        only_mmp_on_cube(head)
        fact("mmp", "propagations", 10_001)(head)

    sessions(monkeypatch, SLOW)
    verdict = world.gate(change, solvers=("mmp",), levels=(0, 1, 4))
    timed = [f for f in verdict.findings if f.level == 4]
    assert timed[0].weight == Weight.FAILURE and "level 1 is up as well" in timed[0].text


def test_more_memory_does_not_stand_for_a_second_slow_session(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    def change(head: dict[str, Any]) -> None:
        only_mmp_on_cube(head)
        fact("mmp", "peak_bytes", 11_000_000)(head)

    sessions(monkeypatch, SLOW, FAST)
    verdict = world.gate(change, only_mmp_on_cube, levels=(0, 3, 4))
    [timed] = [f for f in verdict.findings if f.level == 4]
    assert timed.weight == Weight.NOTE and timed.text.endswith("but not in a second session")


@pytest.mark.parametrize("measured", [[LOST], [SLOW, LOST]])
def test_disturbed_sessions_are_inconclusive_and_red_only_when_strict(
    world: World, monkeypatch: pytest.MonkeyPatch, measured: list[pairs.Session]
) -> None:
    for strict, code in ((False, GOOD), (True, INCONCLUSIVE)):
        sessions(monkeypatch, *measured)
        verdict = world.gate(only_mmp_on_cube, only_mmp_on_cube, levels=(4,), strict=strict)
        assert verdict.exit_code == code and "stolen" in first(verdict)


def test_noise_above_the_margin_is_inconclusive(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    wild = pairs.Session([100.0, 150.0] * 7 + [100.0], [150.0, 225.0] * 7 + [150.0], 0, "")
    sessions(monkeypatch, wild)
    verdict = world.gate(only_mmp_on_cube, only_mmp_on_cube, levels=(4,))
    assert verdict.exit_code == GOOD and "noise of" in first(verdict)


def test_noise_is_the_spread_of_neighbours() -> None:
    assert pairs.noise([[100.0] * 15]) == 1
    steps = [100.0 * 1.02 ** (i % 2) for i in range(15)]
    assert pairs.noise([steps]) == pytest.approx(1.02**1.4826)


def test_disturbed_pairs_are_measured_again_in_alternating_order(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    verdicts = iter(["busy", "busy", "", *[""] * 14])
    monkeypatch.setattr(machine, "disturbance", lambda before, after: next(verdicts))
    asked: list[str] = []


    def solve_ms(program: Program, cell: Cell, solves: int) -> list[float]:
        asked.append(program.name)
        return [1.0] * solves

    monkeypatch.setattr(Program, "solve_ms", solve_ms)
    base, head = world.program("base"), world.program("head")
    measured = pairs.measure(base, head, Cell("mmp", "cube", 0))
    assert measured.redone == 2 and len(measured.ratios) == pairs.PAIRS
    assert asked[:10] == ["base", "head"] * 3 + ["head", "base", "base", "head"]
    monkeypatch.setattr(machine, "disturbance", lambda before, after: "busy")
    assert pairs.measure(base, head, Cell("mmp", "cube", 0)).disturbed == "busy"


def test_processes_are_timed_without_their_first_solve(tmp_path: Path) -> None:
    def slow_start(base: dict[str, Any]) -> None:
        base["solvers"]["mmp"]["cpu_ms"] = [90.0, 52.0, 51.0, 53.0]

    program = World(tmp_path).program("base", slow_start)
    assert pairs._time(program, Cell("mmp", "cube", 0)) == pytest.approx(51.0)


def test_stolen_time_and_switches_disturb() -> None:
    quiet = machine.Moment(0, 0, 0, 0.0)
    assert machine.disturbance(quiet, machine.Moment(2, 200, 10, 1.0)) == ""
    assert "stolen" in machine.disturbance(quiet, machine.Moment(3, 200, 10, 1.0))
    assert "switches" in machine.disturbance(quiet, machine.Moment(0, 200, 501, 1.0))


def counts(monkeypatch: pytest.MonkeyPatch, head: int) -> None:
    """Callgrind's answers: 1,000,000 for the base."""
    monkeypatch.setattr("shutil.which", lambda name: name)
    monkeypatch.setattr(levels, "CALLGRIND_MESHES", ("cube",))
    of = {"base": 1_000_000, "head": head}
    monkeypatch.setattr(Program, "instructions", lambda self, cell: of[self.name])


@pytest.mark.parametrize(
    ("count", "code", "weights"),
    [
        (1_004_999, GOOD, []),
        (1_005_001, GOOD, [Weight.WARNING] * 2),
        (1_019_999, GOOD, [Weight.WARNING] * 2),
        (1_020_001, REGRESSION, [Weight.FAILURE] * 2),
        (900_000, GOOD, []),
    ],
)
def test_instructions_warn_above_half_a_percent_and_fail_above_two(
    world: World, monkeypatch: pytest.MonkeyPatch, count: int, code: int, weights: list[Weight]
) -> None:
    counts(monkeypatch, count)
    verdict = world.gate(levels=(0, 2))
    assert verdict.exit_code == code
    assert [finding.weight for finding in verdict.findings] == weights


def test_instructions_of_another_compiler_are_not_comparable(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    counts(monkeypatch, 9_000_000)
    verdict = world.gate(lambda head: head.update(compiler="Clang 14"), levels=(0, 2))
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


def test_renamed_solver_is_an_error_that_says_so(world: World) -> None:
    def rename(head: dict[str, Any]) -> None:
        head["solvers"]["better"] = head["solvers"].pop("ich")

    verdict = world.gate(rename)
    assert verdict.exit_code == ERROR
    texts = [finding.text for finding in verdict.findings]
    assert texts[0].startswith("ich: in the baseline and not in the head: removed, or renamed?")
    assert any("better: only in the head, new" in text for text in texts)
    assert any("ich: only in the base, removed or renamed" in text for text in texts)


def test_new_solver_is_good_and_warned_about_until_the_baseline_has_it(world: World) -> None:
    new = fact("mmp", "propagations", 10_000)

    def add(head: dict[str, Any]) -> None:
        new(head)
        head["solvers"]["newest"] = dict(head["solvers"]["mmp"])

    verdict = world.gate(add, levels=(0, 1, 3))
    assert verdict.exit_code == GOOD
    assert first(verdict).startswith("not in the baseline yet, so not judged: newest on cube")
    world.keep_baseline(add)
    assert first(world.gate(add)) == "newest: only in the head, new: nothing to compare with"


def test_removed_mesh_is_an_error_that_says_so(world: World) -> None:
    verdict = world.gate(lambda head: head.update(meshes=["cube"]))
    assert verdict.exit_code == ERROR
    assert first(verdict).startswith("hill: in the baseline and no mesh of the suite any more")


def test_comparing_nothing_is_an_error(world: World) -> None:
    crashed = fact("mmp", "outcome", "unsupported")
    with pytest.raises(GateError, match="no row was compared"):
        world.gate(crashed, crashed, solvers=("mmp",), levels=(0, 3))


def test_unknown_solver_lists_the_known_ones(world: World) -> None:
    with pytest.raises(GateError, match="the head has no solver mpm; there are mmp, ich"):
        world.gate(solvers=("mpm",))


def test_a_solver_that_runs_by_name_only_is_judged_when_it_is_asked_for(world: World) -> None:
    def with_wrong_variant(one: dict[str, Any]) -> None:
        one["solvers"]["variant"] = one["solvers"]["mmp"] | {"outcome": "wrong answer"}
        one["by_name_only"] = ["variant"]

    assert world.gate(with_wrong_variant, with_wrong_variant).exit_code == GOOD
    named = world.gate(with_wrong_variant, with_wrong_variant, solvers=("variant", "mmp"))
    assert named.exit_code == WRONG and "variant" in first(named)


def test_reports_say_the_verdict_first_and_hold_every_level(world: World) -> None:
    verdict = world.gate(fact("mmp", "peak_bytes", 20_000_000))
    text = as_markdown(verdict)
    assert text.startswith("## REGRESSION: head against base\n\n- level 3 **FAILED**: mmp/cube")
    assert "| mmp/cube/src:0 | 10000000 | 20000000 | +100.00% |" in text
    data = json.loads(as_json(verdict))
    assert data["exit_code"] == REGRESSION and [x["level"] for x in data["levels"]] == [0, 1, 3]


def test_a_build_against_itself_reports_its_noise_and_keeps_it(
    world: World, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    steps = [100.0 * 1.02 ** (i % 2) for i in range(pairs.PAIRS)]
    noisy = pairs.Session(steps, steps, 0, "")
    monkeypatch.setattr(noise, "measure", lambda base, head, cell: noisy)
    kept = tmp_path / "noise.json"
    options = replace(world.options, noise_file=kept)
    verdict = check.against_itself(world.program("head"), 2, options)
    assert verdict.exit_code == GOOD and verdict.levels[0].compared == 4
    assert verdict.levels[0].table[0][2] == "3.0%" and verdict.levels[0].table[0][5] == "0 of 2"
    cells = [Cell("mmp", "cube", 0)]
    noise.check_margin(kept, "fake", cells, 1.03)
    noise.check_margin(kept, "another processor", cells, 1.01)
    with pytest.raises(GateError, match="below this machine's noise of mmp/cube/src:0, 1.030"):
        noise.check_margin(kept, "fake", cells, 1.02)

    monkeypatch.setattr(noise, "measure", lambda base, head, cell: SLOW)
    verdict = check.against_itself(world.program("head"), 2, options)
    assert verdict.exit_code == REGRESSION and first(verdict).endswith("red against itself")
