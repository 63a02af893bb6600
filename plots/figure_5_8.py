"""Figure 5.8: windows on the wavefront over the geodesic level, edge-based against FWP-MMP."""

from __future__ import annotations


import numpy as np
from plots import style
from plots.camera import Floats
from plots.curves import draw_curve, legend, models, solvers_of, title
from plots.dots import sentences
from plots.drawing import Drawing
from matplotlib.ticker import FuncFormatter, PercentFormatter
from plots.measures import EDGE_BASED, count
from plots.recordings import Recording
from results.reader import Run

RIVAL = "fwp-mmp"


def figures(run: Run) -> list[Drawing]:
    found = models(run, EDGE_BASED, RIVAL)
    solvers = solvers_of(run, found)
    figure = style.new_figure(0.7 + 2.4 * len(found))
    grid = figure.subplots(len(found), 2, squeeze=False, sharex=True)
    for panels, recording in zip(grid, found, strict=True):
        for axes, shown in zip(panels, ([RIVAL, EDGE_BASED], solvers), strict=True):
            for solver in shown:
                if solver in recording.solvers:
                    draw_curve(axes, run, solver, *levels_and_windows(recording, solver))
            axes.grid(True)
            axes.set_ylim(bottom=0)
            axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: count(value)))
        panels[0].set_title(title(recording.mesh), loc="left")
        panels[0].set_ylabel("windows on the wavefront")
    for axes in grid[-1]:
        axes.set_xlabel("geodesic level (of the greatest distance)")
        axes.xaxis.set_major_formatter(PercentFormatter(1))
        axes.set_xlim(0, 1)
    figure.get_layout_engine().set(wspace=0.06)
    legend(list(grid.flat), solvers)
    return [
        Drawing(
            name="figure_5_8",
            title="Figure 5.8: windows on the wavefront",
            caption=sentences(
                "Windows on the wavefront, at equal steps of the vertices reached, over the mean "
                f"distance of these windows. Left {RIVAL} and {EDGE_BASED} as in the thesis, "
                "right every solver that was recorded.",
                *(_claim(recording) for recording in found),
                "The thesis: close to each other, and most of the time fewer for its own.",
            ),
            figure=figure,
        )
    ]


def levels_and_windows(recording: Recording, solver: str) -> tuple[Floats, Floats]:
    """In the order of the levels, which are shares of the greatest distance."""
    curve = recording.curve(solver)
    order = np.argsort(curve["mean"], kind="stable")
    return curve["mean"][order] / recording.greatest, curve["windows"][order].astype(float)


def _claim(recording: Recording) -> str:
    levels, windows = levels_and_windows(recording, EDGE_BASED)
    rival_levels, rival_windows = levels_and_windows(recording, RIVAL)
    both = (levels >= rival_levels[0]) & (levels <= rival_levels[-1])
    rival = np.interp(levels[both], rival_levels, rival_windows)
    fewer = float(np.mean(windows[both] < rival))
    ratio = float(windows[both].sum() / rival.sum())
    agrees = "agrees with" if fewer > 0.5 else "does not agree with"
    return (
        f"On {recording.mesh.name} {EDGE_BASED} has fewer windows than {RIVAL} at {fewer:.0%} of "
        f"{np.count_nonzero(both)} levels, and {ratio:.2f} times as many on average, which "
        f"{agrees} the thesis."
    )
