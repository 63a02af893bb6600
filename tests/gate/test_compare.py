"""Comparison of two runs, or of two programs of one run: resolved differences, failures and refusals."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import runs
from runs import Data, of_programs, run, separate

from gate import compare as command
from gate.compare import Comparison, compare, compare_programs, exceeded, parse_limits, summary
from gate.findings import GateError

LIMITS = parse_limits("time=10%,counters=1%,memory=2%")


def separate_runs(old: Data, new: Data, revision: str = 40 * "a") -> Comparison:
    """@param revision revision of the new run"""
    new["context"]["geodesic_bench"]["revision"] = revision
    return compare(run(old, "old.json"), run(new, "new.json"))


@pytest.mark.parametrize("seed", range(10))
def test_equals_fail_no_limit(seed: int) -> None:
    pairs = compare_programs(run(of_programs(1.0, seed=seed)))
    assert exceeded(pairs, LIMITS) == []
    two = separate_runs(separate(1.0, seed=seed), separate(1.0, seed=seed + 100))
    assert exceeded(two, LIMITS) == []


@pytest.mark.parametrize("seed", range(5))
def test_15_percent_is_decided_by_pairs(seed: int) -> None:
    comparison = compare_programs(run(of_programs(1.15, spread=0.02, seed=seed)))
    lines = summary(comparison, LIMITS)
    assert any("FAILED: mmp: time 1.1" in line and "over 3 cells" in line for line in lines)


def test_what_pairs_do_not_decide_is_named_with_its_interval() -> None:
    comparison = compare_programs(run(of_programs(1.1, spread=0.05)))
    lines = summary(comparison, LIMITS)
    assert any(line.startswith("NOT RESOLVED: mmp/") and "--repetitions" in line for line in lines)


def test_a_cell_of_two_separate_runs_never_fails_on_time_and_a_mean_may() -> None:
    """A drift on one mesh is no regression. A drift on all meshes may be one."""
    old, new = separate(1.0), separate(1.0, seed=1)
    for row in new["benchmarks"]:
        row["cpu_time"] *= 2 if row["mesh"] == "horse" else 1
    comparison = separate_runs(old, new)
    assert comparison.cells[0].resolved and exceeded(comparison, LIMITS) == []
    assert "two separate runs" in comparison.notes[0]
    failures = exceeded(separate_runs(old, separate(1.3, seed=1)), LIMITS)
    assert failures[0].startswith("mmp: time 1.") and failures[0].endswith("over 3 cells")


def test_the_mean_of_two_runs_of_one_program_is_called_a_drift_of_the_machine() -> None:
    old = separate(1.0)
    same, other = (
        separate_runs(old, separate(1.3, seed=1), revision)
        for revision in (old["context"]["geodesic_bench"]["revision"], 40 * "a")
    )
    assert same.means[-1][2].excludes_one and exceeded(other, LIMITS) and not exceeded(same, LIMITS)
    for comparison, end, note in ((same, "not resolved (~)", command.ONE_PROGRAM), (other, "]", command.SEPARATE)):
        (mean,) = [line for line in summary(comparison, {}) if line.startswith("all: time new/old 1.")]
        assert mean.endswith(end) and note in comparison.notes


def test_few_repetitions_resolve_nothing_and_a_note_says_so() -> None:
    comparison = separate_runs(separate(1.0, count=3), separate(2.0, count=3))
    assert not comparison.cells[0].resolved
    assert "--repetitions 5" in comparison.notes[1]


def first_row(data: Data, **numbers: Any) -> Data:
    data["benchmarks"][0].update(numbers)
    return data


@pytest.mark.parametrize(
    ("key", "value", "limit", "fails"),
    [
        ("window_propagations", 1010, "counters=1%", 0),
        ("window_propagations", 1011, "counters=1%", 1),
        ("window_propagations", 1010, "counters=0%", 1),
        ("window_propagations", 950, "counters=0%", 0),
        ("solver_peak_bytes", 1_065_000, "memory=2%", 0),
        ("solver_peak_bytes", 1_066_000, "memory=2%", 1),
        ("solver_peak_bytes", 1_066_000, "counters=0%", 0),
    ],
)
def test_counters_and_memory_have_limits_of_their_own(
    key: str, value: int, limit: str, fails: int
) -> None:
    comparison = separate_runs(separate(1.0), first_row(separate(1.0), **{key: value}))
    assert len(exceeded(comparison, parse_limits(limit))) == fails


@pytest.mark.parametrize(("outcome", "code"), [("crashed", 3), ("wrong answer", 2)])
def test_a_cell_that_failed_is_shown_and_fails_with_any_limit(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], outcome: str, code: int
) -> None:
    old, new = separate(1.0), separate(1.0)
    new["benchmarks"] = [row for row in new["benchmarks"] if row["mesh"] != "horse"]
    new["benchmarks"].append(runs.failed("mmp", "horse", outcome))
    for name, data in (("old", old), ("new", new)):
        (tmp_path / name).write_text(json.dumps(data))
    files = [str(tmp_path / "old"), str(tmp_path / "new")]
    assert command.main([*files, "--fail-on", "memory=2%", "--format", "markdown"]) == code
    shown = capsys.readouterr().out
    assert f"FAILED: mmp/horse/src:0: was ok, now {outcome}: vertex 7 is off" in shown
    assert f"old ok; new {outcome}: vertex 7 is off" in shown
    assert command.main(files) == (2 if code == 2 else 0)
    assert capsys.readouterr().out.startswith("WRONG: mmp/horse" if code == 2 else "3 cells")


def test_json_has_every_number(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "run.json").write_text(json.dumps(of_programs(1.5)))
    assert command.main([str(tmp_path), "--fail-on=time=10%", "--format=json"]) == 3
    data = json.loads(capsys.readouterr().out)
    assert data["interleaved"] and len(data["cells"]) == 3 and len(data["failures"]) == 5
    assert data["cells"][0]["time"]["pairs"] == 15 and data["cells"][0]["time"]["resolved"]
    assert [mean["of"] for mean in data["overall"]] == ["mmp", "all"]


def test_what_cannot_be_compared_is_an_error() -> None:
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
        compare_programs(run(separate(1.0)))
    for limit in ("time", "time=", "time=x%", "time=-1%", "time=10", "speed=1%"):
        with pytest.raises(GateError, match=limit.split("=")[0]):
            parse_limits(limit)


def test_times_of_different_processors_are_not_compared() -> None:
    new = separate(2.0)
    new["context"]["geodesic_bench"]["processor"] = "another"
    comparison = separate_runs(separate(1.0), new)
    assert comparison.means == [] and comparison.cells[0].time is None
    assert comparison.notes[1] == "times of different processors are not compared"
