"""Time, space and windows of every solver on every mesh; ours and those of the thesis's Table 5.2."""

from __future__ import annotations

from plots.measures import (
    LIMIT, LIMIT_SOLVER, PROPAGATIONS, Measure, columns, count, limit_solver, measures_of,
    our_field, published_field,
)  # fmt: skip
from plots.models import left_out, of_thesis, ordered_meshes, relation, titled
from results import published
from results.reader import Mesh, Run
from results.table import BLANK, Field, Table, without_empty_columns

OURS = (
    "Ours: medians over sources and repetitions; times are CPU times of one solve without "
    "preparation, with 95% bootstrap intervals over sources and repetitions (the CSV has the "
    "interval of every number). Definitions: docs/metrics.md."
)
PUBLISHED = (
    f"Published: {published.citation()}, Table 5.2, measured on {published.machine()}; compare "
    "ratios, not seconds. Its source vertices are not known. A stand-in is another mesh of the "
    "same shape or size: what is published for its model is context only."
)
SPACE = (
    "Space by the thesis's rule is 80 bytes times the window limit for MMP and FWP-MMP and times "
    "the peak wavefront for the others; MB are 10^6 bytes. The window limit is that of MMP."
)


def table(run: Run) -> Table:
    return without_empty_columns(Table(
        name="performance",
        title=titled(run, "Performance of exact geodesic solvers", "Table 5.2"),
        header=["Model", "Measure", *columns(run), "Window limit"],
        text_columns=2,
        rows=[row for mesh in ordered_meshes(run) for row in _block(run, mesh)],
        remarks=[OURS, *([PUBLISHED] if of_thesis(run) else []), SPACE, *left_out(run)],
    ))  # fmt: skip


def _block(run: Run, mesh: Mesh) -> list[list[Field]]:
    """Returns all rows of one mesh. Its name and sizes fill the first column from the top."""
    rows = []
    for measure in measures_of(run, mesh):
        rows.append(_our_row(run, mesh.name, measure))
        if mesh.thesis_model is not None and measure.published is not None:
            for_model = f" for {mesh.thesis_model}" if mesh.stand_in else ""
            rows.append(_published_row(run, mesh.thesis_model, measure, for_model))
    size = [f"V: {count(mesh.vertices)}", f"F: {count(mesh.faces)}"]
    labels = [line for line in [mesh.name, relation(mesh), *size] if line] + [""] * len(rows)
    return [[Field(label, mesh.label), *row] for label, row in zip(labels, rows, strict=False)]


def _our_row(run: Run, mesh: str, measure: Measure) -> list[Field]:
    limit = BLANK
    if measure is PROPAGATIONS and (solver := limit_solver(run, mesh)) in run.solvers:
        limit = our_field(run, mesh, solver, LIMIT)
    fields = [our_field(run, mesh, solver, measure) for solver in columns(run)]
    return [Field(measure.label, note=measure.note), *fields, limit]


def _published_row(run: Run, model: str, measure: Measure, for_model: str) -> list[Field]:
    """@param for_model for example " for lucy" if the mesh is a stand-in; else empty"""

    def field(solver: str, what: Measure) -> Field:
        return published_field(published.measure(model, str(what.published), solver), what)

    limit = field(LIMIT_SOLVER, LIMIT) if measure is PROPAGATIONS else BLANK
    fields = [field(solver, measure) for solver in columns(run)]
    return [Field(f"{measure.label}, published{for_model}"), *fields, limit]
