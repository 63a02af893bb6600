#!/usr/bin/python3
"""The figure of a ranking: the candidate's time over each rival's, per mesh and on the mean."""

from __future__ import annotations

import sys
from pathlib import Path

import console  # noqa: F401  first: it tells what cannot be imported

import style
from command_line import Parser
from console import complain
from dots import SPREAD, solver_mark
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator, NullLocator
from rankings import Ranking, Ratio, read_ranking
from results import ResultError
from style import SolverStyle

WIDTH = 3.35
"""Inches: a column of a page with two."""
SMALL = 8
"""Points: the text of such a page's figures."""
DOT_INCHES, LEAST_ROW_INCHES = 0.085, 0.2
NARROW = 4.0
"""Ratios within this factor need more ticks than 1, 2 and 5."""
MEAN = "geometric mean"


def draw(ranking: Ranking) -> Figure:
    """@raises ResultError when the candidate could be timed against nobody"""
    rivals = ranking.rivals
    if not rivals:
        raise ResultError(f"{ranking.run.file}: {ranking.candidate} has no time beside a rival's")
    meshes = [mesh for mesh in ranking.run.meshes if any(one.on(mesh) for one in rivals)]
    rows = [*meshes, MEAN] if len(meshes) > 1 else meshes
    row_inches = max(LEAST_ROW_INCHES, DOT_INCHES * (len(rivals) + 1))
    figure = style.new_figure(0.9 + row_inches * max(len(rows), 2), WIDTH)
    axes = figure.subplots()
    styles = style.solver_styles(ranking.run.solvers)
    for index, rival in enumerate(rivals):
        look, shift = styles[rival.solver], SPREAD * ((index + 0.5) / len(rivals) - 0.5)
        for row, mesh in enumerate(meshes):
            if one := rival.on(mesh):
                axes.plot([one.least, one.most], [row + shift] * 2, color=look.color, lw=0.5)
                _mark(axes, row + shift, one.time, look)
        if rival.time and MEAN in rows:
            _mark(axes, len(meshes) + shift, rival.time, look)
    _rows(axes, rows)
    _scale(axes, ranking.candidate)
    handles = [solver_mark(rival.solver, styles[rival.solver]) for rival in rivals]
    if not all(one.time.resolved for rival in rivals for one in rival.meshes):
        handles.append(_hollow())
    for handle in handles:
        handle.set_markersize(4)
    style.legend_above(figure, handles, columns=4)
    return figure


def _mark(axes: Axes, y: float, ratio: Ratio, look: SolverStyle) -> None:
    axes.plot([ratio.low, ratio.high], [y, y], color=look.color, linewidth=1.8)
    axes.plot(
        [ratio.value], [y], marker=look.marker, markersize=4, linestyle="", color=look.color,
        markerfacecolor=look.color if ratio.resolved else "white", markeredgewidth=0.8, zorder=3,
    )  # fmt: skip


def _hollow() -> Line2D:
    return Line2D([], [], label="not resolved", marker="o", linestyle="", color=style.PALE,
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
    axes.set_xlabel(f"time of {candidate} / time of the other", fontsize=SMALL + 0.5)


def main(arguments: list[str] | None = None) -> int:
    parser = Parser(description=__doc__)
    parser.add_argument(
        "--rank", type=Path, metavar="DIR", required=True,
        help="folder of a ranking; rank.pdf and rank.png are written to it",
    )  # fmt: skip
    folder = parser.parse_args(arguments).rank
    try:
        figure = draw(read_ranking(folder))
        for extension in (".pdf", ".png"):
            style.save(figure, folder / f"rank{extension}")
    except (ResultError, OSError) as error:
        return complain(error)
    print(f"{folder / 'rank.pdf'} (also .png)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
