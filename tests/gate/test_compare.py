"""Comparison of two runs, or of two programs of one run: what fails, what is only said, and refusals."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import runs
from runs import Data, of_programs, run, separate

from gate import compare as command
from gate.compare import LEVELS, compare, compare_programs
from gate.findings import ERROR, NOT_RESOLVED, REGRESSION, WRONG_ANSWER, GateError, Weight
from gate.verdict import Verdict, as_text


def separate_runs(old: Data, new: Data, revision: str = 40 * "a") -> Verdict:
    """@param revision revision of the new run"""
    new["context"]["geodesic_bench"]["revision"] = revision
    return compare(run(old, "old.json"), run(new, "new.json"), LEVELS, 1.1, strict=False)


def programs(data: Data, strict: bool = False) -> Verdict:
    return compare_programs(run(data), LEVELS, 1.1, strict)


def failures(verdict: Verdict) -> list[str]:
    return [finding.line for finding in verdict.findings if finding.weight == Weight.FAILURE]


@pytest.mark.parametrize("seed", range(10))
def test_equals_do_not_fail(seed: int) -> None:
    assert programs(of_programs(1.0, seed=seed)).exit_code == 0
    assert separate_runs(separate(1.0, seed=seed), separate(1.0, seed=seed + 100)).exit_code == 0


def test_15_percent_is_decided_by_the_pairs_of_one_run() -> None:
    verdict = programs(of_programs(1.15, spread=0.02))
    assert verdict.exit_code == REGRESSION
    assert failures(verdict)[0].startswith("mmp, geometric mean over 3 rows: 1.1")


def test_what_pairs_do_not_decide_is_named_and_has_an_exit_code_when_strict() -> None:
    data = of_programs(1.1, spread=0.05)
    assert "NOT RESOLVED: mmp/" in as_text(programs(data)) and "more --repetitions" in as_text(programs(data))
    assert (programs(data).exit_code, programs(data, strict=True).exit_code) == (0, NOT_RESOLVED)


def test_a_cell_of_two_separate_runs_never_fails_on_time_and_a_mean_may() -> None:
    """A drift on one mesh is no regression. A drift on all meshes may be one."""
    old, new = separate(1.0), separate(1.0, seed=1)
    for row in new["benchmarks"]:
        row["cpu_time"] *= 2 if row["mesh"] == "horse" else 1
    assert separate_runs(old, new).exit_code == 0
    slower = separate_runs(old, separate(1.3, seed=1))
    assert slower.exit_code == REGRESSION and failures(slower)[0].startswith("mmp, geometric mean over 3")
    assert command.SEPARATE in as_text(slower)


def test_the_mean_of_two_runs_of_one_program_is_called_a_drift_of_the_machine() -> None:
    old = separate(1.0)
    revision = old["context"]["geodesic_bench"]["revision"]
    same = separate_runs(old, separate(1.3, seed=1), revision)
    assert same.exit_code == 0 and command.ONE_PROGRAM in as_text(same)
    rows = same.levels[-1].table
    assert len(rows) == 4 and all(row[3].startswith("~ 1.") for row in rows)


def test_few_repetitions_resolve_nothing_and_a_note_says_so() -> None:
    verdict = separate_runs(separate(1.0, count=3), separate(2.0, count=3))
    assert all(row[3].startswith("~") for row in verdict.levels[-1].table[:-1])
    assert "--repetitions 5" in as_text(verdict)


@pytest.mark.parametrize(
    ("key", "value", "code"),
    [
        ("window_propagations", 1010, 0),
        ("window_propagations", 1011, REGRESSION),
        ("window_propagations", 950, 0),
        ("solver_peak_bytes", 1_065_000, 0),
        ("solver_peak_bytes", 1_066_000, REGRESSION),
    ],
)
def test_counters_and_memory_have_the_limits_of_the_gate(key: str, value: int, code: int) -> None:
    new = separate(1.0)
    new["benchmarks"][0][key] = value
    verdict = separate_runs(separate(1.0), new)
    assert verdict.exit_code == code
    assert any(f"mmp/horse/src:0: {words}" in as_text(verdict)
               for words in ("window_propagations", "peak memory")) or code == 0  # fmt: skip


@pytest.mark.parametrize("outcome", ["crashed", "wrong answer"])
def test_a_cell_that_has_no_right_answer_any_more_fails_and_the_report_is_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], outcome: str
) -> None:
    old, new = separate(1.0), separate(1.0)
    new["benchmarks"] = [row for row in new["benchmarks"] if row["mesh"] != "horse"]
    new["benchmarks"].append(runs.failed("mmp", "horse", outcome))
    for name, data in (("old", old), ("new", new)):
        (tmp_path / name).write_text(json.dumps(data))
    words = [str(tmp_path / "old"), str(tmp_path / "new"), "--out", str(tmp_path / "report")]
    assert command.main(words) == WRONG_ANSWER
    shown = capsys.readouterr().out
    assert shown.startswith("WRONG ANSWER: ") and f"mmp/horse/src:0: {outcome}: vertex 7 is off" in shown
    verdict: dict[str, Any] = json.loads((tmp_path / "report" / "verdict.json").read_text())
    assert verdict["exit_code"] == WRONG_ANSWER and len(verdict["levels"]) == 4
    assert (tmp_path / "report" / "verdict.md").read_text().startswith("## WRONG ANSWER: ")


def test_only_the_levels_that_are_named_are_judged() -> None:
    new = separate(2.0, seed=1)
    old = run(separate(1.0), "old.json")
    verdict = compare(old, run(new, "new.json"), (0, 3), 1.1, strict=False)
    assert verdict.exit_code == 0 and [level.level for level in verdict.levels] == [0, 3]


def test_what_cannot_be_compared_is_an_error(capsys: pytest.CaptureFixture[str]) -> None:
    mesh = separate(1.0)
    mesh["context"]["geodesic_bench"]["meshes"][0]["sha256"] = 64 * "f"
    other = separate(1.0)
    for row in other["benchmarks"]:
        row["solver"] = "ich"
    other["context"]["geodesic_bench"]["solvers"][0]["name"] = "ich"
    for new, words in ((mesh, "horse is another file"), (other, "no cell in common")):
        with pytest.raises(GateError, match=words):
            separate_runs(separate(1.0), new)
    with pytest.raises(GateError, match="no programs"):
        programs(separate(1.0))
    for words in ("--margin 1", "--levels 2", "--levels ten"):
        with pytest.raises(SystemExit) as ended:
            command.main(["old", "new", *words.split()])
        assert ended.value.code == ERROR and words.split()[1] in capsys.readouterr().err


def test_times_of_different_processors_are_not_compared() -> None:
    new = separate(2.0)
    new["context"]["geodesic_bench"]["processor"] = "another"
    verdict = separate_runs(separate(1.0), new)
    assert verdict.exit_code == 0 and "one processor" in verdict.levels[-1].skipped
