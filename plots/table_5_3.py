"""Table 5.3: the solvers by their own descriptions in the run file; published beside them."""

from __future__ import annotations

import re
from typing import Any

from plots.measures import ABSENT, columns
from results import published
from results.reader import Run, Solver
from results.table import BLANK, Cell, Table

HEADER = [
    "Solver", "From", "Family", "Data structure", "Time", "Space", "Propagation",
    "Spatial order", "Distances", "Paper", "Remarks",
]  # fmt: skip
REMARKS = [
    "Ours: each solver's description in the run file. "
    f"Published: {published.citation()}, Table 5.3."
]


def table(run: Run) -> Table:
    named = published.table_5_3()
    return Table(
        name="table_5_3",
        title="Table 5.3: exact geodesic solvers compared",
        header=HEADER,
        text_columns=len(HEADER),
        rows=[row for name in columns(run) for row in _rows(run.solvers[name], named)],
        remarks=REMARKS,
    )


def _rows(solver: Solver, named: dict[str, Any]) -> list[list[Cell]]:
    name = solver.name
    rows = [[Cell(name, name), Cell("ours"), *_ours(solver)]]
    if name in named:
        rows.append([Cell("", name), Cell("published"), *_published(named[name])])
    return rows


def _ours(solver: Solver) -> list[Cell]:
    return [
        Cell(solver.family),
        Cell(solver.data_structure),
        _complexity(solver.time_complexity),
        _complexity(solver.space_complexity),
        Cell(solver.propagation),
        _yes_or_no(solver.spatial_order),
        Cell(solver.promise),
        Cell(solver.paper),
        Cell(solver.remarks),
    ]


def _published(row: dict[str, Any]) -> list[Cell]:
    return [
        Cell(row["class"]),
        Cell(row["data_structure"]),
        _complexity(row["time_complexity"]),
        _complexity(row["space_complexity"]),
        Cell(row["propagation"]),
        _yes_or_no(row["spatial_order"]),
        Cell(ABSENT),
        Cell(ABSENT),
        BLANK,
    ]


def _yes_or_no(value: bool) -> Cell:
    return Cell("yes" if value else "no")


def _complexity(text: str) -> Cell:
    """O(n^2 log n) is mathematics in LaTeX; any other text stays text."""
    if not re.fullmatch(r"O\([\w^+ ]+\)", text):
        return Cell(text)
    return Cell(text, latex=f"${text.replace('log', chr(92) + 'log')}$")
