"""Strip depth log_b n of the edge-based solver, and b; ours and those of the thesis's Table 5.1."""

from __future__ import annotations

from plots.measures import EDGE_BASED, Measure, count, our_field
from plots.models import left_out, of_thesis, ordered_meshes, relation, titled
from results import published
from results.reader import Mesh, ResultError, Run
from results.table import BLANK, Field, Table, without_empty_columns

DEPTH = Measure("strip_depth", "log_b n", count, spread=True)
BASE = Measure("strip_b", "b", lambda value: f"{value:.4f}", spread=True)
OURS = (
    "log_b n is the strip depth: the longest chain of faces that a window is propagated across, "
    "from its source or pseudo-source. n is the number of vertices and b = n^(1 / log_b n). "
    "Medians over sources with 95% bootstrap intervals."
)
PUBLISHED = (
    f"Published: {published.citation()}, Table 5.1; its source vertices are not known. A stand-in "
    "is another mesh of the same shape or size: the published values beside it are context."
)


def table(run: Run) -> Table:
    """@raises ResultError if the edge-based solver was not run"""
    if EDGE_BASED not in run.solvers:
        raise ResultError(f"{run.file}: no {EDGE_BASED}, whose window tree this table measures")
    return without_empty_columns(Table(
        name="strip_depth",
        title=titled(run, "Depth of the window tree of the edge-based solver", "Table 5.1"),
        header=[
            "Model", "Relation", "n", "log_b n", "b",
            "n, published", "log_b n, published", "b, published",
        ],
        text_columns=2,
        rows=[_row(run, mesh) for mesh in ordered_meshes(run)],
        remarks=[OURS, *([PUBLISHED] if of_thesis(run) else []), *left_out(run)],
    ))  # fmt: skip


def _row(run: Run, mesh: Mesh) -> list[Field]:
    ours = [our_field(run, mesh.name, EDGE_BASED, measure) for measure in (DEPTH, BASE)]
    size = Field(count(mesh.vertices), mesh.vertices)
    return [Field(mesh.name), Field(relation(mesh)), size, *ours, *_published(mesh.thesis_model)]


def _published(model: str | None) -> list[Field]:
    if model is None:
        return [BLANK, BLANK, BLANK]
    row = published.table_5_1(model)
    n, depth, b = row["vertices"], row["log_b_n"], row["b"]
    return [Field(count(n), n), Field(count(depth), depth), Field(BASE.show(b), b)]
