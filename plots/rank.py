"""The figure of a ranking: each solver's time over the candidate's, by mesh and on average.

The data come from gate/rank.py; this module only draws them.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from matplotlib.figure import Figure

from plots import style
from plots.dots import Dot, Row, draw_rows, hollow_mark
from plots.logarithmic import ratio_axis
from results.reader import ResultError

WIDTH = 3.35
"""Width of a column of a two-column page in inches."""
MEAN = "geometric mean"


def draw(
    candidate: str, meshes: Mapping[str, Mapping[str, Dot]], means: Mapping[str, Dot]
) -> Figure:
    """Draws the times of each solver over those of the candidate. A dot is hollow if the measurement
    does not decide which of the two is faster.

    @param meshes dots of the rows, by mesh and solver, without the candidate's own
    @param means geometric means over meshes, by solver; drawn as a row if there are several meshes
    @raises ResultError if there is no dot"""
    rows = [_row(style.plain(mesh), dots) for mesh, dots in meshes.items() if dots]
    solvers = list(dict.fromkeys(solver for row in rows for solver in row.dots))
    if not solvers:
        raise ResultError(f"{candidate} was timed against no other solver")
    if len(rows) > 1:
        rows.append(_row(MEAN, means, mean=True))
    hollow = any(dot.hollow for row in rows for dots in row.dots.values() for dot in dots)
    figure = draw_rows(
        rows, f"time / time of {style.plain(candidate)}", style.solver_styles(solvers),
        marks=[hollow_mark("undecided")] if hollow else [], width=WIDTH,
    )  # fmt: skip
    ratio_axis(figure.axes[0].xaxis)
    return figure


def _row(label: str, dots: Mapping[str, Dot], *, mean: bool = False) -> Row:
    return Row(label, {solver: [dot] for solver, dot in dots.items()}, mean=mean)


def write(figure: Figure, folder: Path) -> list[Path]:
    """Writes rank.pdf and rank.png; returns the files."""
    files = [folder / "rank.pdf", folder / "rank.png"]
    for file in files:
        style.save(figure, file)
    return files
