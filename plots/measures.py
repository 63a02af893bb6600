"""The measures of Table 5.2, and their values or the failure of one solver on one mesh."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from results import outcomes
from results.pairs import Floats, by_source
from results.published import THESIS_SOLVERS, Published
from results.reader import OK, Mesh, Row, Run, Solver, Source
from results.statistics import Estimate, median
from results.table import Field, decimals, estimate_field

EDGE_BASED = "edge-based"
LIMIT_SOLVER = "mmp"
"""The window limit is the number of windows that this solver leaves on the edges."""

ABSENT = "\N{EM DASH}"
"""Text of a field for which the solver or the thesis has no number."""


@dataclass(frozen=True)
class TimeUnit:
    """A unit and a number of decimals for times that are read together."""

    name: str
    scale: float
    """Number of these units in a second."""
    decimals: int

    def show(self, value: float) -> str:
        """@param value in this unit"""
        return f"{value:,.{self.decimals}f}"

    def text(self, seconds: float) -> str:
        return f"{self.show(self.scale * seconds)} {self.name}"

    def interval(self, seconds: Estimate) -> str:
        """Returns "14.7 [14.5, 15.0] ms"."""
        return f"{interval(seconds, lambda time: self.show(self.scale * time))} {self.name}"


def time_unit(seconds: Sequence[float]) -> TimeUnit:
    """Returns the largest unit in which the least time is at least 0.1, or the greatest at least 100, so
    that the next unit would make it six digits long. The least time has three significant digits."""
    times = [time for time in seconds if time > 0] or [1.0]
    least, greatest = min(times), max(times)
    units = {"s": 1.0, "ms": 1e3, "\N{MICRO SIGN}s": 1e6}
    fits = (n for n, scale in units.items() if scale * least >= 0.1 or scale * greatest >= 100)
    name = next(fits, "\N{MICRO SIGN}s")
    return TimeUnit(name, units[name], min(decimals(units[name] * least, 3), 4))


def interval(estimate: Estimate, show: Callable[[float], str]) -> str:
    return f"{show(estimate.value)} [{show(estimate.low)}, {show(estimate.high)}]"


def interval_field(estimate: Estimate, show: Callable[[float], str]) -> Field:
    return estimate_field(estimate, interval(estimate, show))


def count(value: float) -> str:
    return f"{round(value):,}"


def megabytes(value: float) -> str:
    return f"{value:,.2f}" if value >= 0.1 else f"{value:.2g}"


@dataclass(frozen=True)
class Measure:
    key: str
    """Key of the number in a result row."""
    label: str
    show: Callable[[float], str]
    published: str | None = None
    """Key of the measure in the thesis's Table 5.2; None: not in the table."""
    published_scale: float = 1
    """Factor from the thesis's unit to the label's."""
    scale: float = 1
    """Factor from the row's unit to the label's."""
    spread: bool = False
    """Whether the interval is printed; CSV always has it."""
    largest: bool = False
    """Whether the largest value is shown instead of the median."""
    note: str = ""


COUNTING = "How windows are counted: docs/metrics.md, Counting windows."

TIME = Measure("cpu_time", "Time", str, "time_s", scale=1e-3, spread=True)
WALL_TIME = Measure("real_time", "Wall time", str, scale=1e-3, spread=True)
PREPARATION = Measure("prepare_time", "Preparation", str, scale=1e-3, spread=True)
TIMES = [TIME, WALL_TIME, PREPARATION]
"""In seconds; measures_of gives them a unit for each mesh."""
SPACE = Measure("space_thesis_mb", "Space (MB), the thesis's rule", megabytes, "space_mb")
OUR_SPACE = Measure("space_mb", "Space (MB), our window's size", megabytes)
PEAK_BYTES = Measure("solver_peak_bytes", "Solver's peak (MB), measured", megabytes, scale=1e-6)
RESIDENT = Measure("process_peak_bytes", "Process's peak (MB), measured", megabytes, scale=1e-6)
PROPAGATIONS = Measure(
    "window_propagations", "Window propagations", count, "window_propagations", note=COUNTING
)
REINSERTIONS = Measure("reinsertions", "Re-insertions among them", count)
CREATED = Measure("windows_created", "Windows created, before filtering", count)
VALID = Measure("valid_windows", "Valid windows", count, "valid_windows", note=COUNTING)
PEAK = Measure("peak_wavefront", "Peak wavefront", count, "peak_wavefront")
LIMIT = Measure("window_limit", "Window limit", count, "window_limit")
ERROR = Measure(
    "max_relative_error", "Largest relative error", lambda value: f"{value:.1e}", largest=True
)

COUNTS = [
    SPACE, OUR_SPACE, PEAK_BYTES, RESIDENT, PROPAGATIONS, REINSERTIONS, CREATED, VALID, PEAK, ERROR,
]


def measures_of(run: Run, mesh: Mesh) -> list[Measure]:
    """Returns the rows of Table 5.2 for a mesh; times are in a unit chosen for the mesh."""
    times = [v for s in columns(run) for v in values(run, mesh.name, s, TIME).values()]
    unit = time_unit(times)
    in_unit = [
        replace(
            time, label=f"{time.label} ({unit.name})", show=unit.show,
            scale=time.scale * unit.scale, published_scale=unit.scale,
        )
        for time in TIMES
    ]  # fmt: skip
    return in_unit + COUNTS


def columns(run: Run) -> list[str]:
    """Returns the run's solvers: those of the thesis in its order, then the others."""
    first = [name for name in THESIS_SOLVERS if name in run.solvers]
    return first + [name for name in run.solvers if name not in first]


def measured_solvers(run: Run) -> list[str]:
    """Returns the solvers of columns() with at least one verified cell."""
    cells = run.columns
    verified = {name for (name,) in cells.take(cells.where("outcome", OK)).by_texts("solver")}
    return [solver for solver in columns(run) if solver in verified]


def baseline(run: Run, preferred: str) -> str:
    """Returns the solver that times are compared with: the first exact one with a verified cell, but the
    preferred one if it is such a solver, or if there is none."""
    exact = [solver for solver in measured_solvers(run) if run.solvers[solver].exact]
    return preferred if preferred in exact or not exact else exact[0]


def with_promise(solver: Solver) -> str:
    """Returns the solver's name and, if it is not exact, its promise about the distances."""
    return solver.name if solver.exact else f"{solver.name} ({solver.promise})"


def percent(error: float) -> str:
    """A relative error: 110%, 6.1%, 0.027%, and below that 2e-06."""
    if error < 1e-4:
        return f"{error:.0e}"
    return f"{100 * error:,.0f}%" if error >= 0.995 else f"{100 * error:.2g}%"


def values(run: Run, mesh: str, solver: str, measure: Measure) -> dict[tuple[Source, int], float]:
    """Returns the measure of the rows that have it, in the label's unit, by (source, repetition)."""
    return {
        (row.source, row.repetition): measure.scale * (row.time if measure.key == TIME.key else value)
        for row in run.cell(mesh, solver)
        if (value := row.number(measure.key)) is not None
    }


def median_of(run: Run, mesh: str, solver: str, measure: Measure) -> Estimate | None:
    """Returns the median over sources and repetitions, or None if no row has the measure."""
    sample = by_source(values(run, mesh, solver, measure))
    return median(sample) if sample else None


def errors_of(run: Run, solver: str) -> Floats:
    """Returns the largest relative error of each right answer of the solver."""
    cells = run.columns
    errors = cells.numbers(ERROR.key)[cells.where("solver", solver) & cells.where("outcome", OK)]
    return np.asarray(errors[~np.isnan(errors)])


def limit_solver(run: Run, mesh: str) -> str:
    """Returns the solver whose window limit is used: MMP or, without its limit, another one that counts it."""
    counted = (s for s in [LIMIT_SOLVER, *run.solvers] if values(run, mesh, s, LIMIT))
    return next(counted, LIMIT_SOLVER)


def failure(run: Run, mesh: str, solver: str) -> Field | None:
    """Returns the field to show instead of numbers if no source of the cell is ok, else None."""
    rows = run.cell(mesh, solver)
    if any(row.ok for row in rows):
        return None
    skip = run.skip(mesh, solver)
    if rows and not outcomes.is_allowed(run, rows[0]):
        return Field(rows[0].outcome, note=_failed(rows))
    if rows or (skip and skip.solver):
        outcome = rows[0].outcome if rows else "skipped"
        return Field(outcome, note=outcomes.reasons(run)[solver, outcome])
    return Field("skipped", note=f"{mesh}: {skip.why}") if skip else Field("missing")


def our_field(run: Run, mesh: str, solver: str, measure: Measure) -> Field:
    """Returns the measure over sources and repetitions, or the reason why there is none."""
    failed = failure(run, mesh, solver)
    estimate = median_of(run, mesh, solver, measure)
    if estimate is None:
        return failed or Field(ABSENT)
    note = failed.note if failed else partial_failure(run, mesh, solver)
    if measure.largest:
        return Field(measure.show(estimate.most), estimate.most, note=note)
    shown = interval(estimate, measure.show) if measure.spread else measure.show(estimate.value)
    return estimate_field(estimate, shown, note)


def published_field(value: Published, measure: Measure) -> Field:
    """Returns a value of the thesis in the measure's unit; a time has the digits that the thesis prints."""
    if value is None:
        return Field(ABSENT)
    if isinstance(value, str):
        return Field(value)
    number = measure.published_scale * value
    is_time = measure.published == TIME.published
    return Field(f"{number:,.10g}" if is_time else measure.show(number), number)


def partial_failure(run: Run, mesh: str, solver: str) -> str:
    """Returns a footnote if some sources of the cell are missing or not ok; else empty."""
    rows = run.cell(mesh, solver)
    failed = [row for row in rows if not row.ok]
    if failed:
        return "Without the sources that failed. " + _failed(failed)
    missing = set(run.sources[mesh]) - {row.source for row in rows}
    if missing:
        return f"{solver} on {mesh}: no rows for source {', '.join(sorted(map(str, missing)))}."
    return ""


def _failed(rows: Sequence[Row]) -> str:
    """Returns every distinct message once, with its sources."""
    causes: dict[str, list[Source]] = {}
    for row in rows:
        causes.setdefault(f"{row.outcome}: {row.message}", []).append(row.source)
    listed = "; ".join(
        f"source {', '.join(map(str, dict.fromkeys(sources)))}, {cause}"
        for cause, sources in causes.items()
    )
    return f"{rows[0].solver} on {rows[0].mesh}: {listed}"
