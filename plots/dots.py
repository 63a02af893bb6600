"""What several figures share: a row a mesh, and in it a dot a solver with its 95% interval."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from plots import style
from results.statistics import Estimate
from plots.measures import failure
from plots.models import models
from results.published import THESIS_SOLVERS
from results.reader import Mesh, ResultError, Run
from plots.style import SolverStyle

DOT_INCHES = 0.07
LEAST_ROW_INCHES = 0.36
SPREAD = 0.8
"""Share of a row's height over which its solvers are spread."""
WIDE = 20
"""Values that differ by this factor need a logarithmic axis."""
FEW = 3
"""As many meshes are named in a caption, more are counted."""
BEYOND = 2.5
"""Values more than so many times the largest of the thesis's solvers are written at the edge."""


@dataclass(frozen=True)
class Dot:
    value: float
    low: float
    high: float
    hollow: bool = False

    @staticmethod
    def of(estimate: Estimate) -> Dot:
        return Dot(estimate.value, estimate.low, estimate.high)


@dataclass(frozen=True)
class Dots:
    """All of a figure but its words."""

    label: str
    """Of the axis."""
    solvers: Sequence[str]
    measured: Callable[[str, str], Sequence[Dot]]
    """By mesh and solver."""
    published: Callable[[str, str], float | None] = lambda model, solver: None
    """By the thesis's model and solver."""
    left: float = 0
    """Where a linear axis begins, unless a value is below."""


Rows = list[tuple[Mesh, dict[str, Sequence[Dot]]]]
"""By mesh, its dots by solver."""

AT_THE_EDGE = "A number with an arrow is a value far beyond the axis."


def ordered_meshes(run: Run) -> list[Mesh]:
    """The thesis's models and what stands for them in its order, then the others."""
    return [model.mesh for model in models(run) if model.mesh]


def two_lines(mesh: Mesh) -> str:
    return mesh.label.replace(" (", "\n(")


def draw_dots(run: Run, dots: Dots, marks: Sequence[Line2D] = ()) -> Figure:
    """@param marks further entries of the legend
    @raises ResultError when there is not one dot"""
    rows: Rows = [
        (mesh, found)
        for mesh in ordered_meshes(run)
        if (found := {s: d for s in dots.solvers if (d := dots.measured(mesh.name, s))})
    ]
    if not rows:
        raise ResultError(f"{run.file}: no verified cell has {dots.label!r}")
    styles = style.solver_styles(run.solvers)
    drawn = [solver for solver in dots.solvers if any(solver in found for _, found in rows)]
    row_inches = max(LEAST_ROW_INCHES, DOT_INCHES * len(drawn))
    figure = style.new_figure(1.1 + row_inches * max(len(rows), 2))
    axes = figure.subplots()
    offset = {s: SPREAD * ((i + 0.5) / len(drawn) - 0.5) for i, s in enumerate(drawn)}
    limit = _limit(rows)
    shown: list[float] = []
    contexts: set[bool] = set()
    for row, (mesh, found) in enumerate(rows):
        if row % 2:
            axes.axhspan(row - 0.5, row + 0.5, color="#f4f4f4", linewidth=0, zorder=0)
        for solver, places in found.items():
            y, look = row + offset[solver], styles[solver]
            inside = [dot for dot in places if dot.value <= limit]
            _draw_dots_of(axes, y, inside, look)
            for dot in places:
                if dot.value > limit:
                    _write_at_the_edge(axes, y, dot.value, look)
            shown += [dot.value for dot in inside]
            value = dots.published(mesh.thesis_model, solver) if mesh.thesis_model else None
            if value is not None:
                mark = style.published_mark(look.color, context=mesh.stand_in)
                axes.plot([value], [y], **mark)
                contexts.add(mesh.stand_in)
    axes.set_yticks(range(len(rows)), [two_lines(mesh) for mesh, _ in rows])
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel(dots.label)
    axes.grid(axis="x")
    _scale(axes, shown, dots.left)
    handles = [solver_mark(solver, styles[solver]) for solver in drawn]
    handles += [*marks, *published_marks(contexts)]
    style.legend_above(figure, handles)
    return figure


def _limit(rows: Rows) -> float:
    """The largest value that is drawn where it belongs: a solver that is none of the thesis's and
    far beyond them would squeeze them together. Infinity when none of them is there."""
    of_thesis = [
        dot.value
        for _, found in rows
        for solver, dots in found.items()
        if solver in THESIS_SOLVERS
        for dot in dots
    ]
    return BEYOND * max(of_thesis) if of_thesis else math.inf


def _write_at_the_edge(axes: Axes, y: float, value: float, look: SolverStyle) -> None:
    number = f"{value:,.0f}" if value >= 100 else f"{value:.3g}"
    axes.annotate(
        f"{number} \N{RIGHTWARDS ARROW}", (1, y), (-2, 0), ("axes fraction", "data"),
        textcoords="offset points", ha="right", va="center", fontsize=8, color=look.color,
    )  # fmt: skip


def _draw_dots_of(axes: Axes, y: float, dots: Sequence[Dot], look: SolverStyle) -> None:
    for dot in dots:
        if dot.high > dot.low:
            axes.plot([dot.low, dot.high], [y, y], color=look.color, linewidth=0.9, zorder=2)
        axes.plot([dot.value], [y], **_mark(look, hollow=dot.hollow), zorder=3)


def _mark(look: SolverStyle, *, hollow: bool) -> dict[str, Any]:
    return {
        "marker": look.marker,
        "linestyle": "",
        "color": look.color,
        "markerfacecolor": "white" if hollow else look.color,
        "markeredgewidth": 0.9,
    }


def solver_mark(solver: str, look: SolverStyle) -> Line2D:
    return Line2D([], [], label=solver, **_mark(look, hollow=False))


def published_marks(contexts: set[bool]) -> list[Line2D]:
    """Entries of the legend for the published numbers there are: of models, of stand-ins."""
    words = {False: "published", True: "published, a stand-in measured"}
    return [
        Line2D([], [], label=words[context], **style.published_mark(style.PALE, context=context))
        for context in sorted(contexts)
    ]


def _scale(axes: Axes, values: list[float], left: float) -> None:
    least = min((value for value in values if value > 0), default=0)
    if least and max(values) > WIDE * least:
        style.plain_logarithmic(axes.xaxis)
    else:
        axes.set_xlim(left=left if min(values) >= left else axes.get_xlim()[0])  # with a margin


def without_value(run: Run, solvers: Sequence[str]) -> str:
    """A sentence about every cell that failed, by solver and outcome; empty when there is none."""
    causes: dict[tuple[str, str], list[str]] = {}
    for mesh in ordered_meshes(run):
        for solver in solvers:
            failed = failure(run, mesh.name, solver)
            if failed is not None:
                causes.setdefault((solver, failed.text), []).append(mesh.name)
    listed = "; ".join(
        f"{solver}: {outcome} on {_named_or_counted(meshes)}"
        for (solver, outcome), meshes in causes.items()
    )
    return f"Without a value: {listed}." if listed else ""


def _named_or_counted(meshes: list[str]) -> str:
    return ", ".join(meshes) if len(meshes) <= FEW else f"{len(meshes)} meshes"


def sentences(*parts: str) -> str:
    return " ".join(part for part in parts if part)
