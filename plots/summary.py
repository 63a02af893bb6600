"""The compact table of a run: each solver on each mesh, the fastest first."""

from __future__ import annotations

from plots.measures import (
    EDGE_BASED, ERROR, PEAK_BYTES, PROPAGATIONS, TIME, baseline, by_source, columns, failure,
    our_cell, partial_failure, time_unit, values,
)  # fmt: skip
from plots.models import left_out, ordered_meshes
from plots.ratios import Ratio, mean_cell, over_meshes, time_over
from results.reader import Mesh, Run
from results.statistics import median
from results.table import BLANK, Cell, Table, estimate_cell

ALL = "all meshes"


def table(run: Run) -> Table:
    base = baseline(run, EDGE_BASED)
    ratio = time_over(base)
    rows = [row for mesh in ordered_meshes(run) for row in _block(run, mesh, ratio)]
    if len(run.meshes) > 1:
        rows += _means(run, ratio)
    return Table(
        name="summary",
        title="Results",
        header=["Mesh", "Solver", "Time", ratio.label, "Windows", "Memory (MB)", "Largest error"],
        text_columns=2,
        rows=rows,
        remarks=[
            "CPU time of one solve without preparation, window propagations, measured peak memory "
            "of the solver: medians over sources and repetitions. Ratios of times are paired by "
            "source and repetition, with 95% bootstrap intervals; a mean is geometric, over the "
            "meshes that have the ratio.",
            *left_out(run),
        ],
    )


def _block(run: Run, mesh: Mesh, ratio: Ratio) -> list[list[Cell]]:
    samples = {s: by_source(values(run, mesh.name, s, TIME)) for s in columns(run)}
    times = {solver: median(sample) for solver, sample in samples.items() if sample}
    unit = time_unit([time.value for time in times.values()])
    order = sorted(samples, key=lambda s: times[s].value if s in times else float("inf"))
    rows: list[list[Cell]] = []
    for solver in order:
        failed = failure(run, mesh.name, solver)
        if failed or solver not in times:
            cells = [failed or BLANK, BLANK, BLANK, BLANK, BLANK]
        else:
            note = partial_failure(run, mesh.name, solver)
            cells = [
                estimate_cell(times[solver], unit.text(times[solver].value), note),
                ratio.cell(run, mesh.name, solver),
                *(our_cell(run, mesh.name, solver, m) for m in (PROPAGATIONS, PEAK_BYTES, ERROR)),
            ]
        rows.append([Cell("" if rows else mesh.name, mesh.label), _name(run, solver), *cells])
    return rows


def _name(run: Run, solver: str) -> Cell:
    promise = "" if run.solvers[solver].exact else f" ({run.solvers[solver].promise})"
    return Cell(f"{solver}{promise}", solver)


def _means(run: Run, ratio: Ratio) -> list[list[Cell]]:
    means = {s: over_meshes(ratio, run, list(run.meshes), s) for s in columns(run)}
    known = {solver: mean for solver, mean in means.items() if mean}
    rows: list[list[Cell]] = []
    for solver, mean in sorted(known.items(), key=lambda item: item[1].estimate.value):
        cells = [BLANK, mean_cell(ratio, mean, solver), BLANK, BLANK, BLANK]
        rows.append([Cell("" if rows else ALL, ALL), _name(run, solver), *cells])
    return rows
