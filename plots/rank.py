"""The figure of a ranking: each solver's time relative to the candidate's, per mesh and on the mean.

The data come from gate/rank.py; this module only draws them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator, NullLocator

from plots import style
from plots.dots import SPREAD, solver_mark
from plots.style import SolverStyle
from results.reader import ResultError
from results.statistics import Estimate

WIDTH = 3.35
"""Inches: a column of a page with two."""
SMALL = 8
"""Points: the text of such a page's figures."""
DOT_INCHES, LEAST_ROW_INCHES = 0.085, 0.2
NARROW = 4.0
"""Ratios within this factor need more ticks than 1, 2 and 5."""
MEAN = "geometric mean"


@dataclass(frozen=True)
class Mark:
    ratio: Estimate
    """Time of the solver / time of the candidate."""
    resolved: bool
    """Whether the measurement decides which of the two is faster; drawn hollow otherwise."""


def draw(
    candidate: str, meshes: Mapping[str, Mapping[str, Mark]], means: Mapping[str, Mark]
) -> Figure:
    """@param meshes the rows, by mesh: the marks by solver, without the candidate's own
    @param means the geometric means over meshes, by solver; a row of its own where there are
           several meshes
    @raises ResultError when there is no mark"""
    meshes = {mesh: marks for mesh, marks in meshes.items() if marks}
    solvers = list(dict.fromkeys(solver for marks in meshes.values() for solver in marks))
    if not solvers:
        raise ResultError(f"{candidate} was timed against no other solver")
    rows = meshes | ({MEAN: means} if len(meshes) > 1 else {})
    row_inches = max(LEAST_ROW_INCHES, DOT_INCHES * (len(solvers) + 1))
    figure = style.new_figure(0.9 + row_inches * max(len(rows), 2), WIDTH)
    axes = figure.subplots()
    styles = style.solver_styles(solvers)
    for row, marks in enumerate(rows.values()):
        for index, solver in enumerate(solvers):
            if solver in marks:
                y = row + SPREAD * ((index + 0.5) / len(solvers) - 0.5)
                _mark(axes, y, marks[solver], styles[solver])
    _rows(axes, list(rows))
    _scale(axes, candidate)
    handles = [solver_mark(solver, styles[solver]) for solver in solvers]
    if not all(mark.resolved for marks in rows.values() for mark in marks.values()):
        handles.append(_hollow())
    for handle in handles:
        handle.set_markersize(4)
    style.legend_above(figure, handles, columns=4)
    return figure


def write(figure: Figure, folder: Path) -> list[Path]:
    """Writes rank.pdf and rank.png; returns the files."""
    files = [folder / "rank.pdf", folder / "rank.png"]
    for file in files:
        style.save(figure, file)
    return files


def _mark(axes: Axes, y: float, mark: Mark, look: SolverStyle) -> None:
    ratio = mark.ratio
    axes.plot([ratio.least, ratio.most], [y, y], color=look.color, linewidth=0.5)
    axes.plot([ratio.low, ratio.high], [y, y], color=look.color, linewidth=1.8)
    axes.plot(
        [ratio.value], [y], marker=look.marker, markersize=4, linestyle="", color=look.color,
        markerfacecolor=look.color if mark.resolved else "white", markeredgewidth=0.8, zorder=3,
    )  # fmt: skip


def _hollow() -> Line2D:
    return Line2D([], [], label="undecided", marker="o", linestyle="", color=style.PALE,
                  markerfacecolor="white", markeredgewidth=0.8)  # fmt: skip


def _rows(axes: Axes, rows: list[str]) -> None:
    for row in range(1, len(rows), 2):
        axes.axhspan(row - 0.5, row + 0.5, color="#f4f4f4", linewidth=0, zorder=0)
    if rows[-1] == MEAN:
        axes.axhline(len(rows) - 1.5, color=style.INK, linewidth=0.7)
    axes.set_yticks(range(len(rows)), rows)
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.tick_params(axis="y", length=0)


def _scale(axes: Axes, candidate: str) -> None:
    style.plain_logarithmic(axes.xaxis)
    low, high = axes.get_xlim()
    low, high = min(low, 0.97), max(high, 1.03)
    if high < NARROW * low:
        axes.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 5, 10]))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.set_xlim(low, high)
    axes.axvline(1, color=style.INK, linewidth=0.8, zorder=1)
    axes.grid(axis="x")
    axes.tick_params(labelsize=SMALL)
    axes.set_xlabel(f"time / time of {candidate}", fontsize=SMALL + 0.5)
