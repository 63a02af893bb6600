"""Cells of a run without a verified answer: cells that failed or are missing, and cells without a time
that are not failures, because the solver declares, the suite expects or the run states the reason."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from .columns import OK
from .reader import CLOSED_FORM, Row, Run, Source

ALLOWED = ("unsupported", "skipped")
FEW = 4
"""Number of meshes that a line names. Others are only counted."""

MANY = 100
"""Largest number of lines of a kind that are listed."""


def is_allowed(run: Run, row: Row) -> bool:
    """Whether a row without a time is not a failure. @param row a row without a time"""
    expected: dict[str, str] = run.ours.get("expected", {})
    return row.outcome in ALLOWED or row.outcome == expected.get(f"{row.solver}/{row.mesh}")


def allowed(run: Run) -> list[Row]:
    """Returns the rows without a time that are not failures."""
    return [row for row in run.without_a_time if is_allowed(run, row)]


def reasons(run: Run) -> dict[tuple[str, str], str]:
    """Returns a line for each solver and outcome, with the meshes and the first reason."""
    cells: dict[tuple[str, str], dict[tuple[str, Source], str]] = {}
    for solver, outcome, mesh, source, why in _cells(run):
        cells.setdefault((solver, outcome), {}).setdefault((mesh, source), why)
    words = {"unsupported": "unsupported, as declared,", "skipped": "skipped"}
    return {
        (solver, outcome): f"{solver}: {words.get(outcome, f'{outcome}, as expected,')} on "
        f"{_named(list(dict.fromkeys(mesh for mesh, _ in of)), len(of))}: {next(iter(of.values()))}"
        for (solver, outcome), of in cells.items()
    }


def _cells(run: Run) -> Iterator[tuple[str, str, str, Source, str]]:
    for skip in run.skipped:
        if skip.solver is not None:
            for source in run.sources.get(skip.mesh, []):
                yield skip.solver, "skipped", skip.mesh, source, skip.why
    for row in allowed(run):
        yield row.solver, row.outcome, row.mesh, row.source, row.message


def _named(meshes: list[str], cells: int) -> str:
    if len(meshes) == 1:
        return meshes[0]
    named = ", ".join(meshes[:FEW]) + (", ..." if len(meshes) > FEW else "")
    return f"{len(meshes):,} meshes, {cells:,} cells ({named})"


def line(row: Row) -> str:
    return f"{row.cell}: {row.outcome}: {row.message}"


def findings(run: Run) -> list[Row]:
    """Returns the failed rows of solvers of plug-ins and of independent oracles."""
    failed = [row for row in run.without_a_time if row.outcome not in ALLOWED]
    return [row for row in failed if row.solver in run.of_others]


def failures(run: Run, harmless: Sequence[Row] = ()) -> list[str]:
    """Returns one line per failed row or missing cell or shard, without allowed and harmless rows."""
    accepted = {id(row) for row in [*allowed(run), *harmless]}  # the objects of run.without_a_time
    failed = [line(row) for row in run.without_a_time if id(row) not in accepted]
    return failed + missing(run) + parts_missing(run)


def missing(run: Run) -> list[str]:
    """Returns one line per cell that the run lacks."""
    columns = run.columns
    if columns.cells(columns.has("solver")) == len(run.solvers) * sum(map(len, run.sources.values())):
        return []
    there = {(row.solver, row.mesh, row.source) for row in run.rows}
    return [
        f"{solver}/{mesh}/src:{source}: missing: the run has no row for this cell"
        for mesh in run.meshes
        for solver in run.solvers
        for source in run.sources.get(mesh, [])
        if (solver, mesh, source) not in there and run.skip(mesh, solver) is None
    ]


def parts_missing(run: Run) -> list[str]:
    """Returns one line per shard that a merged run lacks."""
    shards = run.ours.get("missing_shards", [])
    of = len(shards) + len(run.ours.get("parts", []))
    return [f"shard {shard}/{of}: missing: it was not merged" for shard in shards]


def skipped(run: Run) -> list[str]:
    """Returns one line per mesh that was skipped with all solvers."""
    return [f"{skip.mesh}: {skip.why}" for skip in run.not_measured]


def largest_errors(run: Run) -> list[str]:
    """Returns the largest relative errors of each exact solver: one line for errors against closed
    forms, which are the truth, and one against other solvers, with the reference and the cell."""
    lines = []
    columns = run.columns
    errors = columns.numbers("max_relative_error")
    against_truth = columns.where("reference", CLOSED_FORM)
    for solver in run.solvers.values():
        for of in (against_truth, ~against_truth):
            rows = np.flatnonzero(of & columns.where("solver", solver.name) & ~np.isnan(errors))
            if len(rows) and solver.exact:
                row = run.row(int(rows[np.argmax(errors[rows])]))
                error, where = errors[rows].max(), f"{row.mesh}, source {row.source}"
                lines.append(f"{solver.name}: {error:.1e} against {row.reference} ({where})")
    return lines


def verified(run: Run) -> int:
    """Returns the number of cells that have a row with outcome ok."""
    return run.columns.cells(run.columns.where("outcome", OK))


def checked_against_truth(run: Run) -> str:
    columns = run.columns
    rows = columns.where("outcome", OK) & columns.where("reference", CLOSED_FORM)
    places = dict.fromkeys(columns.arrays["mesh"][rows].tolist())
    meshes = first([columns.texts["mesh"][place] for place in places])
    named = ", ".join(meshes) or "no mesh of the run has one"
    return f"checked against a closed form: {columns.cells(rows)} cells ({named})"


def first(lines: Sequence[str], many: int = MANY) -> list[str]:
    """Returns at most `many` lines, followed by the number of the other lines if there are more."""
    more = len(lines) - many
    return [*lines[:many], f"and {more} more"] if more > 0 else list(lines)
