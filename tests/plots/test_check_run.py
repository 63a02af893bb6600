"""The check step: every cell verified, or a list of what is not."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from synthetic import Changed

from gate import check_run


def keep_only_good(data: dict[str, Any]) -> None:
    """Leaves the cells of the horse, all of which are ok or skipped."""
    ours = data["context"]["geodesic_bench"]
    ours["meshes"] = ours["meshes"][:1]
    ours["skipped"] = [skip for skip in ours["skipped"] if skip["solver"]]
    data["benchmarks"] = [row for row in data["benchmarks"] if row["mesh"] == "horse"]


def test_failed_and_missing_cells_fail_and_are_listed(
    golden_folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert check_run.main([str(golden_folder)]) == 1
    printed = capsys.readouterr().out
    assert "FAILED: ich/rocker-arm/src:4711: crashed" in printed
    assert "FAILED: fwp-ch/flat-grid/src:0: wrong answer" in printed
    assert "FAILED: fwp-mmp/rocker-arm/src:7: missing" in printed
    assert "FAILED: ch/" not in printed
    assert "checked against a closed form: 0 cells" in printed
    assert printed.splitlines()[-1] == "cells: 28 verified, 3 failed; meshes not measured: 1"


def test_verified_run_passes(changed: Changed, capsys: pytest.CaptureFixture[str]) -> None:
    assert check_run.main([str(changed(keep_only_good))]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "cells: 12 verified, 0 failed"


@pytest.mark.parametrize(("more", "code"), [({}, 0), ({"unreadable": True}, 1)])
def test_a_mesh_that_was_skipped_is_listed_and_fails_where_it_fails_the_run(
    changed: Changed, capsys: pytest.CaptureFixture[str], more: dict[str, bool], code: int
) -> None:
    def change(data: dict[str, Any]) -> None:
        keep_only_good(data)
        skip = {"mesh": "bunny", "solver": None, "why": "not in the dataset cache"} | more
        data["context"]["geodesic_bench"]["skipped"].append(skip)

    assert check_run.main([str(changed(change))]) == code
    printed = capsys.readouterr().out
    assert "NOT MEASURED: bunny: not in the dataset cache" in printed
    assert "without a time: ch: skipped on horse: ch is for meshes of at most 20000 vertices" in printed


@pytest.mark.parametrize("oracle", [False, True])
def test_what_a_solver_of_others_fails_at_may_be_a_finding(
    changed: Changed, capsys: pytest.CaptureFixture[str], oracle: bool
) -> None:
    def change(data: dict[str, Any]) -> None:
        keep_only_good(data)
        ours = data["context"]["geodesic_bench"]
        if oracle:
            next(s for s in ours["solvers"] if s["name"] == "ich")["independent_oracle"] = True
        else:
            ours["plugins"] = [{"file": "/peers/libich.so", "sha256": "0" * 64, "solvers": ["ich"]}]
        row = next(row for row in data["benchmarks"] if row["solver"] == "ich")
        row.update(outcome="crashed", error_occurred=True, error_message="signal 11")

    run = str(changed(change))
    assert [check_run.main([run, *more]) for more in [list[str](), ["--others-may-fail"]]] == [1, 0]
    failed, found = (
        [line.split(": ")[0] for line in capsys.readouterr().out.splitlines() if "crashed" in line]
    )
    assert (failed, found) == ("FAILED", "FOUND")


def test_nothing_verified_is_a_failure(changed: Changed) -> None:
    def change(data: dict[str, Any]) -> None:
        rows = [row for row in data["benchmarks"] if row["outcome"] == "unsupported"]
        data["benchmarks"] = rows[:1]
        ours = data["context"]["geodesic_bench"]
        ours["solvers"] = [s for s in ours["solvers"] if s["name"] == "ch"]
        ours["meshes"] = [m for m in ours["meshes"] if m["name"] == "rocker-arm"]
        ours["sources"] = {"rocker-arm": [rows[0]["source"]]}

    assert check_run.main([str(changed(change))]) == 1


def test_cells_checked_against_truth_are_counted_and_largest_errors_told(
    changed: Changed, capsys: pytest.CaptureFixture[str]
) -> None:
    def change(data: dict[str, Any]) -> None:
        keep_only_good(data)
        for row in data["benchmarks"]:
            if row["solver"] in ("ich", "mmp") and row["source"] == 31415:
                row["reference"] = "closed-form"
                row["max_relative_error"] = 2e-16 / (1 + row["repetition_index"])

    assert check_run.main([str(changed(change)), "--long"]) == 0
    printed = capsys.readouterr().out
    assert "checked against a closed form: 2 cells (horse)" in printed
    assert "ich: 2.0e-16 against closed-form (horse, source 31415)" in printed
    assert "ich: 3.0e-15 against mmp (horse, source 0)" in printed
