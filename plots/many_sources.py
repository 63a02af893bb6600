"""Queries from several sources at once: time and error against the number of sources."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from plots import style
from plots.dots import sentences
from plots.drawing import Drawing
from plots.logarithmic import logarithmic
from plots.measures import ERROR, columns, count, interval_field, percent
from plots.ratios import fastest_exact, number
from results.reader import ResultError, Row, Run, Source
from results.statistics import Estimate, geometric_mean_of_ratios
from results.table import BLANK, Field, Table

RANDOM = "random:"
"""Prefix of sets of random vertices, which have the same size on every mesh."""


@dataclass(frozen=True)
class Point:
    """Answers of a solver from one number of sources, over the meshes."""

    sources: int
    time: Estimate
    """Geometric mean over the meshes of the ratios to the base's time from one source."""
    largest: float
    """Largest relative error; `mean` is the mean of the mean relative errors."""
    mean: float


def sizes(run: Run) -> dict[str, dict[int, Source]]:
    """Returns the sources to draw, by mesh and number of vertices. Of several sources with one number, the
    first is taken."""
    found: dict[str, dict[int, Source]] = {}
    for mesh, sources in run.sources.items():
        by_size: dict[int, Source] = {}
        for source in sources:
            size = run.set_size(mesh, source)
            if size == 1 or str(source).startswith(RANDOM):
                by_size.setdefault(size, source)
        found[mesh] = by_size
    return found


def answers_of(run: Run, mesh: str, solver: str, source: Source) -> list[Row]:
    rows = run.cell(mesh, solver)
    return [row for row in rows if row.source == source and row.number("cpu_time") is not None]


def times(rows: list[Row]) -> list[float]:
    return [row.time for row in rows]


def error(rows: list[Row], key: str) -> float:
    return max((row.number(key) or 0.0 for row in rows), default=0.0)


def base_of(run: Run) -> str:
    """Returns the solver that the others are compared with: the fastest exact one, if there is one.

    @raises ResultError for a run without sets of sources"""
    if "source_sets" not in run.ours:
        raise ResultError(f"{run.file}: no sets of sources; run --source-sets random:8,boundary")
    return fastest_exact(run)


def points(run: Run, solver: str, base: str) -> list[Point]:
    """Returns points for the numbers of sources that the solver answers on every mesh that has them."""
    by_mesh = sizes(run)
    found = []
    for size in sorted({size for sets in by_mesh.values() for size in sets}):
        meshes = [mesh for mesh, sets in by_mesh.items() if {1, size} <= sets.keys()]
        answers = [answers_of(run, mesh, solver, by_mesh[mesh][size]) for mesh in meshes]
        bases = [answers_of(run, mesh, base, by_mesh[mesh][1]) for mesh in meshes]
        if not meshes or not all(answers) or not all(bases):
            continue
        pairs = [(times(below), times(own)) for own, below in zip(answers, bases, strict=True)]
        means = [error(rows, "mean_relative_error") for rows in answers]
        largest = max(error(rows, "max_relative_error") for rows in answers)
        found.append(Point(size, geometric_mean_of_ratios(pairs, redraw_cells=False), largest, sum(means) / len(means)))
    return found


def figure(run: Run) -> Drawing:
    """@raises ResultError for the reasons of base_of(), and if there are no two numbers of sources"""
    base = base_of(run)
    found = {solver: points(run, solver, base) for solver in columns(run)}
    if max(map(len, found.values())) < 2:
        raise ResultError(
            f"{run.file}: no two numbers of sources; run --source-sets random:8,random:64"
        )
    inexact = {solver: of for solver, of in found.items() if any(p.largest > 0 for p in of)
               and not run.solvers[solver].exact}  # fmt: skip
    looks = style.solver_styles(run.solvers)
    picture = style.new_figure(3.6 + 0.11 * len(found), width=9)
    panels = picture.subplots(1, 3 if inexact else 1, squeeze=False)[0]
    _draw(panels[0], f"time, over {style.plain(base)}'s from one source", looks, found, lambda p: p.time.value,
          lambda p: p.time)  # fmt: skip
    if inexact:
        _draw(panels[1], "mean relative error", looks, inexact, lambda p: p.mean)
        _draw(panels[2], "largest relative error", looks, inexact, lambda p: p.largest)
    panels[len(panels) // 2].set_xlabel("sources of one query")
    handles = [
        Line2D([], [], label=style.plain(s), color=looks[s].color, linestyle=looks[s].line,
               marker=looks[s].marker)
        for s in found
    ]  # fmt: skip
    style.legend_above(picture, handles, columns=6)
    return Drawing(
        title="Many sources in one query",
        caption=sentences(
            f"Distances to the nearest of several vertices, chosen at random, on {len(run.meshes)} "
            f"meshes. Left: the time of a solve without preparation, over that of {base} from one "
            "source: medians over repetitions, geometric means over the meshes, with 95% bootstrap intervals over "
            "repetitions. Middle and right: "
            "the mean of the mean errors, and the largest error on any mesh, of solvers that are "
            "not exact. A source with a computed distance other than 0 has no relative error.",
        ),
        figure=picture,
    )


def _draw(
    axes: Axes, label: str, looks: dict[str, style.SolverStyle], found: dict[str, list[Point]],
    value_of: Callable[[Point], float], estimate_of: Callable[[Point], Estimate] | None = None,
) -> None:  # fmt: skip
    for solver, of in found.items():
        drawn = [point for point in of if value_of(point) > 0]
        if drawn:
            look = looks[solver]
            axes.errorbar([p.sources for p in drawn], [value_of(p) for p in drawn],
                          yerr=style.bars([estimate_of(p) for p in drawn]) if estimate_of else None,
                          color=look.color, linestyle=look.line, elinewidth=1, marker=look.marker,
                          markersize=4.5)  # fmt: skip
    logarithmic(axes.xaxis, axes.yaxis)
    axes.set_title(label, fontsize=9.5)
    axes.grid()


def errors(run: Run) -> Table:
    """Returns mean errors by number of sources. @raises ResultError for the reasons of base_of()"""
    base = base_of(run)
    found = {solver: {p.sources: p.mean for p in points(run, solver, base)}
             for solver in columns(run) if not run.solvers[solver].exact}  # fmt: skip
    sizes_of_all = sorted({size for of in found.values() for size in of})
    return Table(
        name="many_sources_errors",
        title="Mean errors from many sources in one query",
        header=["Sources", *found],
        text_columns=0,
        rows=[[Field(count(size), size), *(Field(percent(of[size]), of[size]) if size in of else BLANK for of in found.values())]
              for size in sizes_of_all],
        remarks=["The mean over the meshes of the mean relative error of a vertex."],
    )  # fmt: skip


def table(run: Run) -> Table:
    """Returns a row per mesh, source and solver. @raises ResultError for the reasons of base_of()"""
    base = base_of(run)
    rows = []
    for mesh in run.meshes:
        for source in run.sources[mesh]:
            bases = answers_of(run, mesh, base, source)
            for solver in columns(run):
                fields = [Field(run.meshes[mesh].label), Field(str(source)),
                         Field(count(size := run.set_size(mesh, source)), size), Field(solver)]  # fmt: skip
                rows.append(fields + _numbers(answers_of(run, mesh, solver, source), bases))
    return Table(
        name="many_sources_numbers",
        title="Many sources in one query",
        header=["Mesh", "From", "Sources", "Solver", f"Time / {base}", "Largest error", "Mean error"],
        text_columns=2,
        rows=rows,
        remarks=[
            "Time of a solve without preparation over that of the base from the same sources: medians "
            "over repetitions, with 95% bootstrap intervals. Errors are relative; a source with a computed distance other than 0 has none.",
        ],
    )


def _numbers(rows: list[Row], bases: list[Row]) -> list[Field]:
    if not rows:
        return [Field("-")] * 3
    largest, means = error(rows, "max_relative_error"), error(rows, "mean_relative_error")
    errors = [Field(ERROR.show(largest), largest), Field(ERROR.show(means), means)]
    if not bases:
        return [Field("-"), *errors]
    ratio = geometric_mean_of_ratios([(times(bases), times(rows))])
    return [interval_field(ratio, number), *errors]
