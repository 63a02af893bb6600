"""Table 5.2: time, space and windows of every solver on every mesh; ours and published."""

from __future__ import annotations


from results import published
from plots.measures import (
    LIMIT, LIMIT_SOLVER, MEASURES, PROPAGATIONS, Measure, columns, count, our_cell,
    published_cell,
)  # fmt: skip
from plots.models import Model, left_out, models
from results.reader import Run
from results.table import BLANK, Cell, Table

REMARKS = [
    "Ours: medians over sources and repetitions; times are CPU times of one solve without "
    "preparation, with 95% bootstrap intervals over sources and repetitions (the CSV has the "
    "interval of every number). Definitions: docs/metrics.md.",
    f"Published: {published.citation()}, Table 5.2, measured on {published.machine()}; compare "
    "ratios, not seconds. Its source vertices are not known. A stand-in is another mesh of the "
    "same shape or size: what is published for its model is context, not a value to meet.",
    "Space by the thesis's rule is 80 bytes times the window limit for MMP and FWP-MMP and times "
    "the peak wavefront for the others; MB are 10^6 bytes. The window limit is that of MMP.",
]


def tables(run: Run) -> list[Table]:
    return [
        Table(
            name="table_5_2",
            title="Table 5.2: performance of exact geodesic solvers",
            header=["Model", "Measure", *columns(run), "Window limit"],
            text_columns=2,
            rows=[row for model in models(run) for row in _block(run, model)],
            remarks=REMARKS + left_out(run),
        )
    ]


def _block(run: Run, model: Model) -> list[list[Cell]]:
    """All rows of one model, with its name and size down the first column."""
    rows = []
    for measure in MEASURES:
        if model.mesh is not None:
            rows.append(_our_row(run, model.mesh.name, measure))
        if model.thesis is not None and measure.published is not None:
            of = f" for {model.thesis}" if model.is_stand_in else ""
            rows.append(_published_row(run, model.thesis, measure, of))
    labels = _labels(model) + [""] * len(rows)
    return [
        [Cell(label, model.label), *row] for label, row in zip(labels, rows, strict=False)
    ]


def _labels(model: Model) -> list[str]:
    if model.mesh is not None:
        vertices, faces = model.mesh.vertices, model.mesh.faces
    else:
        row = published.table_5_2(str(model.thesis))
        vertices, faces = row["vertices"], row["faces"]
    lines = [model.name, model.relation, f"V: {count(vertices)}", f"F: {count(faces)}"]
    return [line for line in lines if line]


def _our_row(run: Run, mesh: str, measure: Measure) -> list[Cell]:
    limit = our_cell(run, mesh, LIMIT_SOLVER, LIMIT) if measure is PROPAGATIONS else BLANK
    cells = [our_cell(run, mesh, solver, measure) for solver in columns(run)]
    return [Cell(measure.label, note=measure.note), *cells, limit]


def _published_row(run: Run, model: str, measure: Measure, of: str) -> list[Cell]:
    """@param of what the numbers were measured on, when that is not the mesh above"""

    def cell(solver: str, name: str | None) -> Cell:
        return published_cell(published.measure(model, str(name), solver), measure.show)

    limit = cell(LIMIT_SOLVER, LIMIT.published) if measure is PROPAGATIONS else BLANK
    cells = [cell(solver, measure.published) for solver in columns(run)]
    return [Cell(f"{measure.label}, published{of}"), *cells, limit]
