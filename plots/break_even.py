"""Number of sources from which a solver that prepares first (a heat method factorises a matrix) is faster
than the exact solver; and the errors of its answers."""

from __future__ import annotations

import math
from dataclasses import dataclass

from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from plots import style
from plots.answers import errors
from plots.dots import sentences
from plots.drawing import Drawing
from plots.growth import surface
from plots.logarithmic import logarithmic
from plots.measures import (
    EDGE_BASED, ERROR, baseline, columns, count, interval_field, percent, time_unit,
)  # fmt: skip
from results.pairs import by_source, further, preparation, times
from results.reader import Mesh, ResultError, Run, Source
from results.statistics import Estimate, median
from results.table import Field, Table

LEAST_MESHES = 2


@dataclass(frozen=True)
class Point:
    """Medians over sources and repetitions of a prepared solver and the exact one on one mesh."""

    mesh: Mesh
    preparations: tuple[float, float]
    """Times of the prepared solver and of the exact one in seconds; so are `furthers`."""
    furthers: tuple[float, float]
    sources: Estimate
    """Number of sources from which the prepared solver takes less total time; infinite if it never does."""
    mean_error: float
    largest_error: float
    bytes_a_vertex: float
    """Greatest memory of the prepared solver; not a number if it is not known."""


def break_even(preparations: tuple[float, float], furthers: tuple[float, float]) -> float:
    """Returns the number of sources n for which preparation + n * further is equal for both solvers:
    at least 0, and infinite if a further answer of the prepared solver is not faster.

    @param preparations, furthers of the prepared solver and of the exact one, in one unit"""
    saved = furthers[1] - furthers[0]
    return max(0.0, (preparations[0] - preparations[1]) / saved) if saved > 0 else math.inf


def series(run: Run) -> tuple[str, dict[str, list[Point]]]:
    """Returns the exact solver and, by prepared solver, the points of the meshes that both solvers answered,
    sorted by vertices. A prepared solver is inexact, and on each mesh its preparation takes longer than a
    further answer of the exact one. @raises ResultError if none has two such meshes"""
    exact = baseline(run, EDGE_BASED)
    meshes = sorted(run.meshes.values(), key=lambda mesh: mesh.vertices)
    inexact = [solver for solver in columns(run) if not run.solvers[solver].exact]
    found = {solver: [p for mesh in meshes if (p := _point(run, mesh, solver, exact))]
             for solver in inexact}  # fmt: skip
    prepared = {
        solver: points
        for solver, points in found.items()
        if len(points) >= LEAST_MESHES and all(p.preparations[0] > p.furthers[1] for p in points)
    }
    if not prepared:
        raise ResultError(
            f"{run.file}: no prepared solver and exact one with the times of {LEAST_MESHES} meshes; "
            "run --corpus break-even --peers all"
        )
    return exact, prepared


def _point(run: Run, mesh: Mesh, solver: str, exact: str) -> Point | None:
    prepared, solved = ([times(run, mesh.name, s, time) for s in (solver, exact)]
                        for time in (preparation, further))  # fmt: skip
    pairs = solved[0].keys() & solved[1].keys()
    if not pairs:
        return None
    numbers = {
        pair: break_even((prepared[0][pair], prepared[1][pair]), (solved[0][pair], solved[1][pair]))
        for pair in sorted(pairs)
    }

    def middle(times: list[dict[tuple[Source, int], float]]) -> tuple[float, float]:
        own, exact_time = (median(by_source(each)).value for each in times)
        return own, exact_time

    mean = errors(run, mesh.name, solver, "mean_relative_error")
    largest = errors(run, mesh.name, solver, "max_relative_error")
    peaks = [b for row in run.cell(mesh.name, solver) if (b := row.number("solver_peak_bytes"))]
    return Point(
        mesh, middle(prepared), middle(solved), _over(by_source(numbers)),
        median([mean]).value if mean else math.nan, max(largest, default=math.nan),
        max(peaks, default=math.nan) / mesh.vertices,
    )  # fmt: skip


def _over(sample: list[list[float]]) -> Estimate:
    if any(math.isinf(value) for group in sample for value in group):
        middle = sorted(value for group in sample for value in group)[sum(map(len, sample)) // 2]
        return Estimate(middle, middle, middle, middle, middle)
    return median(sample)


def table(run: Run) -> Table:
    """@raises ResultError for the reasons of series()"""
    exact, found = series(run)
    return Table(
        name="break_even_numbers",
        title=f"From how many sources on a prepared solver is faster than {exact}",
        header=[
            "Solver", "Mesh", "n", "Preparation", f"of {exact}", "Each further", f"of {exact} ",
            "Break-even (sources)", "Mean error", "Largest error", "Bytes a vertex",
        ],
        text_columns=2,
        rows=[_row(solver, point) for solver, points in found.items() for point in points],
        remarks=[
            "The time of n sources is the preparation plus n times each further. From the break-even on, the "
            f"prepared solver takes less time in total than {exact}. It is computed for each source and repetition "
            "that both have: medians with 95% bootstrap intervals. Errors are relative, the median "
            "over sources of the mean over vertices, and the largest.",
        ],
    )


def _row(solver: str, point: Point) -> list[Field]:
    def seconds(value: float) -> Field:
        return Field(time_unit([value]).text(value), value)

    def error(value: float) -> Field:
        return Field(ERROR.show(value), value) if math.isfinite(value) else Field("not known")

    return [
        Field(solver),
        Field(point.mesh.name),
        Field(count(point.mesh.vertices), point.mesh.vertices),
        *map(seconds, point.preparations),
        *map(seconds, point.furthers),
        interval_field(point.sources, _sources)
        if math.isfinite(point.sources.value)
        else Field("never"),
        error(point.mean_error),
        error(point.largest_error),
        Field(count(round(point.bytes_a_vertex)), point.bytes_a_vertex)
        if math.isfinite(point.bytes_a_vertex)
        else Field("not known"),
    ]


def _sources(value: float) -> str:
    return f"{value:,.1f}"


def figure(run: Run) -> Drawing:
    """@raises ResultError for the reasons of series()"""
    exact, found = series(run)
    styles = style.solver_styles(run.solvers)
    picture = style.new_figure(3.4)
    left, right = picture.subplots(1, 2)
    surfaces = {surface(point.mesh) for points in found.values() for point in points}
    for solver, points in found.items():
        look = styles[solver]
        line = {"color": look.color, "marker": look.marker, "markersize": 4.5}
        # No line joins meshes of different surfaces: values between them are not known.
        joined = look.line if len(surfaces) == 1 else ""
        _draw_sources(left, points, line, joined)
        for key, fill, dashes in [("mean_error", look.color, joined),
                                  ("largest_error", "white", joined and (0, (1, 2)))]:  # fmt: skip
            known = [(p.mesh.vertices, getattr(p, key)) for p in points if getattr(p, key) > 0]
            if known:
                right.plot(*zip(*known, strict=True), linestyle=dashes, markerfacecolor=fill, **line)
    shown = [p.sources.value for points in found.values() for p in points]
    finite = [value for value in shown if 0 < value < math.inf]
    if finite:
        left.set_ylim(min([0.9, *finite]) / 1.1, 2 * max(finite))  # the axis always contains one source
    for axes, label in [(left, f"break-even with {style.plain(exact)} (sources)"),
                        (right, "relative error")]:  # fmt: skip
        axes.set_xlabel("vertices $n$")
        axes.set_ylabel(label)
        axes.grid()
        if axes.lines:
            logarithmic(axes.xaxis, axes.yaxis)
    handles = [
        Line2D([], [], color=styles[s].color, marker=styles[s].marker, markersize=4.5,
               linestyle=styles[s].line if len(surfaces) == 1 else "", label=style.plain(s))
        for s in found
    ]  # fmt: skip
    for words, fill in [("mean error", style.PALE), ("largest error", "white")]:
        handles.append(Line2D([], [], color=style.PALE, marker="o", markersize=4.5, linestyle="",
                              markerfacecolor=fill, label=words))  # fmt: skip
    style.legend_above(picture, handles)
    return Drawing(
        title=f"From how many sources on a prepared solver is faster than {exact}",
        caption=sentences(
            f"Left: the number of sources whose answers take a prepared solver and {exact} the same "
            "time, preparation included; medians over sources and repetitions with 95% bootstrap "
            f"intervals. With fewer sources {exact} is faster. Right: the relative errors of the "
            "prepared solvers, mean and largest.",
            *(_sentence(solver, exact, points) for solver, points in found.items()),
        ),
        figure=picture,
    )


def _draw_sources(axes: Axes, points: list[Point], line: dict[str, object], dashes: object) -> None:
    shown = [p for p in points if 0 < p.sources.value < math.inf]
    if not shown:
        return
    sources = [p.sources for p in shown]
    axes.errorbar(
        [p.mesh.vertices for p in shown], [one.value for one in sources], yerr=style.bars(sources),
        linestyle=dashes, elinewidth=1, **line,
    )  # fmt: skip


def _sentence(solver: str, exact: str, points: list[Point]) -> str:
    """Returns a sentence on the break-even on the smallest and on the largest mesh."""
    words = [
        f"{_many(point.sources.value)} at {count(point.mesh.vertices)} vertices"
        for point in (points[0], points[-1])
    ]
    worst = max((p.mean_error for p in points if math.isfinite(p.mean_error)), default=math.nan)
    error = f", with a mean error of up to {percent(worst)}" if math.isfinite(worst) else ""
    return f"{solver} is faster than {exact} from {' and '.join(words)} on{error}."


def _many(value: float) -> str:
    if math.isinf(value):
        return "no number of sources"
    sources = math.floor(value) + 1
    return f"{sources:,} sources" if sources > 1 else "the first source"
