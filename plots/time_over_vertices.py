"""Time against vertices, both logarithmic, with the fitted exponents of table_growth."""

from __future__ import annotations


import numpy as np
from matplotlib.axis import Axis
from matplotlib.lines import Line2D

from plots import style
from plots.dots import sentences
from plots.drawing import Drawing
from plots.measures import columns
from results.reader import Run
from plots.table_growth import LEAST_MESHES, Point, exponent, grown

PLAIN = 1000
"""An axis with more than this between its ends shows powers of ten."""


def figures(run: Run) -> list[Drawing]:
    """@raises ResultError when no solver has enough meshes of different sizes"""
    all_series = grown(run)
    styles = style.solver_styles(run.solvers)
    figure = style.new_figure(4.4)
    axes = figure.subplots()
    handles = []
    for solver in [name for name in columns(run) if name in all_series]:
        points = all_series[solver]
        look = styles[solver]
        vertices = [point.mesh.vertices for point in points]
        times = [point.time for point in points]
        fit = exponent(points, times)
        mark = {"color": look.color, "marker": look.marker, "markersize": 4.5}
        axes.plot(vertices, times, linestyle="", **mark)
        axes.plot(*_line(points, float(fit.value or 0)), color=look.color, linestyle=look.line)
        label = f"{solver}: $n^{{{fit.value:.2f}}}$ [{fit.low:.2f}, {fit.high:.2f}]"
        handles.append(Line2D([], [], linestyle=look.line, label=label, **mark))
    for axis in (axes.xaxis, axes.yaxis):
        _logarithmic(axis)
    axes.set_xlabel("vertices $n$")
    axes.set_ylabel("CPU time of one solve (s)")
    axes.grid()
    style.legend_above(figure, handles, columns=2)
    meshes = {point.mesh.name for points in all_series.values() for point in points}
    short = [s for s in columns(run) if s in run.solvers and s not in all_series]
    return [
        Drawing(
            name="time_over_vertices",
            title="Time against vertices",
            caption=sentences(
                "Medians over sources and repetitions of each solver that counts windows, on "
                f"{len(meshes)} meshes; lines are least squares of the logarithms, with 95% "
                "intervals of the exponent. They describe these meshes and no bound, and mean "
                "most for a series of one surface (corpus growth): different surfaces of one "
                "size differ in time as well.",
                f"Without: {', '.join(short)} (fewer than {LEAST_MESHES} sizes with a time and a "
                "count of windows)."
                if short
                else "",
            ),
            figure=figure,
        )
    ]


def _logarithmic(axis: Axis) -> None:
    low, high = axis.get_data_interval()
    if high < PLAIN * low:
        style.plain_logarithmic(axis)
    else:
        axis.axes.set(**{f"{axis.axis_name}scale": "log"})


def _line(points: list[Point], slope: float) -> tuple[list[float], list[float]]:
    """Ends of the fitted line: least squares go through the means of the logarithms."""
    vertices = np.log([point.mesh.vertices for point in points])
    times = np.log([point.time for point in points])
    ends = np.array([vertices.min(), vertices.max()])
    return list(np.exp(ends)), list(np.exp(times.mean() + slope * (ends - vertices.mean())))
