"""Figures of many meshes: they show the spread over meshes, since a mark for each would be illegible."""

from __future__ import annotations

import numpy as np
from matplotlib.lines import Line2D

from plots import style
from plots.dots import sentences
from plots.drawing import Drawing
from plots.logarithmic import logarithmic, ratio_axis
from plots.measures import measured_solvers
from plots.ratios import fastest_exact, mean, over_each_mesh, plain
from plots.summary import QUANTILES
from results.pairs import all_times
from results.reader import ResultError, Run

BINS = 24
"""Number of bins of meshes by vertices, on a logarithmic axis."""
LEAST = 3
"""Least number of meshes in a bin."""


def overview(run: Run) -> Drawing:
    """Draws the spread of time ratios over meshes. @raises ResultError if no two solvers have a time"""
    base = fastest_exact(run)
    of = {solver: values for solver, values in over_each_mesh(run, base).items() if solver != base}
    if not of:
        raise ResultError(f"{run.file}: no solver has a time beside {base}'s")
    styles = style.solver_styles(run.solvers)
    picture = style.new_figure(0.9 + 0.34 * len(of))
    axes = picture.subplots()
    order = sorted(of, key=lambda solver: mean(of[solver]))
    for place, solver in enumerate(order):
        low, first, middle, third, high = np.quantile(of[solver], QUANTILES)
        color = styles[solver].color
        axes.plot([low, high], [place, place], color=color, linewidth=1)
        axes.plot([first, third], [place, place], color=color, linewidth=5, solid_capstyle="butt")
        axes.plot([middle], [place], "o", color="white", markeredgecolor=color, markersize=5)
        axes.plot([mean(of[solver])], [place], "|", color=style.INK, markersize=14)
        axes.annotate(plain(mean(of[solver])), (high, place), (5, 0), va="center",
                      textcoords="offset points", fontsize=8)  # fmt: skip
    axes.set_yticks(range(len(order)), [style.plain(solver) for solver in order])
    axes.set_ylim(len(order) - 0.4, -0.6)
    axes.margins(x=0.08)
    ratio_axis(axes.xaxis)
    axes.set_xlabel(f"time / {style.plain(base)}")
    return Drawing(
        title="Overview",
        caption=sentences(
            f"Each solver's time over that of {base}, on {len(run.meshes):,} meshes: thin lines hold 90% "
            "of the meshes, thick ones 50%, the circle is the median, the bar with the number the "
            "geometric mean. Ratios are paired by mesh, source and repetition; a mesh counts once."
        ),
        figure=picture,
    )


def over_vertices(run: Run) -> Drawing:
    """Draws times by size of the meshes. @raises ResultError if no solver has a time"""
    found = all_times(run)
    vertices = np.array([run.meshes[mesh].vertices for mesh in found.meshes], float)
    if not len(vertices):
        raise ResultError(f"{run.file}: nothing has a time")
    edges = np.geomspace(vertices.min(), vertices.max() * 1.001, BINS + 1)
    place = np.digitize(vertices, edges) - 1
    styles = style.solver_styles(run.solvers)
    picture = style.new_figure(4.4)
    axes = picture.subplots()
    handles = []
    for solver in measured_solvers(run):
        seconds = found.by_mesh(solver)
        bins = [
            (mean(vertices[own]), *np.quantile(seconds[own], (0.1, 0.5, 0.9)))
            for one in range(BINS)
            if (own := (place == one) & ~np.isnan(seconds)).sum() >= LEAST
        ]
        if not bins:
            continue
        at, low, middle, high = zip(*bins, strict=True)
        look = styles[solver]
        axes.fill_between(at, low, high, color=look.color, alpha=0.12, linewidth=0)
        mark = {"color": look.color, "marker": look.marker, "markersize": 3.5, "linestyle": look.line}
        axes.plot(at, middle, **mark)
        handles.append(Line2D([], [], label=style.plain(solver), **mark))
    logarithmic(axes.xaxis, axes.yaxis)
    axes.set_xlabel("vertices $n$")
    axes.set_ylabel("time of one solve (s)")
    axes.grid()
    style.legend_above(picture, handles, columns=5)
    return Drawing(
        title="Time against vertices",
        caption=sentences(
            f"Medians over meshes of a size, {len(found.meshes):,} meshes in all; a mesh counts by the "
            "geometric mean over its sources and repetitions. Bands hold 80% of the meshes."
        ),
        figure=picture,
    )
