"""How many times as fast as MMP each exact solver is, per mesh; published beside ours."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from results import published
from plots import style
from plots.dots import (
    ordered_meshes, published_marks, sentences, two_lines, without_value,
)  # fmt: skip
from plots.drawing import Drawing
from results.statistics import Estimate, geometric_mean
from plots.measures import LIMIT_SOLVER, TIME, columns
from plots.ratios import RIVAL, Ratio, over_meshes
from results.reader import ResultError, Run
from plots.style import SolverStyle

BASE = LIMIT_SOLVER
SPEEDUP = Ratio(
    "speed-up over mmp", f"speed-up over {BASE}: time of {BASE} / time", (BASE, TIME), (RIVAL, TIME)
)
BAR_INCHES = 0.125
CUT = 0.4
"""Bars are cut here, and the number beside them says how far they would go."""
NEAR = 1.3
"""A published mark within this factor of a bar's end is where its number would be."""
GAP = 1.2
"""Between groups, in bars."""


@dataclass(frozen=True)
class Bar:
    solver: str
    estimate: Estimate
    published: float | None = None


@dataclass(frozen=True)
class Group:
    label: str
    bars: list[Bar]
    stand_in: bool = False


def groups(run: Run, solvers: list[str]) -> list[Group]:
    """Each of the thesis's models and stand-ins (each mesh, when there are none of them), then
    the geometric means over these and over all meshes."""
    meshes = ordered_meshes(run)
    of_thesis = [mesh for mesh in meshes if mesh.thesis_model] or meshes
    found = []
    for mesh in of_thesis:
        bars = [
            Bar(solver, geometric_mean([sample]), _published(mesh.thesis_model, solver))
            for solver in solvers
            if (sample := SPEEDUP.measured(run, mesh.name, solver))
        ]
        found.append(Group(two_lines(mesh), bars, mesh.stand_in))
    models = [mesh.name for mesh in of_thesis if not mesh.stand_in]
    stand_ins = [mesh.name for mesh in of_thesis if mesh.stand_in]
    if len(models) > 1 and len(models) < len(meshes):
        found.append(_mean(run, f"{len(models)} models of the thesis", models, solvers))
    if len(stand_ins) > 1:
        found.append(_mean(run, f"{len(stand_ins)} stand-ins", stand_ins, solvers, stand_in=True))
    if len(meshes) > 1:
        found.append(_mean(run, f"all {len(meshes)} meshes", list(run.meshes), solvers))
    return [group for group in found if group.bars]


def _published(model: str | None, solver: str) -> float | None:
    return SPEEDUP.published(model, solver) if model else None


def _mean(
    run: Run, of: str, meshes: list[str], solvers: list[str], *, stand_in: bool = False
) -> Group:
    bars = [
        Bar(solver, mean.estimate)
        for solver in solvers
        if (mean := over_meshes(SPEEDUP, run, meshes, solver))
    ]
    return Group(f"geometric mean,\n{of}", bars, stand_in)


def figures(run: Run) -> list[Drawing]:
    """@raises ResultError when no exact solver can be compared with the base"""
    solvers = [
        s for s in columns(run) if s in run.solvers and s != BASE and run.solvers[s].exact
    ]
    found = groups(run, solvers)
    if not found:
        raise ResultError(f"{run.file}: no exact solver has a time beside {BASE}'s on a mesh")
    drawn = [s for s in solvers if any(bar.solver == s for group in found for bar in group.bars)]
    height = sum(len(group.bars) + GAP for group in found) * BAR_INCHES
    figure = style.new_figure(1.1 + max(height, 0.8))
    axes = figure.subplots()
    styles = style.solver_styles(run.solvers)
    contexts = _draw(axes, found, styles)
    handles: list[Any] = [
        Patch(label=solver, **_bar_look(styles[solver], pale=False)) for solver in drawn
    ]
    handles += [*_interval_mark(found), *published_marks(contexts)]
    style.legend_above(figure, handles)
    return [
        Drawing(
            name="speedup",
            title=f"Speed-up over {BASE}",
            caption=sentences(
                f"How many times as fast as {BASE} each exact solver is: geometric means of CPU "
                "time ratios paired by source and repetition, with 95% bootstrap intervals. "
                "White bars are stand-ins, other meshes than the thesis measured. "
                f"Diamonds: computed from {published.citation()}, Table 5.2; hollow beside a "
                "stand-in, where they are context only. A mean is over those of its meshes that "
                "have both times. A bar beside an arrow is cut short.",
                without_value(run, [BASE, *drawn]),
            ),
            figure=figure,
        )
    ]


def _draw(axes: Axes, found: list[Group], styles: dict[str, SolverStyle]) -> set[bool]:
    """Returns which kinds of published marks there are."""
    place, ticks, contexts = 0.0, [], set()
    for group in found:
        ticks.append(place + (len(group.bars) - 1) / 2)
        for bar in group.bars:
            _draw_bar(axes, place, bar, styles[bar.solver], pale=group.stand_in)
            if bar.published is not None:
                mark = style.published_mark(styles[bar.solver].color, context=group.stand_in)
                axes.plot([bar.published], [place], path_effects=style.RIM, **mark)
                contexts.add(group.stand_in)
            place += 1
        place += GAP
    axes.set_yticks(ticks, [group.label for group in found])
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(place - GAP, -1)
    style.plain_logarithmic(axes.xaxis)
    least = min(bar.estimate.value for group in found for bar in group.bars)
    axes.set_xlim(left=CUT / 2 if least < CUT else min(axes.get_xlim()[0], 0.8))
    axes.axvline(1, color=style.INK, linewidth=0.8)
    axes.grid(axis="x")
    axes.set_xlabel(SPEEDUP.label)
    return contexts


def _draw_bar(axes: Axes, place: float, bar: Bar, look: SolverStyle, *, pale: bool) -> None:
    value = bar.estimate.value
    end = max(value, CUT)
    axes.barh(place, end - 1, 0.9, 1, **_bar_look(look, pale=pale))
    if bar.estimate.high > bar.estimate.low and value == end:
        ends = [bar.estimate.low, bar.estimate.high]
        axes.plot(ends, [place, place], color="white", linewidth=3)
        axes.plot(ends, [place, place], color=style.INK, linewidth=1)
    slower = value < 1
    beside = max(CUT, bar.estimate.low) if slower else bar.estimate.high
    gap = 3
    if bar.published is not None and 1 / NEAR < bar.published / beside < NEAR:
        beside = (min if slower else max)(beside, bar.published)
        gap = 6
    axes.annotate(
        _number(value) if value == end else f"\N{LEFTWARDS ARROW} {_number(value)}",
        (beside, place), (-gap if slower else gap, 0), textcoords="offset points",
        ha="right" if slower else "left", va="center", fontsize=7,
    )  # fmt: skip


def _number(value: float) -> str:
    if value < 0.095:
        return f"{value:.1g}"
    return f"{value:.2f}" if value < 10 else f"{value:,.1f}"


def _bar_look(look: SolverStyle, *, pale: bool) -> dict[str, Any]:
    return {
        "facecolor": "white" if pale else look.color,
        "edgecolor": look.color if pale else "white",
        "hatch": look.hatch,
        "linewidth": 0.9 if pale else 0,
    }


def _interval_mark(found: list[Group]) -> list[Line2D]:
    """None when every cell was measured once."""
    estimates = [bar.estimate for group in found for bar in group.bars]
    if all(estimate.low == estimate.high for estimate in estimates):
        return []
    return [Line2D([], [], color=style.INK, linewidth=1, label="95% interval")]
