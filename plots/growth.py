"""Growth of time and windows with the number of vertices: tables by mesh and of exponents, a figure.

Exponents are fitted to series of meshes: at least three sizes of one surface. Times on different
surfaces differ even at the same size, so a line through them means little.
"""

from __future__ import annotations

import re
from dataclasses import astuple, dataclass

from matplotlib.lines import Line2D

from plots import style
from plots.dots import sentences
from plots.drawing import Drawing
from plots.logarithmic import logarithmic
from plots.measures import (
    PROPAGATIONS, TIME, TimeUnit, columns, count, interval_field, median_of, time_unit,
)  # fmt: skip
from results.reader import Mesh, ResultError, Run
from results.statistics import Estimate, power_law
from results.table import Field, Table

LEAST_MESHES = 3
LEAST_SPAN = 4
"""Least ratio of the vertices of the largest and the smallest mesh: a smaller one shows no growth."""


@dataclass(frozen=True)
class Point:
    mesh: Mesh
    seconds: Estimate
    windows: float

    @property
    def time(self) -> float:
        return self.seconds.value

    @property
    def nanoseconds_a_window(self) -> float:
        return 1e9 * self.time / self.windows


def surface(mesh: Mesh) -> str:
    """Returns the name up to its first number. Names of meshes of one series differ in their size only."""
    return re.split(r"(?<=\D)\d", mesh.name)[0]


@dataclass(frozen=True)
class Series:
    """A solver on a surface at several sizes."""

    solver: str
    surface: str
    points: list[Point]
    """Sorted by vertices."""

    @property
    def vertices(self) -> list[int]:
        return [point.mesh.vertices for point in self.points]

    @property
    def times(self) -> list[float]:
        return [point.time for point in self.points]


def series(run: Run) -> list[Series]:
    """Returns the series of each surface and solver that are long enough for a fit.

    @raises ResultError if no solver has such a series"""

    surfaces: dict[str, list[Mesh]] = {}
    for mesh in sorted(run.meshes.values(), key=lambda mesh: mesh.vertices):
        surfaces.setdefault(surface(mesh), []).append(mesh)
    found = []
    for name, meshes in surfaces.items():
        for solver in columns(run) if len(meshes) >= LEAST_MESHES else ():
            points = [
                Point(mesh, time, windows.value)
                for mesh in meshes
                if (time := median_of(run, mesh.name, solver, TIME))
                and (windows := median_of(run, mesh.name, solver, PROPAGATIONS))
            ]
            measured = [point for point in points if point.time > 0 and point.windows > 0]
            sizes = {point.mesh.vertices for point in measured}
            if len(sizes) >= LEAST_MESHES and max(sizes) >= LEAST_SPAN * min(sizes):
                found.append(Series(solver, name.rstrip("-_"), measured))
    if not found:
        raise ResultError(
            f"{run.file}: no solver has {LEAST_MESHES} meshes of one surface of which the largest "
            f"has {LEAST_SPAN} times the vertices of the smallest (surface-10k, surface-30k, ...); "
            "run --corpus growth"
        )
    return found


def table(run: Run) -> Table:
    """@raises ResultError for the reasons of series()"""
    found = series(run)
    unit = time_unit([time for each in found for time in each.times])
    return Table(
        name="table_growth",
        title="Growth: time and windows over vertices",
        header=[
            "Solver", "Mesh", "n", f"Time ({unit.name})", "Windows", "ns a window", "by smallest",
        ],
        text_columns=2,
        rows=[
            _row(each.solver, point, each.points[0], unit)
            for each in found
            for point in each.points
        ],
        remarks=[
            "Medians over sources and repetitions, times with 95% bootstrap intervals. Time per window: CPU "
            "time of a timed solve over "
            "the windows that the recorded solve propagates; beside it, that of the smallest mesh.",
        ],
    )


def exponents(run: Run) -> Table:
    """@raises ResultError for the reasons of series()"""
    return Table(
        name="table_growth_exponents",
        title="Growth: fitted exponents",
        header=["Solver", "Surface", "Meshes", "n from", "n to", "of time", "of windows"],
        text_columns=2,
        rows=[_exponents(each) for each in series(run)],
        remarks=[
            "Least squares of log time and log window propagations on log vertices, with 95% "
            "intervals of the slope (Student's t). They describe these series and no bound: the "
            "worst case is O(n^2) windows, and Surazhsky et al. 2005 observe about n^1.5.",
        ],
    )


def _row(solver: str, point: Point, smallest: Point, unit: TimeUnit) -> list[Field]:
    each = point.nanoseconds_a_window
    share = each / smallest.nanoseconds_a_window
    return [
        Field(solver),
        Field(point.mesh.label),
        Field(count(point.mesh.vertices), point.mesh.vertices),
        _in_unit(point.seconds, unit),
        Field(count(point.windows), point.windows),
        Field(f"{each:.1f}", each),
        Field(f"{share:.2f}", share),
    ]


def _in_unit(seconds: Estimate, unit: TimeUnit) -> Field:
    ends = (unit.scale * each for each in astuple(seconds))
    return interval_field(Estimate(*ends), unit.show)


def _exponents(series: Series) -> list[Field]:
    numbers = [len(series.points), series.vertices[0], series.vertices[-1]]
    windows = [point.windows for point in series.points]
    laws = [power_law(series.vertices, what) for what in (series.times, windows)]
    return [
        Field(series.solver),
        Field(series.surface),
        *(Field(count(number), number) for number in numbers),
        *(Field(f"{law.exponent:.3f} [{law.low:.3f}, {law.high:.3f}]", law.exponent, law.low, law.high)
          for law in laws),
    ]  # fmt: skip


def figure(run: Run) -> Drawing:
    """Draws a panel of time against vertices per surface. @raises ResultError for the reasons of series()"""
    found = series(run)
    surfaces = list(dict.fromkeys(each.surface for each in found))
    styles = style.solver_styles(run.solvers)
    picture = style.new_figure(4.4)
    panels = picture.subplots(1, len(surfaces), sharey=True, squeeze=False)[0]
    handles = []
    for each in found:
        axes, look = panels[surfaces.index(each.surface)], styles[each.solver]
        law = power_law(each.vertices, each.times)
        mark = {"color": look.color, "marker": look.marker, "markersize": 4.5}
        seconds = [point.seconds for point in each.points]
        axes.errorbar(each.vertices, each.times, yerr=style.bars(seconds), linestyle="", elinewidth=1, **mark)
        ends = [each.vertices[0], each.vertices[-1]]
        axes.plot(ends, [law.at(n) for n in ends], color=look.color, linestyle=look.line)
        label = f"$n^{{{law.exponent:.2f}}}$ [{law.low:.2f}, {law.high:.2f}]"
        on = f", {each.surface}" if len(surfaces) > 1 else ""
        label = f"{style.plain(each.solver)}{on}: {label}"
        handles.append(Line2D([], [], linestyle=look.line, label=label, **mark))
    for axes, name in zip(panels, surfaces, strict=True):
        logarithmic(axes.xaxis, axes.yaxis)
        axes.set_xlabel("vertices $n$" + (f", {name}" if len(surfaces) > 1 else ""))
        axes.grid()
    panels[0].set_ylabel("CPU time of one solve (s)")
    style.legend_above(picture, handles, columns=2)
    meshes = {point.mesh.name for each in found for point in each.points}
    drawn = {each.solver for each in found}
    short = [s for s in columns(run) if s not in drawn]
    of = "one surface" if len(surfaces) == 1 else f"{len(surfaces)} surfaces"
    return Drawing(
        title="Time against vertices",
        caption=sentences(
            "Medians over sources and repetitions of each solver that counts windows, with 95% bootstrap intervals, on "
            f"{len(meshes)} meshes of {of}; lines are least squares of the logarithms, with "
            "95% intervals of the exponent. They describe these meshes and no bound.",
            f"Without: {', '.join(short)} (fewer than {LEAST_MESHES} sizes with a time and a "
            "count of windows)."
            if short
            else "",
        ),
        figure=picture,
    )
