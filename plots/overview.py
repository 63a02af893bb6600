"""One picture of a run: each exact solver's time over that of the fastest one, and its windows."""

from __future__ import annotations

import math
from collections import Counter

from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from plots import style
from plots.dots import sentences
from plots.drawing import Drawing
from plots.logarithmic import ratio_axis
from plots.measures import measured_solvers
from plots.ratios import BELOW_1, BY_KEY, Ratio, fastest_exact, mean, number, over_each_mesh, over_meshes, time_over
from results.reader import Mesh, ResultError, Run

KINDS = {"the thesis's model": "full", "stand-in for one": "none", "other mesh": "small"}
"""Kind of a mesh's mark, by the relation of the mesh to the thesis."""


def kind(mesh: Mesh) -> str:
    model, stand_in, other = KINDS
    return other if mesh.thesis_model is None else stand_in if mesh.stand_in else model


def figure(run: Run) -> Drawing:
    """@raises ResultError when no solver has a time"""
    base = fastest_exact(run)
    solvers = [solver for solver in measured_solvers(run) if run.solvers[solver].exact]
    ratios = [time_over(base), BY_KEY["propagations over the limit"]]
    by_time = over_each_mesh(run, base)
    few = [s for s in solvers if 0 < len(by_time.get(s, ())) < len(run.meshes) / 2]
    solvers = [solver for solver in solvers if solver not in few]
    solvers.sort(key=lambda s: mean(by_time[s]) if s in by_time else math.inf)
    by_solver = [{s: _means(run, ratio, s) for s in solvers} for ratio in ratios]
    both = zip(ratios, by_solver, strict=True)
    panels = [(ratio, means) for ratio, means in both if any(means.values())]
    if not panels:
        raise ResultError(f"{run.file}: no solver has a time beside {base}'s")
    picture = style.new_figure(1.2 + 0.4 * len(solvers), width=4 * len(panels))
    axes = picture.subplots(1, len(panels), squeeze=False)[0]
    for one, (ratio, means) in zip(axes, panels, strict=True):
        _draw(one, run, ratio, means)
        one.margins(x=0.08)
        ratio_axis(one.xaxis)
        one.set_xlabel(style.plain(ratio.label[0].lower() + ratio.label[1:]))
        if one is not axes[0]:
            one.set_yticklabels([])
    counts = Counter(map(kind, run.meshes.values()))
    marks = [
        Line2D([], [], label=f"{name if len(counts) > 1 else 'mesh'} ({counts[name]})", **_mark(name, style.INK))
        for name in KINDS
        if counts[name]
    ]
    bar = Line2D(
        [], [], linestyle="", label="geometric mean", marker="|", color=style.INK, markersize=11,
        markeredgewidth=1.8,
    )  # fmt: skip
    style.legend_above(picture, [*marks, bar])
    both_panels = len(panels) > 1
    return Drawing(
        title="Overview",
        caption=sentences(
            "Geometric means of each exact solver's CPU time over that of "
            f"{base}{' (left), and of window propagations over the window limit (right)' * both_panels}. "
            "A mark is one mesh; ratios are paired by source and repetition. The number is the mean over the meshes "
            "that have a mark; the line is its 95% bootstrap interval over sources and repetitions.",
            BELOW_1
            if both_panels
            else "No window propagations over the window limit: the run has no solver of the MMP family.",
            f"Not drawn, since it is on less than half of the meshes: {', '.join(few)}." if few else "",
            "Hollow: a stand-in for a model of the thesis." if counts["stand-in for one"] else "",
        ),
        figure=picture,
    )


def _means(run: Run, ratio: Ratio, solver: str) -> dict[str, float]:
    """Returns the mean ratio of each mesh that has one."""
    return {
        name: found.value for name in run.meshes if (found := ratio.mean(run, name, solver))
    }


def _mark(kind_of_mesh: str, color: str) -> dict[str, object]:
    small = KINDS[kind_of_mesh] == "small"
    return {
        "marker": "o",
        "linestyle": "",
        "color": color,
        "markersize": 2.5 if small else 5.5,
        "markerfacecolor": "white" if KINDS[kind_of_mesh] == "none" else color,
    }


def _draw(axes: Axes, run: Run, ratio_of: Ratio, means: dict[str, dict[str, float]]) -> None:
    styles = style.solver_styles(run.solvers)
    for place, (solver, by_mesh) in enumerate(means.items()):
        for name, ratio in by_mesh.items():
            axes.plot([ratio], [place], **_mark(kind(run.meshes[name]), styles[solver].color))
        if by_mesh:
            middle = mean(list(by_mesh.values()))
            axes.plot([middle], [place], "|", color=style.INK, markersize=17, markeredgewidth=1.8)
            found = over_meshes(ratio_of, run, list(by_mesh), solver)
            if found:
                axes.errorbar([middle], [place], xerr=style.bars([found.estimate]), color=style.INK, elinewidth=1)
            axes.annotate(
                number(middle), (middle, place), (0, 10), textcoords="offset points", ha="center"
            )
    axes.set_yticks(range(len(means)), [style.plain(solver) for solver in means])
    axes.set_ylim(len(means) - 0.5, -0.6)
