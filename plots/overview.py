"""One picture of a run: each solver's time over that of the edge-based one, and its windows."""

from __future__ import annotations

from collections import Counter

from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from plots import style
from plots.drawing import Drawing
from results.statistics import geometric_mean
from results.published import THESIS_SOLVERS
from plots.ratios import BY_KEY, Ratio
from results.reader import Mesh, ResultError, Run

RATIOS = [
    (BY_KEY["speed-up"], "time / time of edge-based"),
    (BY_KEY["propagations over the limit"], "window propagations / window limit"),
]
KINDS = {"the thesis's model": "full", "stand-in for one": "none", "other mesh": "small"}
"""How the mark of a mesh is drawn, by what the mesh is to the thesis."""


def kind(mesh: Mesh) -> str:
    model, stand_in, other = KINDS
    return other if mesh.thesis_model is None else stand_in if mesh.stand_in else model


def _mark(of: str, color: str) -> dict[str, object]:
    small = KINDS[of] == "small"
    return {
        "marker": "o",
        "linestyle": "",
        "color": color,
        "markersize": 2.5 if small else 5.5,
        "markerfacecolor": "white" if KINDS[of] == "none" else color,
    }


def draw_ratio(axes: Axes, run: Run, ratio: Ratio, label: str) -> None:
    """@raises ResultError when no solver has the ratio on any mesh."""
    solvers = [solver for solver in THESIS_SOLVERS if solver in run.solvers]
    for place, (solver, look) in enumerate(style.solver_styles(solvers).items()):
        means = {
            name: geometric_mean([sample]).value
            for name in run.meshes
            if (sample := ratio.measured(run, name, solver))
        }
        if not means:
            continue
        for name, mean in means.items():
            axes.plot([mean], [place], **_mark(kind(run.meshes[name]), look.color))
        mean = geometric_mean([[[mean] for mean in means.values()]]).value
        axes.plot([mean], [place], "|", color=style.INK, markersize=17, markeredgewidth=1.8)
        axes.annotate(
            f"{mean:.2f}", (mean, place), xytext=(0, 10), textcoords="offset points", ha="center"
        )
    if not axes.lines:
        raise ResultError(f"{run.file}: no verified cell has {ratio.label!r}")
    axes.set_yticks(range(len(solvers)), solvers)
    axes.set_ylim(-0.5, len(solvers) - 0.4)
    axes.axvline(1, color=style.GRID, zorder=0)
    axes.set_xlabel(label)


def figures(run: Run) -> list[Drawing]:
    figure = style.new_figure(3.2, width=8)
    panels = figure.subplots(1, len(RATIOS))
    for axes, (ratio, label) in zip(panels, RATIOS, strict=True):
        draw_ratio(axes, run, ratio, label)
    times, windows = panels
    windows.set_yticklabels([])
    times.set_xlim(left=0)
    counts = Counter(map(kind, run.meshes.values()))
    marks = [
        Line2D([], [], label=f"{name} ({counts[name]})", **_mark(name, style.INK))
        for name in KINDS
        if counts[name]
    ]
    mean = Line2D(
        [], [], linestyle="", label="geometric mean", marker="|", color=style.INK, markersize=11,
        markeredgewidth=1.8,
    )  # fmt: skip
    style.legend_above(figure, [*marks, mean])
    return [
        Drawing(
            name="overview",
            title="Overview",
            caption=(
                "Geometric means, a mark a mesh, of each solver's CPU time over that of the "
                "edge-based solver (left), and of window propagations over the window limit "
                "(right); ratios are paired by source and repetition. Hollow: a stand-in for a "
                "model of the thesis."
            ),
            figure=figure,
        )
    ]
