"""The overview picture (test_figures.py has what holds for every figure)."""

from __future__ import annotations

from dataclasses import replace

from plots import overview
import pytest
from results.reader import ResultError, Run


def test_a_solver_takes_its_own_time(golden_run: Run) -> None:
    times = overview.RATIOS[0][0].measured(golden_run, "horse", "edge-based")
    assert {ratio for source in times for ratio in source} == {1.0}


def test_a_stand_in_is_marked_otherwise_than_a_model_of_the_thesis(golden_run: Run) -> None:
    kinds = {name: overview.kind(mesh) for name, mesh in golden_run.meshes.items()}
    assert kinds == {
        "horse": "the thesis's model", "rocker-arm": "stand-in for one", "flat-grid": "other mesh",
    }  # fmt: skip
    assert len(set(overview.KINDS.values())) == len(kinds)


def test_a_run_without_edge_based_is_refused(golden_run: Run) -> None:
    rows = [row for row in golden_run.rows if row.solver != "edge-based"]
    with pytest.raises(ResultError, match="edge-based"):
        overview.figures(replace(golden_run, rows=rows))
