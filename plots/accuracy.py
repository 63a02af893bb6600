"""Largest relative error per exact solver and mesh, against closed forms or another solver."""

from __future__ import annotations


from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator

from plots import style
from plots.dots import Dot, Dots, draw_dots, sentences, without_value
from plots.drawing import Drawing
from plots.measures import ERROR, columns
from results.reader import Run

BOUND = 1e-12
"""What an exact solver must keep to on clean meshes."""
FLOOR = 1e-17
"""Where distances without any error are drawn: a logarithmic axis has no 0."""


def largest(run: Run, mesh: str, solver: str) -> dict[bool, float]:
    """By whether the reference is the truth: the largest error over sources and repetitions."""
    errors: dict[bool, float] = {}
    for row in run.cell(mesh, solver):
        if ERROR.key in row.numbers:
            truth = row.against_truth
            errors[truth] = max(errors.get(truth, 0), row.numbers[ERROR.key])
    return errors


def figures(run: Run) -> list[Drawing]:
    def measured(mesh: str, solver: str) -> list[Dot]:
        places = [
            (max(error, FLOOR), not truth)
            for truth, error in sorted(largest(run, mesh, solver).items())
        ]
        return [Dot(place, place, place, hollow) for place, hollow in places]

    solvers = [s for s in columns(run) if s in run.solvers and run.solvers[s].exact]
    hollow = Line2D(
        [], [], marker="o", linestyle="", color=style.PALE, markerfacecolor="white",
        label="hollow: against a solver",
    )  # fmt: skip
    figure = draw_dots(run, Dots("largest relative error", solvers, measured), [hollow])
    axes = figure.axes[0]
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(LogLocator(numticks=20))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.0e}"))
    axes.set_xlim(left=FLOOR / 2, right=max(axes.get_xlim()[1], 4 * BOUND))
    axes.axvline(BOUND, color=style.INK, linewidth=1, linestyle=(0, (4, 2)))
    return [
        Drawing(
            name="accuracy",
            title="Accuracy of the exact solvers",
            caption=sentences(
                "Largest relative error over all vertices, sources and repetitions. Filled: "
                "against a closed form, which is the truth; hollow: against the distances of "
                "another solver, which the run file names. The dashed line is 1e-12, the bound "
                "on clean meshes; marks at 1e-17 are errors of 0 or below it. Upper bounds such "
                "as Dijkstra's are left out.",
                without_value(run, solvers),
            ),
            figure=figure,
        )
    ]
