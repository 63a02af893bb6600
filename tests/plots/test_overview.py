"""The overview picture. test_figures.py has the tests of every figure."""

from __future__ import annotations

from synthetic import of_solvers

from plots import overview
from results.reader import Run


def test_a_stand_in_is_marked_otherwise_than_a_model_of_the_thesis(golden_run: Run) -> None:
    kinds = {name: overview.kind(mesh) for name, mesh in golden_run.meshes.items()}
    assert kinds == {
        "horse": "the thesis's model", "rocker-arm": "stand-in for one", "flat-grid": "other mesh",
    }  # fmt: skip
    assert len(set(overview.KINDS.values())) == len(kinds)


def test_any_two_solvers_have_one(golden_run: Run) -> None:
    drawn = overview.figure(of_solvers(golden_run, "ich", "mmp"))
    assert [axes.get_xlabel() for axes in drawn.figure.axes] == [
        "time / mmp", "window propagations / window limit"
    ]  # fmt: skip
    drawn = overview.figure(of_solvers(golden_run, "ich", "edge-based"))
    assert [axes.get_xlabel() for axes in drawn.figure.axes] == ["time / edge-based"]
    assert "the run has no solver of the MMP family" in drawn.caption
