"""Rows of dots: a row for each mesh or mean, with a dot and its interval for each solver."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from plots import style
from plots.logarithmic import logarithmic
from plots.measures import columns, failure
from plots.models import ordered_meshes
from plots.ratios import number
from plots.style import SolverStyle
from results.published import THESIS_SOLVERS
from results.reader import Mesh, ResultError, Run
from results.statistics import Estimate

DOT_INCHES, NUMBER_INCHES = 0.07, 0.125
"""Height of a dot alone, and of one with its number."""
ROW_INCHES, SPREAD = 0.36, 0.8
"""Least height of a row, and the share of it over which its solvers are spread."""
WIDE = 20.0
"""Values that differ by a larger factor need a logarithmic axis."""
MOST_ROWS = 60
"""Largest number of meshes that a figure shows: more would not fit a page that can be read."""
FEW = 3
"""Largest number of meshes that a caption names; more are counted."""
NEAR = 1.3
"""If a published value is less than this factor above a dot, the dot's number is right of its mark."""
BEYOND = 2.5
"""Values above this multiple of the largest value of the thesis's solvers are numbers at the edge."""
AT_THE_EDGE = "A number with an arrow is a value far beyond the axis."


@dataclass(frozen=True)
class Dot:
    value: float
    low: float
    high: float
    hollow: bool = False
    range: tuple[float, float] | None = None
    """Least and greatest measured value, drawn as a thinner line than the interval."""
    note: str = ""
    """Text after the number."""

    @staticmethod
    def of(estimate: Estimate, *, hollow: bool = False, note: str = "") -> Dot:
        return Dot(estimate.value, estimate.low, estimate.high, hollow, note=note)


@dataclass(frozen=True)
class Row:
    label: str
    dots: Mapping[str, Sequence[Dot]]
    """Dots by solver."""
    published: Mapping[str, float] = field(default_factory=dict)
    """Published values by solver."""
    context: bool = False
    """Whether the mesh is a stand-in, so that published values are context only."""
    mean: bool = False
    """Whether the row is a mean over meshes. The first such row has a line above it."""


def two_lines(mesh: Mesh) -> str:
    """The mesh's label as a drawn text."""
    return style.plain(mesh.label).replace(" (", "\n(")


def styles_of(run: Run) -> dict[str, SolverStyle]:
    """Returns the styles of the solvers in the order in which they are drawn."""
    styles = style.solver_styles(run.solvers)
    return {solver: styles[solver] for solver in columns(run)}


def mesh_rows(
    run: Run,
    label: str,
    solvers: Sequence[str],
    measured: Callable[[str, str], Sequence[Dot]],
    published: Callable[[str, str], float | None] = lambda model, solver: None,
) -> list[Row]:
    """Returns a row for each mesh that has a dot. Of more than MOST_ROWS meshes, those with the least and
    the greatest values remain, with a row that counts the others.

    @param measured returns the dots of a mesh and a solver
    @param published returns the value of a model of the thesis and a solver
    @raises ResultError if there is no dot"""
    rows = []
    for mesh in ordered_meshes(run):
        dots = {s: found for s in solvers if (found := measured(mesh.name, s))}
        of_thesis = {s: published(mesh.thesis_model, s) for s in dots} if mesh.thesis_model else {}
        known = {s: value for s, value in of_thesis.items() if value is not None}
        if dots:
            rows.append(Row(two_lines(mesh), dots, known, mesh.stand_in))
    if not rows:
        raise ResultError(f"{run.file}: no verified cell has {label!r}")
    if len(rows) <= MOST_ROWS:
        return rows
    rows.sort(key=lambda row: max(dot.value for dots in row.dots.values() for dot in dots))
    half = MOST_ROWS // 2
    return [*rows[:half], Row(f"{len(rows) - 2 * half:,} meshes between,\nleft out", {}), *rows[-half:]]


def draw_rows(
    rows: Sequence[Row],
    label: str,
    styles: Mapping[str, SolverStyle],
    *,
    marks: Sequence[Line2D] = (),
    left: float = 0,
    width: float = style.WIDTH,
    numbers: bool = False,
    in_sight: float = 0,
) -> Figure:
    """@param rows at least one; each has a dot
    @param label of the axis
    @param styles in the order in which the solvers are drawn
    @param marks further entries of the legend
    @param left begin of a linear axis, unless a value is smaller
    @param numbers whether each value is written beside its dot
    @param in_sight every value up to this one is drawn on the axis and not at the edge"""
    drawn = [solver for solver in styles if any(solver in row.dots for row in rows)]
    pitch = NUMBER_INCHES if numbers else DOT_INCHES
    row_inches = max(ROW_INCHES * min(1, width / style.WIDTH * 1.05), pitch * (len(drawn) + 1))
    figure = style.new_figure(1.1 + row_inches * max(len(rows), 2), width)
    axes = figure.subplots()
    limit = math.inf if numbers else max(_limit(rows), in_sight)
    for place, row in enumerate(rows):
        if place % 2:
            axes.axhspan(place - 0.5, place + 0.5, color="#f4f4f4", linewidth=0, zorder=0)
        for index, solver in enumerate(drawn):
            y = place + SPREAD * ((index + 0.5) / len(drawn) - 0.5)
            known = row.published.get(solver, -math.inf)
            for dot in row.dots.get(solver, []):
                _draw_dot(axes, y, dot, styles[solver], limit=limit)
                if numbers:
                    beside = known if 1 < known / dot.high < NEAR else dot.high
                    axes.annotate(
                        number(dot.value) + dot.note, (beside, y), (4, 0), va="center",
                        textcoords="offset points", fontsize=7,
                    )  # fmt: skip
            if solver in row.published:
                mark = style.published_mark(styles[solver].color, context=row.context)
                axes.plot([known], [y], **mark)
    means = [place for place, row in enumerate(rows) if row.mean]
    if means and means[0]:
        axes.axhline(means[0] - 0.5, color=style.INK, linewidth=0.7)
    axes.set_yticks(range(len(rows)), [row.label for row in rows])
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel(label)
    axes.grid(axis="x")
    values = [dot.value for row in rows for dots in row.dots.values() for dot in dots]
    _scale(axes, [value for value in values if value <= limit], left)
    handles = [_solver_mark(solver, styles[solver]) for solver in drawn]
    contexts = {row.context for row in rows if row.published}
    style.legend_above(figure, [*handles, *marks, *_published_marks(contexts)])
    return figure


def hollow_mark(label: str) -> Line2D:
    return Line2D([], [], marker="o", linestyle="", color=style.PALE, markerfacecolor="white",
                  label=label)  # fmt: skip


def _limit(rows: Sequence[Row]) -> float:
    """Returns the largest value that is drawn on the axis; a far larger value of another solver would
    squeeze the thesis's solvers together. Infinite without a solver of the thesis."""
    return reach({
        s: [dot.value for row in rows for dot in row.dots.get(s, [])] for s in THESIS_SOLVERS
    })  # fmt: skip


def reach(values: Mapping[str, Sequence[float]]) -> float:
    """@param values by solver
    @return the largest value that a figure shows on its axis; infinite without a solver of the thesis"""
    of_thesis = [value for s in THESIS_SOLVERS for value in values.get(s, [])]
    return BEYOND * max(of_thesis) if of_thesis else math.inf


def _draw_dot(axes: Axes, y: float, dot: Dot, look: SolverStyle, *, limit: float) -> None:
    if dot.value > limit:
        axes.annotate(
            f"{number(dot.value)} \N{RIGHTWARDS ARROW}", (1, y), (-2, 0),
            ("axes fraction", "data"), textcoords="offset points", ha="right", va="center",
            fontsize=8, color=look.color,
        )  # fmt: skip
        return
    if dot.range:
        axes.plot(dot.range, [y, y], color=look.color, linewidth=0.5)
    if dot.high > dot.low:
        axes.plot([dot.low, dot.high], [y, y], color=look.color, linewidth=1.5, zorder=2)
    axes.plot([dot.value], [y], **_mark(look, hollow=dot.hollow), zorder=3)


def _mark(look: SolverStyle, *, hollow: bool) -> dict[str, Any]:
    return {
        "marker": look.marker,
        "linestyle": "",
        "color": look.color,
        "markersize": 4.5,
        "markerfacecolor": "white" if hollow else look.color,
        "markeredgewidth": 0.9,
    }


def _solver_mark(solver: str, look: SolverStyle) -> Line2D:
    return Line2D([], [], label=style.plain(solver), **_mark(look, hollow=False))


def _published_marks(contexts: set[bool]) -> list[Line2D]:
    """Returns legend entries for the published numbers of models and those beside stand-ins."""
    words = {False: "published", True: "published, a stand-in measured"}
    return [
        Line2D([], [], label=words[context], **style.published_mark(style.PALE, context=context))
        for context in sorted(contexts)
    ]


def _scale(axes: Axes, values: list[float], left: float) -> None:
    """Makes the horizontal axis logarithmic for a wide range of values; else it begins at `left`."""
    least = min((value for value in values if value > 0), default=0)
    if least and max(values) > WIDE * least:
        logarithmic(axes.xaxis)
    else:
        axes.set_xlim(left=left if min(values) >= left else axes.get_xlim()[0])  # with a margin


def without_value(run: Run, solvers: Sequence[str]) -> str:
    """Returns a sentence that lists the failed cells by solver and outcome; empty without any."""
    causes: dict[tuple[str, str], list[str]] = {}
    for mesh in ordered_meshes(run):
        for solver in solvers:
            failed = failure(run, mesh.name, solver)
            if failed is not None:
                causes.setdefault((solver, failed.text), []).append(mesh.name)
    listed = "; ".join(
        f"{solver}: {outcome} on "
        + (", ".join(meshes) if len(meshes) <= FEW else f"{len(meshes)} meshes")
        for (solver, outcome), meshes in causes.items()
    )
    return f"Without a value: {listed}." if listed else ""


def sentences(*parts: str) -> str:
    return " ".join(part for part in parts if part)
