"""The frontier of time against error: figures of every solver and setting, on one mesh or over all
meshes, and tables of the fastest solver for each error."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FixedFormatter, FixedLocator, NullLocator

from plots import style
from plots.answers import errors
from plots.dots import sentences, without_value
from plots.drawing import Drawing
from plots.logarithmic import logarithmic
from plots.measures import ABSENT, EDGE_BASED, ERROR, baseline, columns, count, time_unit
from results import published
from results.pairs import Time, by_source, each_of, further, ratios, times
from results.published import Method
from results.reader import Mesh, ResultError, Run, Solver
from results.statistics import Estimate, geometric_mean, median
from results.table import Field, Table, estimate_field

COSTS: dict[str, Time] = {
    "1 source": each_of(1),
    "each of 10 sources": each_of(10),
    "each of 100 sources": each_of(100),
    "each of 1,000 sources": each_of(1000),
    "each further source": further,
}
"""Times of an answer: of a single one, of each of many, and of a further one."""
LEVELS = (0.0, 1e-4, 1e-3, 1e-2, 5e-2)
"""Errors in the tables."""
SOURCES = (1, 10, 1000)
"""Numbers of sources in the tables."""
LEAST_INEXACT = 2
"""Least number of inexact solvers or settings that make a frontier."""
ROW_INCHES = 1.62
MOST_TICKS = 6
FRONT = {"color": "#b8b8b8", "linewidth": 3.0, "solid_joinstyle": "miter", "zorder": 1}
PUBLISHED = {"color": "black", "marker": "D", "markersize": 5.5, "markerfacecolor": "white",
             "linestyle": "", "zorder": 4}  # fmt: skip
BOUNDED, NOT_BOUNDED = "error bounded", "no bound on the error"


@dataclass(frozen=True)
class Point:
    """A solver with one setting of its parameters."""

    solver: Solver
    costs: dict[str, Estimate]
    """Times, or ratios to the base's times, by the keys of COSTS."""
    largest: float
    mean: float
    """Largest and mean relative error; 0 for exact solvers."""


@dataclass(frozen=True)
class Curve:
    """The settings of one solver."""

    label: str
    points: list[Point]
    joined: bool
    """Whether a line joins the points, in the order of the only parameter that differs."""


@dataclass(frozen=True)
class PublishedPoint:
    """A point of a method that cannot be run here (results/published.py)."""

    method: Method
    time: float
    """Ratio to the base's time: the published ratio to another solver, times that solver's measured ratio."""


Error = Callable[[Point], float]
ERRORS: dict[str, Error] = {
    "largest relative error": lambda point: point.largest,
    "mean relative error": lambda point: point.mean,
}


def measured(run: Run, mesh: str) -> list[Point]:
    """Returns the points of the solvers that have times on the mesh and, if inexact, errors. Times are medians
    over sources and repetitions. Errors are the largest of the largest, and the median of the mean ones."""
    points = []
    for solver in columns(run):
        costs = {name: times(run, mesh, solver, cost) for name, cost in COSTS.items()}
        about = run.solvers[solver]
        known = _errors(run, mesh, about)
        if known and all(costs.values()):
            points.append(
                Point(about, {n: median(by_source(of)) for n, of in costs.items()}, *known)
            )
    return points


def _errors(run: Run, mesh: str, solver: Solver) -> tuple[float, float] | None:
    if solver.exact:
        return 0, 0
    largest = errors(run, mesh, solver.name, "max_relative_error")
    mean = errors(run, mesh, solver.name, "mean_relative_error")
    return (max(largest), median([mean]).value) if largest and mean else None


def over_meshes(run: Run, meshes: Sequence[Mesh], base: str) -> list[Point]:
    """Returns the points of the solvers measured on every mesh. Times are geometric means of ratios to the base,
    paired by source and repetition. Errors are the largest of the largest, and the mean of the mean ones."""
    found = [{point.solver.name: point for point in measured(run, mesh.name)} for mesh in meshes]
    points = []
    for solver in (s for s in columns(run) if all(s in of for of in found)):
        over_base = {
            name: [ratios(run, mesh.name, solver, base, cost) for mesh in meshes]
            for name, cost in COSTS.items()
        }
        if not all(sample for samples in over_base.values() for sample in samples):
            continue
        points.append(
            Point(
                run.solvers[solver],
                {name: geometric_mean(samples) for name, samples in over_base.items()},
                max(of[solver].largest for of in found),
                sum(of[solver].mean for of in found) / len(found),
            )
        )
    return points


def front(points: Iterable[Point], cost: str, error: Error) -> list[Point]:
    """Returns the points that have no other point as exact and faster, the most exact first."""
    kept: list[Point] = []
    for point in sorted(points, key=lambda p: (error(p), p.costs[cost].value)):
        if not kept or point.costs[cost].value < kept[-1].costs[cost].value:
            kept.append(point)
    return kept


def curves(run: Run, points: Sequence[Point]) -> list[Curve]:
    """Groups the points by solver, in the order of the points."""
    found = []
    for base in dict.fromkeys(point.solver.base for point in points):
        of = [point for point in points if point.solver.base == base]
        differing = [
            name
            for name in of[0].solver.values
            if len({point.solver.values.get(name) for point in of}) > 1
        ]
        star = "*" if base in run.of_plugins else ""
        several = len(of) > 1
        label = f"{base}{star}: {len(of)} settings" if several else f"{of[0].solver.name}{star}"
        numbers = [point.solver.values[name] for name in differing[:1] for point in of]
        joined = len(differing) == 1 and all(isinstance(n, int | float) for n in numbers)
        if joined:
            (name,) = differing
            of.sort(key=lambda point: point.solver.values[name])
            label = f"{_without(of[0].solver.name, name)}{star}: {name} " + ", ".join(
                f"{point.solver.values[name]:g}" for point in of
            )
        found.append(Curve(label, of, joined))
    return found


def _without(name: str, parameter: str) -> str:
    """Returns the solver's name without a parameter and its value."""
    base, _, values = name.partition("?")
    others = [each for each in values.split("&") if each and not each.startswith(f"{parameter}=")]
    return "?".join([base, "&".join(others)]) if others else base


def published_points(points: Iterable[Point]) -> list[PublishedPoint]:
    """Returns the points of the published methods whose solver for comparison has a point."""
    by_name = {point.solver.name: point.costs["1 source"].value for point in points}
    return [
        PublishedPoint(method, by_name[method.beside] * method.time_s / method.beside_time_s)
        for method in published.methods()
        if method.beside in by_name
    ]


def bounded(solver: Solver) -> bool:
    return solver.exactness in ("exact", "bounded")


def figure(run: Run) -> Drawing:
    """Draws the times of a run of one mesh, or the ratios over all meshes of a run of several.

    @raises ResultError if fewer than two inexact solvers or settings have a time; in a run of several meshes
            also if the base has times on fewer than two, or fewer than two solvers have times on all of these"""
    _require_inexact(run)
    return _of_one(run, *run.meshes.values()) if len(run.meshes) == 1 else _of_several(run)


def _of_one(run: Run, mesh: Mesh) -> Drawing:
    points = measured(run, mesh.name)
    return Drawing(
        title=f"The frontier on {mesh.label}: time against error",
        caption=sentences(
            f"{mesh.label}, {count(mesh.vertices)} vertices. Each point is a solver with one "
            "setting of its parameters: medians over sources and repetitions with 95% bootstrap "
            "intervals, the largest error from any source, the median of the mean errors.",
            _how_to_read(run, points),
            without_value(run, columns(run)),
        ),
        figure=_draw(run, points, "time of an answer (s)"),
    )


def _of_several(run: Run) -> Drawing:
    base = baseline(run, EDGE_BASED)
    meshes = [mesh for mesh in _by_size(run) if times(run, mesh.name, base, further)]
    points = over_meshes(run, meshes, base) if len(meshes) > 1 else []
    if len(points) < LEAST_INEXACT:
        raise ResultError(f"{run.file}: no two meshes that several solvers have a time of")
    elsewhere = published_points(points)
    short = [s for s in columns(run) if s not in {point.solver.name for point in points}]
    return Drawing(
        title="The frontier over all meshes: time against error",
        caption=sentences(
            f"Each point is a solver with one setting of its parameters. Times are over those of "
            f"{base}: geometric means over {len(meshes)} meshes of ratios paired by source and "
            "repetition, with 95% bootstrap intervals; errors are the largest on any mesh, and the "
            "mean over meshes.",
            _how_to_read(run, points),
            *(_about(point.method) for point in elsewhere),
            f"Without: {', '.join(short)} (not right or not timed on every mesh)." if short else "",
        ),
        figure=_draw(run, points, f"time of an answer / {style.plain(base)}", elsewhere),
    )


def _about(method: Method) -> str:
    return (
        f"Hollow diamond: {method.method} as published ({method.source}): its mean error on a mesh of "
        f"{count(method.vertices)} vertices, and its time over that of {method.beside} there "
        f"({method.time_s:g} s and {method.beside_time_s:g} s), times the time of {method.beside} here."
    )


def _require_inexact(run: Run) -> None:
    inexact = {row.solver for row in run.rows if row.ok and not run.solvers[row.solver].exact}
    timed = {s for s in inexact for mesh in run.meshes if times(run, mesh, s, further)}
    if len(timed) < LEAST_INEXACT:
        raise ResultError(
            f"{run.file}: no {LEAST_INEXACT} inexact solvers or settings with a time; "
            "run --corpus frontier"
        )


def _by_size(run: Run) -> list[Mesh]:
    return sorted(run.meshes.values(), key=lambda mesh: mesh.vertices)


def _how_to_read(run: Run, points: Sequence[Point]) -> str:
    error = "largest relative error"
    theirs = any(point.solver.base in run.of_plugins for point in points)
    members = [
        f"for {cost} {', '.join(p.solver.name for p in front(points, cost, ERRORS[error]))}"
        for cost in ("1 source", "each of 1,000 sources")
    ]
    return sentences(
        "The time of an answer of n sources is a solve and its share of the preparation. Exact solvers are "
        "at 0. Filled: the solver declares a bound of its error; if it is not exact, a line joins its largest "
        "error to the bound. Hollow: it declares no bound. Lines join the settings of one solver.",
        "A star marks solvers of others." if theirs else "",
        "The grey line is the front: no point is both more exact and faster. On it, by the "
        f"{error}: {'; '.join(members)}.",
    )


def _draw(
    run: Run, points: Sequence[Point], label: str, elsewhere: Sequence[PublishedPoint] = ()
) -> Figure:
    styles = style.solver_styles(run.solvers)
    looks = {solver.base: styles[solver.name] for solver in reversed(run.solvers.values())}
    picture = style.new_figure(1.4 + ROW_INCHES * len(COSTS))
    grid = picture.subplots(len(COSTS), len(ERRORS), sharex="col", sharey=True)
    shown = curves(run, points)
    for row, cost in zip(grid, COSTS, strict=True):
        row[0].set_title(cost, loc="left", fontsize=9.5)
        for axes, error in zip(row, ERRORS.values(), strict=True):
            _panel(axes, shown, looks, cost, error)
            if error is ERRORS["mean relative error"]:
                for point in elsewhere:
                    axes.plot([point.method.mean_relative_error], [point.time], **PUBLISHED)
    for axes, name in zip(grid[-1], ERRORS, strict=True):
        axes.set_xlabel(name)
    logarithmic(grid[0, 0].yaxis)
    picture.supylabel(label, fontsize=10)
    handles = [_mark(curve, looks[curve.points[0].solver.base]) for curve in shown]
    for words, fill in [(BOUNDED, style.PALE), (NOT_BOUNDED, "white")]:
        handles.append(Line2D([], [], color=style.PALE, marker="o", markersize=4.5, linestyle="",
                              markerfacecolor=fill, label=words))  # fmt: skip
    handles.append(Line2D([], [], label="front", **FRONT))
    handles += [
        Line2D([], [], label=f"{p.method.method}, published", **PUBLISHED) for p in elsewhere
    ]
    style.legend_above(picture, handles, columns=3)
    return picture


def _mark(curve: Curve, look: style.SolverStyle) -> Line2D:
    return Line2D([], [], label=style.plain(curve.label), color=look.color, marker=look.marker,
                  markersize=4.5, linestyle="-" if curve.joined else "", linewidth=0.8,
                  markerfacecolor=_fill(curve.points[0], look))  # fmt: skip


def _fill(point: Point, look: style.SolverStyle) -> str:
    return look.color if bounded(point.solver) else "white"


def _panel(
    axes: Axes,
    shown: Sequence[Curve],
    looks: dict[str, style.SolverStyle],
    cost: str,
    error: Error,
) -> None:
    every = [point for curve in shown for point in curve.points]
    zero = _error_axis(axes, [error(point) for point in every])

    def place(point: Point) -> float:
        return max(error(point), zero)

    best = front(every, cost, error)
    steps = [*((place(p), p.costs[cost].value) for p in best),
             (axes.get_xlim()[1], best[-1].costs[cost].value)]  # fmt: skip
    axes.step(*zip(*steps, strict=True), where="post", **FRONT)
    for curve in shown:
        look = looks[curve.points[0].solver.base]
        middle = [(place(p), p.costs[cost].value) for p in curve.points]
        if curve.joined:
            axes.plot(*zip(*middle, strict=True), color=look.color, linewidth=0.8, zorder=2)
        for point, (x, y) in zip(curve.points, middle, strict=True):
            time = point.costs[cost]
            line = {"color": look.color, "linewidth": 0.8, "zorder": 2}
            axes.plot([x, x], [time.low, time.high], **line)
            if point.solver.error_bound and error is ERRORS["largest relative error"]:
                axes.plot([x, max(x, point.solver.error_bound)], [y, y], **line)
            axes.plot([x], [y], marker=look.marker, markersize=4.5, linestyle="", zorder=3,
                      color=look.color, markerfacecolor=_fill(point, look))  # fmt: skip
    axes.grid()


def _error_axis(axes: Axes, values: Sequence[float]) -> float:
    """Makes a logarithmic axis of errors with a place for 0 at its left, and returns this place."""
    positive = [value for value in values if value > 0] or [1.0]
    least = math.floor(math.log10(min(positive)))
    most = max(math.ceil(math.log10(max(positive))), least + 1)
    zero = 10.0 ** (least - 1)
    every = math.ceil((most - least + 1) / MOST_TICKS)
    decades = range(most, least - 1, -every)
    axes.set_xscale("log")
    axes.set_xlim(10 ** (least - 1.5), 10 ** (most + 0.2))
    axes.xaxis.set_major_locator(FixedLocator([zero, *(10.0**d for d in decades)]))
    axes.xaxis.set_major_formatter(
        FixedFormatter(["0", *("1" if d == 0 else f"$10^{{{d}}}$" for d in decades)])
    )
    axes.xaxis.set_minor_locator(NullLocator())
    axes.axvspan(10 ** (least - 1.5), 10 ** (least - 0.5), color="#f4f4f4", linewidth=0, zorder=0)
    return zero


def which_to_take(run: Run) -> Table:
    """Returns the fastest solvers by largest error. @raises ResultError without two timed inexact solvers"""
    return _choices(run, "which_to_take", "largest")


def which_to_take_mean(run: Run) -> Table:
    """Returns the fastest solvers by mean error. @raises ResultError for the reasons of which_to_take()"""
    return _choices(run, "which_to_take_mean", "mean")


def _choices(run: Run, name: str, which: str) -> Table:
    _require_inexact(run)
    header = ["Mesh", "n", "Error at most"]
    for sources in SOURCES:
        header += [f"{sources:,} source{'s' if sources > 1 else ''}", f"each, of {sources:,}"]
    return Table(
        name=name,
        title=f"Which one to take: the fastest that keeps the {which} error",
        header=header,
        text_columns=1,
        rows=[row for mesh in _by_size(run) for row in _block(run, mesh, which)],
        remarks=[
            f"Among the solvers and settings with a {which} relative error on the mesh of at most that of the "
            "row (0: exact), the one with the least time for this number of sources, and its time per answer "
            "with a share of the preparation: medians over sources and repetitions, with 95% bootstrap "
            "intervals in the CSV.",
        ],
    )


def _block(run: Run, mesh: Mesh, which: str) -> list[list[Field]]:
    points = measured(run, mesh.name)
    rows: list[list[Field]] = []
    for level in LEVELS:
        keep = [p for p in points if p.solver.exact or (level and getattr(p, which) <= level)]
        fields = [field for n in SOURCES for field in _choice(run, mesh.name, keep, n, level)]
        rows.append([
            Field("" if rows else mesh.name, mesh.label),
            Field("" if rows else count(mesh.vertices), mesh.vertices),
            Field(ERROR.show(level) if level else "0", level),
            *fields,
        ])  # fmt: skip
    return rows


def _choice(
    run: Run, mesh: str, keep: Sequence[Point], sources: int, level: float
) -> tuple[Field, Field]:
    """Returns the fastest solver and its time. A footnote says if the solver does not promise the level,
    and which others may be as fast."""
    cost = each_of(sources)
    found = {p.solver.name: median(by_source(times(run, mesh, p.solver.name, cost))) for p in keep}
    if not found:
        return Field("none"), Field(ABSENT)
    best = min(found, key=lambda name: found[name].value)
    rivals = [name for name in found if name != best and _as_fast(run, mesh, name, best, cost)]
    about = run.solvers[best]
    promised = about.exact or (about.error_bound is not None and about.error_bound <= level)
    note = sentences(
        "" if promised else "The solver does not promise this error: it was measured on these sources.",
        f"Not resolved from {', '.join(rivals)}." if rivals else "",
    )
    value = found[best]
    return Field(best, note=note), estimate_field(value, time_unit([value.value]).text(value.value))


def _as_fast(run: Run, mesh: str, rival: str, best: str, cost: Time) -> bool:
    """Returns whether the interval of the ratio of the two times reaches 1."""
    pairs = ratios(run, mesh, rival, best, cost)
    return bool(pairs) and geometric_mean([pairs]).low <= 1
