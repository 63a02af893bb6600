"""The table of many sources, one after the other."""

from __future__ import annotations

from typing import Any

import pytest
from synthetic import mesh, row, run_of, solver

from plots import further_sources
from results.reader import ResultError

EXACT = {"sources": 100, "time": 50.0, "pair_time": 30.0}
FAST = {"sources": 100, "time": 5.0, "pair_time": 6.0}
ERRORS = {"mean": 1e-3, "max": 2e-2, "pair_mean": 2e-3, "pair_max": 1e-2, "reference": "edge-based"}


def rows(**exact: Any) -> list[dict[str, Any]]:
    return [
        row("edge-based", "m", cpu_time=50.0, real_time=50.0, **exact),
        row("graph", "m", cpu_time=5.0, real_time=5.0, prepare_time=200.0, solver_peak_bytes=60_000,
            further=FAST, further_errors=ERRORS),
        row("graph", "m", source=7, cpu_time=5.0, real_time=5.0),
    ]  # fmt: skip


SOLVERS = [solver("edge-based"), solver("graph", "upper_bound")]


def test_times_are_over_those_of_the_exact_solver_and_include_the_preparation_once() -> None:
    table = further_sources.table(run_of(SOLVERS, [mesh("m", 100)], rows(further=EXACT)))
    exact, fast = ([cell.value if cell.value is not None else cell.text for cell in line] for line in table.rows)
    assert exact[1:8] == ["edge-based", 100, 100, 0, 1, 1, 0]
    assert fast[1] == "graph"
    assert fast[3:] == pytest.approx([100, 4, 0.1, 0.14, 1e-3, 2e-2, 0.2, 2e-3, 1e-2, 600])


def test_without_an_exact_solver_there_is_nothing_to_compare_with() -> None:
    with pytest.raises(ResultError, match="no exact solver has further sources"):
        further_sources.table(run_of(SOLVERS, [mesh("m", 100)], rows()))
