"""What Table 5.2 measures, and how one solver fared on one mesh."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from results.statistics import Estimate, median
from results.published import THESIS_SOLVERS, Published
from results.reader import Row, Run
from results.table import Cell, estimate_cell

EDGE_BASED = "edge-based"
LIMIT_SOLVER = "mmp"
"""The window limit is what this solver leaves on the edges."""

ABSENT = "\N{EM DASH}"
"""Shown where a solver has no such number, or the thesis prints none."""


def seconds(value: float) -> str:
    """At least three significant digits, and no more than a clock can mean."""
    return f"{value:,.3f}" if value >= 0.1 else f"{value:#.3g}"


def interval(estimate: Estimate, show: Callable[[float], str]) -> str:
    return f"{show(estimate.value)} [{show(estimate.low)}, {show(estimate.high)}]"


def count(value: float) -> str:
    return f"{round(value):,}"


def megabytes(value: float) -> str:
    return f"{value:,.2f}" if value >= 0.1 else f"{value:.2g}"


@dataclass(frozen=True)
class Measure:
    key: str
    """Of the number in a result row."""
    label: str
    show: Callable[[float], str]
    published: str | None = None
    """Of the measure in the thesis's Table 5.2."""
    scale: float = 1
    """From the row's unit to the label's."""
    spread: bool = False
    """Whether the interval is printed; CSV always has it."""
    largest: bool = False
    """Whether the largest value is shown, and not the median."""
    note: str = ""


COUNTING = "How windows are counted may differ from the thesis: docs/metrics.md, Counting windows."

TIME = Measure("cpu_time", "Time (s)", seconds, "time_s", 1e-3, True)
WALL_TIME = Measure("real_time", "Wall time (s)", seconds, None, 1e-3, True)
PREPARATION = Measure("prepare_time", "Preparation (s)", seconds, None, 1e-3)
SPACE = Measure("space_thesis_mb", "Space (MB), the thesis's rule", megabytes, "space_mb")
OUR_SPACE = Measure("space_mb", "Space (MB), our window's size", megabytes)
PEAK_BYTES = Measure("solver_peak_bytes", "Solver's peak (MB), measured", megabytes, None, 1e-6)
RESIDENT = Measure("process_peak_bytes", "Process's peak (MB), measured", megabytes, None, 1e-6)
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

MEASURES = [
    TIME, WALL_TIME, PREPARATION, SPACE, OUR_SPACE, PEAK_BYTES, RESIDENT, PROPAGATIONS,
    REINSERTIONS, CREATED, VALID, PEAK, ERROR,
]  # fmt: skip


def columns(run: Run) -> list[str]:
    """The thesis's solvers in its order, in the run or not, then the run's others."""
    return THESIS_SOLVERS + [name for name in run.solvers if name not in THESIS_SOLVERS]


def values(run: Run, mesh: str, solver: str, measure: Measure) -> dict[tuple[int, int], float]:
    """The measure by (source, repetition), in the label's unit, where the cell is ok and has it."""
    return {
        (row.source, row.repetition): row.numbers[measure.key] * measure.scale
        for row in run.cell(mesh, solver)
        if measure.key in row.numbers
    }


def by_source(numbers: dict[tuple[int, int], float]) -> list[list[float]]:
    """The same as a sample: a list a source, of its repetitions."""
    groups: dict[int, list[float]] = {}
    for (source, _), number in numbers.items():
        groups.setdefault(source, []).append(number)
    return list(groups.values())


def failure(run: Run, mesh: str, solver: str) -> Cell | None:
    """What to show instead of numbers when no source of the cell is ok."""
    rows = run.cell(mesh, solver)
    if any(row.ok for row in rows):
        return None
    if rows:
        return Cell(rows[0].outcome, note=_failed(rows))
    skip = run.skip(mesh, solver)
    if skip is not None:
        return Cell("skipped", note=f"Skipped, {solver} on {mesh}: {skip.why}")
    return Cell("missing" if solver in run.solvers else "not run")


def our_cell(run: Run, mesh: str, solver: str, measure: Measure) -> Cell:
    """The measure over sources and repetitions, or why there is none."""
    failed = failure(run, mesh, solver)
    if failed is not None:
        return failed
    sample = by_source(values(run, mesh, solver, measure))
    if not sample:
        return Cell(ABSENT)
    note = partial_failure(run, mesh, solver)
    estimate = median(sample)
    if measure.largest:
        return Cell(measure.show(estimate.most), estimate.most, note=note)
    shown = interval(estimate, measure.show) if measure.spread else measure.show(estimate.value)
    return estimate_cell(estimate, shown, note)


def published_cell(value: Published, show: Callable[[float], str]) -> Cell:
    if value is None:
        return Cell(ABSENT)
    return Cell(value) if isinstance(value, str) else Cell(show(value), value)


def partial_failure(run: Run, mesh: str, solver: str) -> str:
    """A footnote when some sources of the cell are missing or not ok."""
    rows = run.cell(mesh, solver)
    failed = [row for row in rows if not row.ok]
    if failed:
        return "Without the sources that failed. " + _failed(failed)
    missing = set(run.sources[mesh]) - {row.source for row in rows}
    if missing:
        return f"{solver} on {mesh}: no rows for source {', '.join(map(str, sorted(missing)))}."
    return ""


def _failed(rows: list[Row]) -> str:
    """Every distinct message once, with the sources it came from."""
    causes: dict[str, list[int]] = {}
    for row in rows:
        causes.setdefault(f"{row.outcome}: {row.message}", []).append(row.source)
    listed = "; ".join(
        f"source {', '.join(map(str, dict.fromkeys(sources)))}, {cause}"
        for cause, sources in causes.items()
    )
    return f"{rows[0].solver} on {rows[0].mesh}: {listed}"
