"""What Figures 5.8 and 5.10's curve share: something of the wavefront over progress, by solver."""

from __future__ import annotations

from collections.abc import Sequence

from plots import style
from plots.camera import Floats
from plots.dots import two_lines
from matplotlib.axes import Axes
from plots.measures import columns
from plots.recordings import Recording, recordings
from results.reader import Mesh, Run

MODELS = 2
BETWEEN_MARKS = 8
"""Samples; the solvers take turns, so that marks do not cover each other."""


def models(run: Run, *solvers: str) -> list[Recording]:
    """As many as a figure has. @raises ResultError as recordings does"""
    return recordings(run, *solvers)[:MODELS]


def solvers_of(run: Run, found: Sequence[Recording]) -> list[str]:
    """All that were recorded, in the order of the tables."""
    return [solver for solver in columns(run) if any(solver in one.solvers for one in found)]


def draw_curve(axes: Axes, run: Run, solver: str, x: Floats, y: Floats) -> None:
    look = style.solver_styles(run.solvers)[solver]
    first = columns(run).index(solver) * BETWEEN_MARKS // len(columns(run))
    axes.plot(
        x, y, label=solver, color=look.color, linestyle=look.line, marker=look.marker,
        markersize=3.8, markevery=(first, BETWEEN_MARKS),
    )  # fmt: skip


def title(mesh: Mesh) -> str:
    return f"{two_lines(mesh)}, {mesh.vertices:,} vertices"


def legend(axes: Sequence[Axes], solvers: Sequence[str]) -> None:
    """One over the figure, of everything that the axes show."""
    known = {line.get_label(): line for one in axes for line in one.lines}
    style.legend_above(axes[0].figure, [known[solver] for solver in solvers])
