"""The wavefront over progress: Figure 5.8 (number of windows) and the curve of 5.10 (their spread)."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, PercentFormatter

from plots import style
from plots.camera import Floats
from plots.dots import sentences, reach, two_lines
from plots.drawing import Drawing
from plots.measures import EDGE_BASED, columns, count
from plots.models import agreement, beside_thesis, of_thesis, titled
from plots.recordings import Recording, recordings
from results.published import THESIS_SOLVERS
from results.reader import Mesh, Run

RIVAL = "fwp-mmp"
SMOOTHEST = {"mmp", "ich"}
"""Solvers with the smoothest wavefronts according to the thesis."""
MODELS = 2
BETWEEN_MARKS = 8
"""Samples from one mark of a curve to the next. Each solver starts at another sample, so that marks
do not cover each other."""

THICKEST, THINNEST = 2.6, 0.9
"""Widths of the first and the last curve in points. A curve is visible beside a thinner one above it."""

TITLE_CHARACTERS = 40
"""Length that a line above a panel of half the page's width does not reach."""

Curve = Callable[[Recording, str], tuple[Floats, Floats]]


def windows(run: Run) -> Drawing:
    """Draws Figure 5.8. Without the thesis's two solvers it has only the panels of all recorded solvers.

    @raises ResultError without recordings"""
    pair = [RIVAL, EDGE_BASED]
    as_in_thesis = set(pair) <= set(run.solvers)
    found = (recordings(run, EDGE_BASED, RIVAL) if as_in_thesis else recordings(run))[:MODELS]
    kinds = {"all recorded": _solvers(run, found)}
    if as_in_thesis:
        kinds = {"as in the thesis" if of_thesis(run) else f"{RIVAL} and {EDGE_BASED}": pair} | kinds
    figure = style.new_figure(0.7 + 2.5 * len(found))
    grid = figure.subplots(len(found), len(kinds), squeeze=False, sharex=True)
    letters = iter("abcd")
    for panels, recording in zip(grid, found, strict=True):
        for axes, (which, shown) in zip(panels, kinds.items(), strict=True):
            _draw(axes, run, recording, shown, levels_and_windows)
            axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: count(value)))
            name = f"{title(recording.mesh)}\n" if axes is panels[0] else ""
            axes.set_title(f"{name}({next(letters)}) {which}", loc="left")
        panels[0].set_ylabel("windows on the wavefront")
    for axes in grid[-1]:
        axes.set_xlabel("geodesic level (of the greatest distance)")
    figure.get_layout_engine().set(wspace=0.06)
    _legend(list(grid.flat))
    return Drawing(
        title=titled(run, "Windows on the wavefront", "Figure 5.8"),
        caption=sentences(
            "Windows on the wavefront, at equal steps of the vertices reached, over the mean "
            "distance of these windows. The axis ends where a solver is far beyond the others.",
            *([f"Left {RIVAL} and {EDGE_BASED}{beside_thesis(run, ' as in the thesis')}, right every "
               "solver that was recorded.",
               *(_fewer(run, recording) for recording in found),
               beside_thesis(run, "In the thesis, the curves are close to each other, with fewer windows for its own solver most of the time.")]
              if as_in_thesis else []),
        ),
        figure=figure,
    )  # fmt: skip


def spread(run: Run) -> Drawing:
    """Draws the quantity of Figure 5.10 over progress. @raises ResultError without recordings"""
    found = recordings(run)[:MODELS]
    figure = style.new_figure(3.2)
    panels = figure.subplots(1, len(found), squeeze=False)[0]
    for axes, recording in zip(panels, found, strict=True):
        _draw(axes, run, recording, _solvers(run, found), progress_and_sd)
        axes.set_title(title(recording.mesh), loc="left")
        axes.set_xlabel("vertices reached")
    panels[0].set_ylabel("wavefront SD (mean edge lengths)")
    _legend(list(panels))
    return Drawing(
        title=titled(run, "Wavefront quality over progress", "Figure 5.10"),
        caption=sentences(
            "Standard deviation of the distances of the windows on the wavefront at equal steps of "
            "the vertices reached"
            f"{beside_thesis(run, '; Figure 5.10 shows its mean over the samples')}.",
            *(_smoothest(run, recording) for recording in found),
        ),
        figure=figure,
    )


def title(mesh: Mesh) -> str:
    name, size = two_lines(mesh), f"{mesh.vertices:,} vertices"
    together = len(name.rpartition("\n")[2]) + len(size) < TITLE_CHARACTERS
    return f"{name}, {size}" if together else f"{name},\n{size}"


def levels_and_windows(recording: Recording, solver: str) -> tuple[Floats, Floats]:
    """Returns the levels, as rising shares of the greatest distance, and the numbers of windows."""
    curve = recording.curve(solver)
    order = np.argsort(curve["mean"], kind="stable")
    return curve["mean"][order] / recording.greatest, curve["windows"][order].astype(float)


def progress_and_sd(recording: Recording, solver: str) -> tuple[Floats, Floats]:
    """Returns the shares of vertices reached, and the standard deviations in mean edge lengths."""
    curve, mesh = recording.curve(solver), recording.mesh
    return curve["reached"] / mesh.vertices, curve["sd"] / mesh.mean_edge_length


def _solvers(run: Run, recorded: Sequence[Recording]) -> list[str]:
    """Returns all recorded solvers in the order of the tables."""
    return [solver for solver in columns(run) if any(solver in one.solvers for one in recorded)]


def _draw(
    axes: Axes, run: Run, recording: Recording, solvers: Sequence[str], curve: Curve
) -> None:
    styles = style.solver_styles(run.solvers)
    curves = {solver: curve(recording, solver) for solver in solvers if solver in recording.solvers}
    for index, solver in enumerate(solvers):
        if solver in curves:
            look = styles[solver]
            first = index * BETWEEN_MARKS // len(solvers)
            width = THICKEST * (THINNEST / THICKEST) ** (index / max(len(solvers) - 1, 1))
            axes.plot(
                *curves[solver], label=style.plain(solver), color=look.color,
                linestyle=look.line, linewidth=width, marker=look.marker, markersize=3.8,
                markevery=(first, BETWEEN_MARKS),
            )  # fmt: skip
    axes.grid(True)
    limit = reach({solver: list(y) for solver, (_, y) in curves.items()})
    axes.set_ylim(0, min(axes.get_ylim()[1], limit))
    axes.set_xlim(0, 1)
    axes.xaxis.set_major_formatter(PercentFormatter(1))


def _legend(axes: Sequence[Axes]) -> None:
    """Draws one legend above the figure for all lines of the axes."""
    known = {line.get_label(): line for one in reversed(axes) for line in one.lines}
    style.legend_above(axes[0].figure, list(known.values()))


def _fewer(run: Run, recording: Recording) -> str:
    levels, windows = levels_and_windows(recording, EDGE_BASED)
    rival_levels, rival_windows = levels_and_windows(recording, RIVAL)
    both = (levels >= rival_levels[0]) & (levels <= rival_levels[-1])
    rival = np.interp(levels[both], rival_levels, rival_windows)
    fewer = float(np.mean(windows[both] < rival))
    ratio = float(windows[both].sum() / rival.sum())
    return (
        f"On {recording.mesh.name} {EDGE_BASED} has fewer windows than {RIVAL} at {fewer:.0%} of "
        f"{np.count_nonzero(both)} levels, and {ratio:.2f} times as many on average"
        f"{agreement(run, fewer > 0.5)}."
    )


def _smoothest(run: Run, recording: Recording) -> str:
    means = {
        solver: float(np.mean(progress_and_sd(recording, solver)[1]))
        for solver in THESIS_SOLVERS
        if solver in recording.solvers
    }
    order = sorted(means, key=lambda solver: means[solver])
    listed = ", ".join(f"{solver} {means[solver]:.2f}" for solver in order)
    if not set(means) >= SMOOTHEST:
        return f"Means on {recording.mesh.name}: {listed}."
    agrees = set(order[: len(SMOOTHEST)]) == SMOOTHEST
    words = agreement(run, agrees, ", where mmp and ich have the smallest")
    return f"Means on {recording.mesh.name}, from the smoothest: {listed}{words}."
