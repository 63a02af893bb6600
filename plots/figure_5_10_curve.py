"""Figure 5.10 over progress: how far apart the windows on the wavefront are, sample by sample."""

from __future__ import annotations


import numpy as np
from plots import style
from plots.camera import Floats
from plots.curves import draw_curve, legend, models, solvers_of, title
from plots.dots import sentences
from plots.drawing import Drawing
from matplotlib.ticker import PercentFormatter
from results.published import THESIS_SOLVERS
from plots.recordings import Recording
from results.reader import Run

SMOOTHEST = {"mmp", "ich"}
"""By the thesis."""


def figures(run: Run) -> list[Drawing]:
    found = models(run)
    solvers = solvers_of(run, found)
    figure = style.new_figure(3.2)
    panels = figure.subplots(1, len(found), squeeze=False)[0]
    for axes, recording in zip(panels, found, strict=True):
        for solver in solvers:
            if solver in recording.solvers:
                draw_curve(axes, run, solver, *progress_and_sd(recording, solver))
        axes.set_title(title(recording.mesh), loc="left")
        axes.set_xlabel("vertices reached")
        axes.xaxis.set_major_formatter(PercentFormatter(1))
        axes.set_xlim(0, 1)
        axes.set_ylim(bottom=0)
        axes.grid(True)
    panels[0].set_ylabel("wavefront SD (mean edge lengths)")
    legend(list(panels), solvers)
    return [
        Drawing(
            name="figure_5_10_curve",
            title="Figure 5.10 over progress: wavefront quality",
            caption=sentences(
                "Standard deviation of the distances of the windows on the wavefront at equal "
                "steps of the vertices reached; its mean over the samples is what Figure 5.10 "
                "has for this source.",
                *(_claim(recording) for recording in found),
            ),
            figure=figure,
        )
    ]


def progress_and_sd(recording: Recording, solver: str) -> tuple[Floats, Floats]:
    """Shares of the vertices, mean edge lengths."""
    curve = recording.curve(solver)
    mesh = recording.mesh
    return curve["reached"] / mesh.vertices, curve["sd"] / mesh.mean_edge_length


def _claim(recording: Recording) -> str:
    means = {
        solver: float(np.mean(progress_and_sd(recording, solver)[1]))
        for solver in THESIS_SOLVERS
        if solver in recording.solvers
    }
    order = sorted(means, key=lambda solver: means[solver])
    listed = ", ".join(f"{solver} {means[solver]:.2f}" for solver in order)
    if not set(means) >= SMOOTHEST:
        return f"Means on {recording.mesh.name}: {listed}."
    agrees = "agrees with" if set(order[: len(SMOOTHEST)]) == SMOOTHEST else "does not agree with"
    return (
        f"Means on {recording.mesh.name}, from the smoothest: {listed}, which {agrees} the "
        "thesis, where mmp and ich have the smallest."
    )
