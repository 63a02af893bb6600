"""Ratios that the thesis's text claims from Table 5.2: by mesh, and by claim."""

from __future__ import annotations

from itertools import pairwise
from statistics import geometric_mean

from plots.measures import ABSENT, columns, failure
from plots.models import groups_of_thesis, left_out, of_thesis, ordered_meshes, titled
from plots.ratios import BY_KEY, RATIOS, Ratio, mean_field, over_meshes
from results import published
from results.published import Claim
from results.reader import Mesh, Run
from results.table import BLANK, Field, Table

OURS = (
    "Ours: geometric means of ratios paired by source and repetition, with 95% bootstrap intervals "
    "over sources and repetitions. Definitions: docs/metrics.md."
)
PUBLISHED = f"Published: computed from the values of {published.citation()}, Table 5.2."


def ratios(run: Run) -> Table:
    rows = []
    for ratio in [ratio for ratio in RATIOS if ratio.is_of(run)]:
        for mesh, following in pairwise([*ordered_meshes(run), None]):
            if mesh is not None:
                rows.append(_our_row(run, mesh, ratio))
                if following is None or following.thesis_model != mesh.thesis_model:
                    rows += _published_rows(run, mesh, ratio)
        rows.append(_mean_row(run, ratio))
    return Table(
        name="ratios",
        title=titled(run, "Ratios of time, space and windows", "Table 5.2"),
        header=["Ratio", "Model", "From", *columns(run)],
        text_columns=3,
        rows=rows,
        remarks=[OURS, *([PUBLISHED] if of_thesis(run) else []), *left_out(run)],
    )


def _our_row(run: Run, mesh: Mesh, ratio: Ratio) -> list[Field]:
    fields = [ratio.field(run, mesh.name, solver) for solver in columns(run)]
    return [Field(ratio.label, note=ratio.note), Field(mesh.label), Field("ours"), *fields]


def _published_rows(run: Run, mesh: Mesh, ratio: Ratio) -> list[list[Field]]:
    """Returns one row, for below the last mesh that is or stands for the model; none if not published."""
    if mesh.thesis_model is None:
        return []
    values = [ratio.published(mesh.thesis_model, solver) for solver in columns(run)]
    if all(value is None for value in values):
        return []
    fields = [Field(ABSENT) if v is None else Field(ratio.show(v), v) for v in values]
    source = "published, context only" if mesh.stand_in else "published"
    return [[Field(ratio.label, note=ratio.note), Field(mesh.thesis_model), Field(source), *fields]]


def _mean_row(run: Run, ratio: Ratio) -> list[Field]:
    means = {s: over_meshes(ratio, run, list(run.meshes), s) for s in columns(run)}
    fields = [mean_field(ratio, mean, s) if mean else Field(ABSENT) for s, mean in means.items()]
    label = Field(ratio.label, note=ratio.note)
    return [label, Field("all meshes"), Field("ours, geometric mean"), *fields]


def claims(run: Run) -> Table:
    """@raises ResultError if no mesh is or stands for a model of the thesis"""
    models = groups_of_thesis(run)
    groups = {words: [mesh.name for mesh in meshes] for words, meshes in models.items()}
    groups["all meshes"] = list(run.meshes)
    listed = "; ".join(
        f"{words}: {', '.join(mesh.label for mesh in meshes) or 'none'}"
        for words, meshes in models.items()
    )
    return Table(
        name="claims",
        title="The thesis's claims about Table 5.2",
        header=[
            "Edge-based ...", "Ratio", "Solver", "Claimed", "In the thesis's table",
            *(head for group in groups for head in (f"Ours, {group}", f"Range, {group}")),
        ],
        text_columns=4,
        rows=[
            row
            for claim in published.claims()
            for row in _claim_rows(run, claim, list(groups.values()))
        ],
        remarks=[
            OURS,
            PUBLISHED,
            "Ranges are over meshes (over sources and repetitions when there is one mesh). All "
            "meshes include those too small for meaningful times. Stand-ins are context: "
            f"they are other meshes than those that the thesis measured. In this run, {listed}.",
        ],
    )  # fmt: skip


def _claim_rows(run: Run, claim: Claim, groups: list[list[str]]) -> list[list[Field]]:
    ratio = BY_KEY[claim.ratio]
    rows: list[list[Field]] = []
    for solver in [solver for solver in claim.solvers if solver in run.solvers]:
        words = f"{claim.claim} ({claim.where})"
        rows.append(
            [
                Field("" if rows else words, words),
                Field(ratio.label, note=ratio.note),
                Field(solver),
                Field(claim.value),
                _published_mean(ratio, solver),
                *(field for meshes in groups for field in _our_mean(run, ratio, solver, meshes)),
            ]
        )
    return rows


def _published_mean(ratio: Ratio, solver: str) -> Field:
    values = [ratio.published(model, solver) for model in published.models()]
    known = [value for value in values if value is not None]
    if not known:
        return Field(ABSENT)
    mean = geometric_mean(known)
    return Field(f"{ratio.show(mean)} ({ratio.range(min(known), max(known))})", mean)


def _our_mean(run: Run, ratio: Ratio, solver: str, meshes: list[str]) -> list[Field]:
    """Returns the mean and its range; or the solver's failure on the first mesh, or "no such mesh"."""
    mean = over_meshes(ratio, run, meshes, solver)
    if mean is None:
        failed = failure(run, meshes[0], solver) if meshes else Field("no such mesh")
        return [failed or Field(ABSENT), BLANK]
    reach = ratio.range(mean.estimate.least, mean.estimate.most)
    return [mean_field(ratio, mean, solver), Field(reach)]
