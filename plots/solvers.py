"""Descriptions of the run's solvers, and what the thesis prints about its own in Table 5.3."""

from __future__ import annotations

import re

from plots.measures import ABSENT, columns
from plots.models import titled
from results import published
from results.reader import Run, Solver
from results.table import Field, Table

HEADER = [
    "Solver", "Family", "Distances", "Data structure", "Time", "Space", "Propagation",
    "Spatial order", "Paper", "Remarks",
]  # fmt: skip
REMARKS = [
    f"From data structure to spatial order: as published, {published.citation()}, Table 5.3. "
    "All else: each solver's description in the run file."
]


def table(run: Run) -> Table:
    return Table(
        name="solvers",
        title=titled(run, "Exact geodesic solvers compared", "Table 5.3"),
        header=HEADER,
        text_columns=len(HEADER),
        rows=[_row(run.solvers[name]) for name in columns(run)],
        remarks=REMARKS,
    )


def _row(solver: Solver) -> list[Field]:
    return [
        Field(solver.name, solver.name), Field(solver.family), Field(solver.promise),
        *_published(solver.name), Field(solver.paper), Field(solver.remarks),
    ]  # fmt: skip


def _published(name: str) -> list[Field]:
    row = published.table_5_3().get(name)
    if row is None:
        return [Field(ABSENT)] * 5
    return [
        Field(row["data_structure"]),
        _complexity(row["time_complexity"]),
        _complexity(row["space_complexity"]),
        Field(row["propagation"]),
        _yes_or_no(row["spatial_order"]),
    ]


def _yes_or_no(value: bool) -> Field:
    return Field("yes" if value else "no")


def _complexity(text: str) -> Field:
    """Returns a field with a complexity such as O(n^2 log n) as mathematics in LaTeX, other text as text."""
    if not re.fullmatch(r"O\([\w^+ ]+\)", text):
        return Field(text)
    return Field(text, latex=f"${text.replace('log', chr(92) + 'log')}$")
