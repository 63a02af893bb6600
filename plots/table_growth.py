"""How time and windows grow with the number of vertices: per mesh, and fitted exponents.

Meant for a series of meshes of one surface (the corpus growth); needs three meshes at least.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import stats

from results.statistics import median
from plots.measures import PROPAGATIONS, TIME, Measure, by_source, count, seconds, values
from results.reader import Mesh, ResultError, Run
from results.table import Cell, Table

LEAST_MESHES = 3
LEAST_SPAN = 4
"""Of the largest mesh over the smallest, in vertices: less shows no growth."""
CONFIDENCE = 0.95
REMARKS = [
    "Medians over sources and repetitions. Time per window: CPU time of a timed solve over the "
    "windows that the recorded solve propagates; beside it, that of the smallest mesh.",
]
FIT_REMARKS = [
    "Least squares of log time and log window propagations on log vertices, with 95% intervals "
    "of the slope (Student's t). They describe this series and no bound: the worst case is "
    "O(n^2) windows, and Surazhsky et al. 2005 observe about n^1.5 of them.",
]


@dataclass(frozen=True)
class Point:
    mesh: Mesh
    time: float
    """Seconds."""
    windows: float

    @property
    def nanoseconds_a_window(self) -> float:
        return 1e9 * self.time / self.windows


def series(run: Run, solver: str) -> list[Point]:
    """The meshes on which the solver has both numbers, by their vertices."""

    def middle(mesh: str, measure: Measure) -> float:
        sample = by_source(values(run, mesh, solver, measure))
        return median(sample).value if sample else 0

    points = [
        Point(mesh, middle(name, TIME), middle(name, PROPAGATIONS))
        for name, mesh in run.meshes.items()
    ]
    measured = [point for point in points if point.time > 0 and point.windows > 0]
    return sorted(measured, key=lambda point: point.mesh.vertices)


def exponent(points: list[Point], what: list[float]) -> Cell:
    """The slope of log `what` over log vertices, with its interval."""
    vertices = np.log([point.mesh.vertices for point in points])
    fit = stats.linregress(vertices, np.log(what))
    half = stats.t.ppf(0.5 + CONFIDENCE / 2, len(points) - 2) * fit.stderr
    low, high = fit.slope - half, fit.slope + half
    return Cell(f"{fit.slope:.3f} [{low:.3f}, {high:.3f}]", fit.slope, low, high)


def grown(run: Run) -> dict[str, list[Point]]:
    """The series of every solver that has one long enough for a fit.

    @raises ResultError when no solver has enough meshes of different sizes."""
    all_series = {solver: series(run, solver) for solver in run.solvers}
    long_enough = {
        solver: points
        for solver, points in all_series.items()
        if len(sizes := {point.mesh.vertices for point in points}) >= LEAST_MESHES
        and max(sizes) >= LEAST_SPAN * min(sizes)
    }
    if not long_enough:
        raise ResultError(
            f"{run.file}: no solver has {LEAST_MESHES} meshes of which the largest has "
            f"{LEAST_SPAN} times the vertices of the smallest; run --corpus growth"
        )
    return long_enough


def tables(run: Run) -> list[Table]:
    """@raises ResultError when no solver has enough meshes of different sizes."""
    all_series = grown(run)
    return [
        Table(
            name="table_growth",
            title="Growth: time and windows over vertices",
            header=["Solver", "Mesh", "n", "Time (s)", "Windows", "ns a window", "by smallest"],
            text_columns=2,
            rows=[
                _row(solver, point, points[0])
                for solver, points in all_series.items()
                for point in points
            ],
            remarks=REMARKS,
        ),
        Table(
            name="table_growth_exponents",
            title="Growth: fitted exponents",
            header=["Solver", "Meshes", "n from", "n to", "of time", "of windows"],
            text_columns=1,
            rows=[_fit(solver, points) for solver, points in all_series.items()],
            remarks=FIT_REMARKS,
        ),
    ]


def _row(solver: str, point: Point, smallest: Point) -> list[Cell]:
    each = point.nanoseconds_a_window
    share = each / smallest.nanoseconds_a_window
    return [
        Cell(solver),
        Cell(point.mesh.label),
        Cell(count(point.mesh.vertices), point.mesh.vertices),
        Cell(seconds(point.time), point.time),
        Cell(count(point.windows), point.windows),
        Cell(f"{each:.1f}", each),
        Cell(f"{share:.2f}", share),
    ]


def _fit(solver: str, points: list[Point]) -> list[Cell]:
    first, last = points[0].mesh.vertices, points[-1].mesh.vertices
    return [
        Cell(solver),
        Cell(str(len(points)), len(points)),
        Cell(count(first), first),
        Cell(count(last), last),
        exponent(points, [point.time for point in points]),
        exponent(points, [point.windows for point in points]),
    ]
