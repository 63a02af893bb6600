"""Outcomes of all solvers on the meshes for which users of other codes report failures: a matrix, the
number of right answers of each solver, and the failures."""

from __future__ import annotations

import re
from collections.abc import Sequence

from plots.measures import ABSENT, ERROR, columns, time_unit
from plots.models import ordered_meshes
from results.pairs import first
from results.reader import Mesh, ResultError, Row, Run
from results.table import Field, Table

RIGHT, OFF, WRONG, IMPRECISE = "right", "off", "wrong", "imprecise"
EXITS, REFUSED = "exits", "refused"
WORDS = [
    "crash", "hang", "out of memory", WRONG, IMPRECISE, EXITS, REFUSED, "unsupported", "skipped",
    OFF, RIGHT,
]
"""From worst to best: of several outcomes of a case, the worst is shown."""
OF_OUTCOME = {"crashed": "crash", "time-out": "hang"}
"""Words for outcomes; other outcomes are their own words."""
MISSING = "missing"
LEAST_WRONG = 1e-6
"""An answer whose largest relative error is smaller is imprecise and not wrong."""


def matrix(run: Run) -> Table:
    """@raises ResultError if no mesh of the run stands for a report"""
    cases = _cases(run)
    solvers = columns(run)
    return Table(
        name="robustness",
        title="Who is right on which case",
        header=["Case", "Reported of", *solvers],
        text_columns=2 + len(solvers),
        rows=[
            [_case(mesh), _reports(mesh), *(_field(run, mesh, s) for s in solvers)]
            for mesh in cases
        ],
        remarks=[
            "Cases are meshes made by generators of this project, of the kind that the reports are "
            "about, each from the sources that the manifest names, and from sets of them in one "
            "query. The right answer is a closed form or brute force on up to 400 faces. Right: the solver "
            "keeps its promise from all sources. Off: the largest relative error of a solver that promises no "
            "bound. Wrong: the largest relative error, or the number of vertices that are reached by mistake "
            f"or not reached. Imprecise: an error below {LEAST_WRONG:.0e}. Refused: the solver gives a reason "
            "and no distances. Exits: it ends the process without a message. Unsupported: the solver declares "
            "it; one for single sources only is judged by these. Of several sources the worst is shown. "
            f"{_limit(run)}",
        ],
    )


def counts(run: Run) -> Table:
    """@raises ResultError if no mesh of the run stands for a report"""
    words = _words(run)
    found = [w for w in [*reversed(WORDS), MISSING] if any(w in of for of in words.values())]
    return Table(
        name="robustness_counts",
        title=f"How often a solver is right, of {len(run.meshes)} cases",
        header=["Solver", "Promise", *(word.capitalize() for word in found)],
        text_columns=2,
        rows=[
            [Field(s), Field(run.solvers[s].promise),
             *(Field(str(of.count(word)), of.count(word)) for word in found)]
            for s, of in words.items()
        ],
    )  # fmt: skip


def right(run: Run) -> dict[str, str]:
    """Returns, by solver, the number of right cases; for a solver without a bound a text like "off on 22"."""
    return {
        solver: f"{OFF} on {of.count(OFF)}"
        if run.solvers[solver].exactness == "unbounded"
        else str(of.count(RIGHT))
        for solver, of in _words(run).items()
    }


def failures(run: Run) -> Table:
    """@raises ResultError if no mesh of the run stands for a report, or no solver fails"""
    rows = [
        [Field(row.mesh), Field(row.solver), Field(str(row.source)), Field(_word(run, row)),
         Field(row.message)]
        for mesh in _cases(run)
        for row in run.rows
        if row.mesh == mesh.name and not row.ok and row.outcome not in ("unsupported", "skipped")
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


def _words(run: Run) -> dict[str, list[str]]:
    """Returns, by solver, the word of each case."""
    cases = _cases(run)
    return {s: [_worst(run, mesh, s)[0] for mesh in cases] for s in columns(run)}


def _limit(run: Run) -> str:
    """Returns the definition of a hang, with the time of the slowest answer."""
    seconds = max((first(row) for row in run.rows if row.ok), default=0)
    return (
        f"Hang: no answer within {run.ours['time_limit']:g} s; the slowest of all answers took "
        f"{time_unit([seconds]).text(seconds)}."
    )


def _case(mesh: Mesh) -> Field:
    addresses = f" ({', '.join(mesh.reports)})" if mesh.reports else ""
    return Field(mesh.name, note=f"{mesh.name}: {mesh.why}{addresses}.")


def _reports(mesh: Mesh) -> Field:
    """Returns short names: "libigl 2554" for https://github.com/libigl/libigl/issues/2554"""
    short = (re.sub(r".*/([^/]+)/issues/(\d+)", r"\1 \2", report) for report in mesh.reports)
    return Field(", ".join(short) or ABSENT)


def _word(run: Run, row: Row) -> str:
    if row.ok:
        return OFF if run.solvers[row.solver].exactness == "unbounded" else RIGHT
    if row.outcome == "wrong answer":
        slight = not _mismatches([row]) and _error([row]) < LEAST_WRONG
        return IMPRECISE if slight else WRONG
    if row.outcome == "error":
        return EXITS if re.fullmatch(r"exit code \d+", row.message) else REFUSED
    return OF_OUTCOME.get(row.outcome, row.outcome)


def _mismatches(rows: Sequence[Row]) -> int:
    return max(int(row.number("unreachable_mismatches") or 0) for row in rows)


def _error(rows: Sequence[Row]) -> float:
    return max((row.number("max_relative_error") or 0.0) for row in rows)


def _worst(run: Run, mesh: Mesh, solver: str) -> tuple[str, list[Row]]:
    """Returns the worst word of a case and the rows with this word. A solver that supports only single
    sources is judged by those."""
    rows = list(run.cell(mesh.name, solver))
    if not rows:
        return "skipped" if run.skip(mesh.name, solver) else MISSING, []
    rows = [
        row for row in rows if isinstance(row.source, int) or row.outcome != "unsupported"
    ] or rows
    words = [_word(run, row) for row in rows]
    worst = min(words, key=WORDS.index)
    return worst, [row for row, word in zip(rows, words, strict=True) if word == worst]


def _field(run: Run, mesh: Mesh, solver: str) -> Field:
    word, rows = _worst(run, mesh, solver)
    if word not in (WRONG, IMPRECISE, OFF):
        return Field(word)
    mismatches = _mismatches(rows)
    by_how_much = f"reach of {mismatches:,}" if mismatches else ERROR.show(_error(rows))
    return Field(f"{word}: {by_how_much}")
