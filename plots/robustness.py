"""Who is right on which case: a matrix of solvers by the meshes on which users of other codes
report failures, and what happened where one is not right."""

from __future__ import annotations

import re
from collections.abc import Sequence

from plots.answers import error_text
from plots.measures import ABSENT, columns
from plots.models import ordered_meshes
from results.reader import Mesh, ResultError, Row, Run
from results.table import BLANK, Cell, Table

RIGHT = "right"
WORDS = {
    "crashed": "crash",
    "time-out": "hang",
    "out of memory": "out of memory",
    "wrong answer": "wrong",
    "error": "refused",
    "unsupported": "unsupported",
}
"""What is shown for an outcome; of several outcomes of a case the first one."""


def matrix(run: Run) -> Table:
    """@raises ResultError when no mesh of the run stands for a report"""
    cases = _cases(run)
    solvers = columns(run)
    return Table(
        name="robustness",
        title="Who is right on which case",
        header=["Case", "Reported of", *solvers],
        text_columns=2 + len(solvers),
        rows=[
            *([_case(mesh), _reports(mesh), *(_cell(run, mesh, s) for s in solvers)]
              for mesh in cases),
            *_totals(run, cases, solvers),
        ],
        remarks=[
            "Cases are meshes made by generators of this project, of the kind that the reports are "
            "about, each from the sources that the manifest names. The right answer is a closed "
            "form or brute force on up to 400 faces. Right: what the solver promises, on all "
            "sources; of one that promises no bound, its largest relative error. Wrong: by the "
            "largest relative error, or how many vertices are reached that must not be, or not "
            "reached. Refused: the solver says why, and gives no distances. Unsupported: as "
            "it declares.",
        ],
    )  # fmt: skip


def failures(run: Run) -> Table:
    """@raises ResultError when no mesh of the run stands for a report, or all is right"""
    rows = [
        [Cell(row.mesh), Cell(row.solver), Cell(str(row.source)), Cell(WORDS[row.outcome]),
         Cell(row.message)]
        for mesh in _cases(run)
        for row in run.rows
        if row.mesh == mesh.name and row.outcome in WORDS and row.outcome != "unsupported"
    ]  # fmt: skip
    if not rows:
        raise ResultError(f"{run.file}: no solver fails on a case")
    return Table(
        name="robustness_failures",
        title="What happened where a solver is not right",
        header=["Case", "Solver", "Source", "Outcome", "Message"],
        text_columns=5,
        rows=rows,
    )


def _cases(run: Run) -> list[Mesh]:
    if not any(mesh.reports for mesh in run.meshes.values()):
        raise ResultError(f"{run.file}: no mesh stands for a report; run --corpus robustness")
    return ordered_meshes(run)


def _case(mesh: Mesh) -> Cell:
    addresses = f" ({', '.join(mesh.reports)})" if mesh.reports else ""
    return Cell(mesh.name, note=f"{mesh.name}: {mesh.why}{addresses}.")


def _reports(mesh: Mesh) -> Cell:
    """libigl 2554 of https://github.com/libigl/libigl/issues/2554"""
    short = (re.sub(r".*/([^/]+)/issues/(\d+)", r"\1 \2", report) for report in mesh.reports)
    return Cell(", ".join(short) or ABSENT)


def _cell(run: Run, mesh: Mesh, solver: str) -> Cell:
    rows = run.cell(mesh.name, solver)
    if not rows:
        return Cell("skipped" if run.skip(mesh.name, solver) else "missing")
    outcomes = {row.outcome for row in rows}
    word = next((WORDS[o] for o in WORDS if o in outcomes), RIGHT)
    if word == "wrong":
        return _wrong([row for row in rows if row.outcome == "wrong answer"])
    error = max((row.numbers.get("max_relative_error", 0) for row in rows), default=0)
    if word == RIGHT and run.solvers[solver].exactness == "unbounded":
        return Cell(f"off {error_text(error)}", error)
    return Cell(word)


def _wrong(rows: Sequence[Row]) -> Cell:
    mismatches = max(int(row.data.get("unreachable_mismatches", 0)) for row in rows)
    if mismatches:
        return Cell(f"wrong: reach of {mismatches:,}")
    error = max(row.data.get("max_relative_error", 0) for row in rows)
    return Cell(f"wrong {error_text(error)}")


def _totals(run: Run, cases: Sequence[Mesh], solvers: Sequence[str]) -> list[list[Cell]]:
    """How many cases have each word, for the words that there are."""
    first = {s: [_cell(run, mesh, s).text.split(" ")[0].rstrip(":") for mesh in cases]
             for s in solvers}  # fmt: skip
    words = [RIGHT, "off", *(word.split(" ")[0] for word in WORDS.values()), "skipped", "missing"]
    names = {word.split(" ")[0]: word for word in WORDS.values()}
    return [
        [Cell(f"{names.get(word, word)}, of {len(cases)}", "total"), BLANK,
         *(Cell(str(first[s].count(word)), first[s].count(word)) for s in solvers)]
        for word in words
        if any(word in first[s] for s in solvers)
    ]  # fmt: skip
