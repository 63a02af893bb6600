"""The results of a run in four tables: a row per solver, ratios and seconds by mesh, and every solver on
every mesh. All ratios of times are to the fastest exact solver."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from plots.measures import (
    ABSENT, ERROR, PEAK_BYTES, PROPAGATIONS, TIME, TimeUnit, columns, count, errors_of, failure, interval,
    interval_field, median_of, our_field, partial_failure, time_unit, with_promise,
)  # fmt: skip
from plots.models import left_out, ordered_meshes, timed_elsewhere
from plots.ratios import (
    Ratio, fastest_exact, mean, number, over_each_mesh, over_meshes, plain, time_over,
)  # fmt: skip
from results.pairs import Floats
from results.reader import OK, Mesh, ResultError, Run
from results.statistics import Estimate
from results.table import BLANK, Field, Table, decimals, estimate_field

ALL = "all meshes"
PAIRED = (
    "Ratios of times are paired by mesh, source and repetition; a mean is geometric, over the meshes "
    "that have both times, each of which counts once."
)
INTERVALS = "In brackets: 95% bootstrap intervals over sources and repetitions."


def overall(run: Run) -> Table:
    """Returns a table with a row per solver, the fastest first."""
    base = fastest_exact(run)
    of = over_each_mesh(run, base)
    return Table(
        name="summary",
        title="Results over all meshes" if len(run.meshes) > 1 else "Results",
        header=["Solver", time_over(base).label, "Meshes", "Smallest ratio", "Largest ratio", "Verified", "Without a time",
                ERROR.label],
        text_columns=1,
        rows=[
            [_name(run, solver), *_ratios(run, base, solver, of.get(solver)), *_counts(run, solver)]
            for solver in sorted(columns(run), key=lambda s: mean(of[s]) if s in of else np.inf)
        ],
        remarks=[
            f"{PAIRED} In brackets the 95% bootstrap interval; then the meshes with the smallest and the "
            "largest ratio.",
            "The columns Verified and Without a time count cells, each a mesh and a source.",
            *timed_elsewhere(run),
        ],
    )  # fmt: skip


def _name(run: Run, solver: str) -> Field:
    return Field(with_promise(run.solvers[solver]), solver)


def _ratios(run: Run, base: str, solver: str, ratios: Floats | None) -> list[Field]:
    if ratios is None:
        return [BLANK, Field("0", 0), BLANK, BLANK]
    ratio, value = time_over(base), mean(ratios)
    interval = over_meshes(ratio, run, list(run.meshes), solver)
    first = Field(plain(value), value)
    if interval and solver != base:
        first = estimate_field(interval.estimate, ratio.interval(interval.estimate))
    ends = float(min(ratios)), float(max(ratios))
    return [first, Field(f"{len(ratios):,}", len(ratios)), *(Field(plain(end), end) for end in ends)]


def _counts(run: Run, solver: str) -> list[Field]:
    cells = run.columns
    own, ok = cells.where("solver", solver), cells.where("outcome", OK)
    counts = (cells.cells(own & ok), cells.cells(own & ~ok))
    largest = max(errors_of(run, solver).tolist(), default=None)
    error = BLANK if largest is None else Field(ERROR.show(largest), largest)
    return [*(Field(f"{one:,}", one) for one in counts), error]


def by_mesh(run: Run) -> Table:
    """Returns a table of meshes by solvers. @raises ResultError if no solver has a time"""
    base = fastest_exact(run)
    if not base:
        raise ResultError(f"{run.file}: no verified time")
    of = over_each_mesh(run, base)

    def place(solver: str) -> tuple[bool, bool, float]:
        return solver != base, not run.solvers[solver].exact, mean(of[solver]) if solver in of else np.inf

    solvers = sorted(columns(run), key=place)
    means = [_mean(run, base, s, of[s]) if s in of else BLANK for s in solvers[1:]]
    rows = [[Field(ALL), BLANK, BLANK, *means]] if len(run.meshes) > 1 else []
    for mesh in ordered_meshes(run):
        time = median_of(run, mesh.name, base, TIME)
        own = _own(time) if time else _missing(run, mesh, base)
        rows.append([
            Field(mesh.label, mesh.name),
            Field(count(mesh.vertices), mesh.vertices),
            own,
            *(_ratio(run, mesh, time_over(base), solver) for solver in solvers[1:]),
        ])  # fmt: skip
    return Table(
        name="summary_by_mesh",
        title=f"Time over that of {base}",
        header=["Mesh", "Vertices", f"{base}, time", *(_name(run, s).text for s in solvers[1:])],
        text_columns=1,
        rows=rows,
        remarks=[f"CPU time of one solve without preparation. {PAIRED} {INTERVALS}", *timed_elsewhere(run),
                 *left_out(run)],
    )  # fmt: skip


def times(run: Run) -> Table:
    """Returns a table of meshes by solvers in seconds. @raises ResultError if no solver has a time"""
    if not fastest_exact(run):
        raise ResultError(f"{run.file}: no verified time")
    solvers = columns(run)
    return Table(
        name="times",
        title="Time in seconds",
        header=["Mesh", "Vertices", *(_name(run, solver).text for solver in solvers)],
        text_columns=1,
        rows=[
            [
                Field(mesh.label, mesh.name), Field(count(mesh.vertices), mesh.vertices),
                *(_seconds(run, mesh, solver) for solver in solvers),
            ]
            for mesh in ordered_meshes(run)
        ],
        remarks=[
            "CPU time of one solve without preparation: medians over sources and repetitions. "
            f"{INTERVALS}",
            *timed_elsewhere(run),
            *left_out(run),
        ],
    )  # fmt: skip


def _seconds(run: Run, mesh: Mesh, solver: str) -> Field:
    time = median_of(run, mesh.name, solver, TIME)
    if time is None:
        return _missing(run, mesh, solver)
    unit = TimeUnit("s", 1, decimals(time.value, 3))
    return replace(interval_field(time, unit.show), note=partial_failure(run, mesh.name, solver))


def _mean(run: Run, base: str, solver: str, ratios: Floats) -> Field:
    few = f" (on {len(ratios)})" if len(ratios) < len(run.meshes) else ""
    short = number(mean(ratios)) + few
    found = over_meshes(time_over(base), run, list(run.meshes), solver)
    if found is None:
        return Field(short, mean(ratios))
    shown = interval(found.estimate, number)
    return replace(estimate_field(found.estimate, shown + few), title=shown, short=short)


def _own(seconds: Estimate) -> Field:
    short = time_unit([seconds.value]).text(seconds.value)
    return replace(estimate_field(seconds, _time(seconds)), title=_time(seconds), short=short)


def _time(seconds: Estimate) -> str:
    return time_unit([seconds.value]).interval(seconds)


def _missing(run: Run, mesh: Mesh, solver: str) -> Field:
    failed = failure(run, mesh.name, solver) or Field(ABSENT)
    declared = failed.text in ("unsupported", "skipped")
    return Field(ABSENT if declared else failed.text, title=failed.note)


def _ratio(run: Run, mesh: Mesh, ratio: Ratio, solver: str) -> Field:
    time = median_of(run, mesh.name, solver, TIME)
    if time is None:
        return _missing(run, mesh, solver)
    shown, failed = _time(time), partial_failure(run, mesh.name, solver)
    estimate = ratio.mean(run, mesh.name, solver)
    if estimate is None:
        return Field(shown, title=failed)
    words = [shown, f"ratio {ratio.interval(estimate)}", failed]
    return replace(
        interval_field(estimate, number), title="; ".join(filter(None, words)), short=number(estimate.value)
    )


def every(run: Run) -> Table:
    """Returns a table with a row for each solver on each mesh, the fastest first."""
    ratio = time_over(fastest_exact(run))
    return Table(
        name="every_solver",
        title="Every solver on every mesh",
        header=["Mesh", "Solver", "Time", ratio.label, "Windows", "Memory (MB)", "Largest error"],
        text_columns=2,
        rows=[row for mesh in ordered_meshes(run) for row in _block(run, mesh, ratio)],
        remarks=[
            "CPU time of one solve without preparation, window propagations, measured peak memory "
            "of the solver: medians over sources and repetitions. Ratios of times are paired by "
            f"source and repetition. {INTERVALS}",
            *timed_elsewhere(run),
            *left_out(run),
        ],
    )


def _block(run: Run, mesh: Mesh, ratio: Ratio) -> list[list[Field]]:
    solvers = columns(run)
    times = {s: time for s in solvers if (time := median_of(run, mesh.name, s, TIME))}
    unit = time_unit([time.value for time in times.values()])
    rows: list[list[Field]] = []
    for solver in sorted(solvers, key=lambda s: times[s].value if s in times else np.inf):
        failed = failure(run, mesh.name, solver)
        if failed or solver not in times:
            fields = [failed or BLANK, BLANK, BLANK, BLANK, BLANK]
        else:
            note = partial_failure(run, mesh.name, solver)
            fields = [
                estimate_field(times[solver], unit.interval(times[solver]), note),
                ratio.field(run, mesh.name, solver),
                *(our_field(run, mesh.name, solver, m) for m in (PROPAGATIONS, PEAK_BYTES, ERROR)),
            ]
        rows.append([Field("" if rows else mesh.name, mesh.label), _name(run, solver), *fields])
    return rows
