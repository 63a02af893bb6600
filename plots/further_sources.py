"""Many sources, one after the other, by one object of each solver: times with preparation, and errors."""

from __future__ import annotations

from dataclasses import dataclass

from plots.measures import ERROR, columns, count
from plots.ratios import fastest_exact, number
from results.pairs import preparation
from results.reader import ResultError, Row, Run
from results.table import BLANK, Field, Table


@dataclass(frozen=True)
class Further:
    """The numbers of a row; times are in seconds."""

    sources: int
    preparation: float
    time: float
    """Mean of a solve for all vertices; `pair_time` is that of a solve that stops at one vertex."""
    pair_time: float
    errors: list[float] | None
    """Mean and largest over all vertices, mean and largest of pairs; None for an exact solver."""
    bytes_a_vertex: float | None

    @property
    def whole(self) -> float:
        """Time of all sources, preparation included."""
        return self.preparation + self.sources * self.time


def further_of(row: Row, vertices: int) -> Further | None:
    """Returns the row's numbers on further sources, or None if it has none."""
    sources, time, pair_time = (row.number(f"further.{key}") for key in ("sources", "time", "pair_time"))
    if sources is None or time is None or pair_time is None:
        return None
    found = [row.number(f"further_errors.{key}") for key in ("mean", "max", "pair_mean", "pair_max")]
    errors = [error for error in found if error is not None]  # all four or none
    peak = row.number("solver_peak_bytes")
    return Further(
        int(sources), preparation(row), 1e-3 * time, 1e-3 * pair_time,
        errors or None, peak / vertices if peak else None,
    )  # fmt: skip


def measured(run: Run) -> dict[str, dict[str, Further]]:
    """Returns the numbers by mesh and solver. @raises ResultError for a run without further sources"""
    by_mesh: dict[str, dict[str, Further]] = {}
    for name, mesh in run.meshes.items():
        for solver in columns(run):
            for row in run.cell(name, solver):  # all repetitions have the same
                if (further := further_of(row, mesh.vertices)) is not None:
                    by_mesh.setdefault(name, {})[solver] = further
    if not by_mesh:
        raise ResultError(f"{run.file}: no solver went on to further sources; run --further-sources 100")
    return by_mesh


def table(run: Run) -> Table:
    """Returns a row per mesh and solver. @raises ResultError for a run without further sources, or if no exact
    solver has them"""
    by_mesh = measured(run)
    base = fastest_exact(run)
    if not run.solvers[base].exact or any(base not in found for found in by_mesh.values()):
        raise ResultError(f"{run.file}: no exact solver has further sources on every mesh")
    return Table(
        name="further_sources",
        title="Many sources, one after the other",
        header=[
            "Mesh", "Solver", "n", "Sources", "Preparation", "Each source", "All of them", "Mean error", "Largest",
            "A pair", "Mean error of pairs", "Largest ", "Bytes a vertex",
        ],
        text_columns=2,
        rows=[
            [Field(mesh), Field(solver), Field(count(run.meshes[mesh].vertices), run.meshes[mesh].vertices),
             *_row(one, found[base])]
            for mesh, found in by_mesh.items() for solver, one in found.items()
        ],
        remarks=[
            f"Times over those of {base} on the mesh: preparation and each source over its mean time of a source, all "
            "sources with the preparation, and a pair (a solve from each source that stops at one random vertex). One "
            "object answers all sources, which are random. Answers that are not exact are compared with exact ones: "
            "relative errors, the mean over sources and vertices, and the largest.",
        ],
    )  # fmt: skip


def _row(one: Further, base: Further) -> list[Field]:
    def ratio(time: float, of: float) -> Field:
        return Field(number(time / of), time / of)

    mean, largest, *of_pairs = (
        [Field(ERROR.show(error), error) for error in one.errors] if one.errors else 4 * [Field("exact", 0)]
    )
    return [
        Field(count(one.sources), one.sources), ratio(one.preparation, base.time),
        ratio(one.time, base.time), ratio(one.whole, base.whole), mean, largest,
        ratio(one.pair_time, base.pair_time), *of_pairs,
        BLANK if one.bytes_a_vertex is None else Field(count(one.bytes_a_vertex), one.bytes_a_vertex),
    ]  # fmt: skip
