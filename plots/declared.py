"""Cells without a time that are no failures: what a solver declares, a suite expects, or a run leaves
out for a stated reason. Many cells have one reason, and are told in one line."""

from __future__ import annotations

from collections.abc import Iterator

from results.reader import Row, Run, Source

ALLOWED = ("unsupported", "skipped")
FEW = 4
"""Meshes that are named; more are counted."""


def is_allowed(run: Run, row: Row) -> bool:
    """@param row one without a time"""
    expected: dict[str, str] = run.ours.get("expected", {})
    return row.outcome in ALLOWED or row.outcome == expected.get(f"{row.solver}/{row.mesh}")


def allowed(run: Run) -> list[Row]:
    """Rows without a time that are no failures."""
    return [row for row in run.without_a_time if is_allowed(run, row)]


def reasons(run: Run) -> dict[tuple[str, str], str]:
    """A line for each solver and outcome: on which meshes, and the first of the reasons."""
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
