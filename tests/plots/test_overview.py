"""The overview picture: drawn from the golden run, refused when there is nothing to draw."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from overview import KINDS, draw, kind, paired
from results import ResultError, Run


def test_a_solver_takes_its_own_time(golden_run: Run) -> None:
    mesh = next(iter(golden_run.meshes))
    times = paired(golden_run, mesh, "edge-based", "cpu_time", "edge-based", "cpu_time")
    assert times and set(times) == {1.0}


def test_the_picture_is_a_png(golden_run: Run, tmp_path: Path) -> None:
    file = tmp_path / "overview.png"
    draw(golden_run, file)
    assert file.read_bytes().startswith(b"\x89PNG")


def test_a_stand_in_is_marked_otherwise_than_a_model_of_the_thesis(golden_run: Run) -> None:
    kinds = {name: kind(mesh) for name, mesh in golden_run.meshes.items()}
    assert kinds == {
        "horse": "the thesis's model", "rocker-arm": "stand-in for one", "flat-grid": "other mesh",
    }  # fmt: skip
    assert len({str(style) for style in KINDS.values()}) == len(KINDS)


def test_a_run_without_edge_based_is_refused(golden_run: Run, tmp_path: Path) -> None:
    rows = [row for row in golden_run.rows if row.solver != "edge-based"]
    with pytest.raises(ResultError, match="edge-based"):
        draw(replace(golden_run, rows=rows), tmp_path / "overview.png")
