"""Twins: our implementation of an algorithm and a public code of the same algorithm."""

from __future__ import annotations

from dataclasses import replace

from plots.measures import (
    ABSENT, PROPAGATIONS, TIME, Measure, count, interval_field, median_of,
)  # fmt: skip
from plots.models import ordered_meshes
from plots.ratios import Ratio, mean_field, number, over_meshes
from results.reader import ResultError, Run
from results.table import BLANK, Field, Table, estimate_field

TWINS = [
    ("mmp", "libigl-exact"),
    ("mmp", "gc-exact"),
    ("ich", "xin-wang-ich"),
    ("ich", "cgal"),
    ("edge-based", "vtp"),
]
"""Our solver, and a public code of its algorithm: for MMP Kirsanov's code (in libigl, and with repairs
in geometry-central), for ICH those of its authors and of CGAL, for VTP that of its authors."""
ALL = "all meshes"


def table(run: Run) -> Table:
    """@raises ResultError if the run has no pair of twins"""
    return Table(
        name="twins",
        title="Ours and the public codes of the same algorithm",
        header=[
            "Ours", "Public code", "Mesh", "Time / ours", "Windows, ours", "Windows", "/ ours",
        ],
        text_columns=3,
        rows=[row for ours, twin in _pairs(run) for row in _block(run, ours, twin)],
        remarks=[
            "CPU time of a solve without preparation, the public code's over ours, paired by source "
            "and repetition: geometric means with 95% bootstrap intervals. Windows propagated, "
            "where both count them; what is counted may differ (docs/metrics.md).",
        ],
    )


def overall(run: Run) -> Table:
    """Returns a row per pair of twins. @raises ResultError for the reasons of table()"""
    full = table(run)
    rows = []
    for ours, twin in _pairs(run):
        time, windows = _ratios(ours, twin)
        means = [over_meshes(ratio, run, list(run.meshes), twin) for ratio in (time, windows)]
        right = sum(bool(time.measured(run, mesh, twin)) for mesh in run.meshes)
        rows.append([
            Field(ours), Field(twin),
            *(interval_field(m.estimate, number) if m else Field(ABSENT) for m in means),
            Field(f"{right} of {len(run.meshes)}"),
        ])  # fmt: skip
    header = ["Ours", "Public code", "Time / ours", "Windows / ours", "Meshes on which both are right"]
    return replace(full, name="twins_overall", header=header, text_columns=2, rows=rows)


def _pairs(run: Run) -> list[tuple[str, str]]:
    """Returns the run's pairs of twins. @raises ResultError if there is none"""
    if pairs := [pair for pair in TWINS if set(pair) <= set(run.solvers)]:
        return pairs
    codes = ", ".join(twin for _, twin in TWINS)
    raise ResultError(f"{run.file}: no solver of ours beside a public code of its kind ({codes})")


def _ratios(ours: str, twin: str) -> tuple[Ratio, Ratio]:
    """Returns the ratios of times and of windows."""

    def of(measure: Measure) -> Ratio:
        return Ratio("", "", (twin, measure), (ours, measure))

    return of(TIME), of(PROPAGATIONS)


def _block(run: Run, ours: str, twin: str) -> list[list[Field]]:
    time, windows = _ratios(ours, twin)
    rows = []
    for mesh in ordered_meshes(run):
        medians = [median_of(run, mesh.name, s, PROPAGATIONS) for s in (ours, twin)]
        rows.append([
            Field(mesh.name),
            time.field(run, mesh.name, twin),
            *(estimate_field(m, count(m.value)) if m else Field(ABSENT) for m in medians),
            windows.field(run, mesh.name, twin) if all(medians) else Field(ABSENT),
        ])  # fmt: skip
    mean = over_meshes(time, run, list(run.meshes), twin)
    if mean and len(run.meshes) > 1:
        rows.append([Field(ALL), mean_field(time, mean, twin), BLANK, BLANK, BLANK])
    return [
        [Field("" if i else ours, f"{ours} {twin}"), Field("" if i else twin), *row]
        for i, row in enumerate(rows)
    ]
