"""Figure 5.10: how far apart the windows on the wavefront are, per solver and model."""

from __future__ import annotations


from plots.dots import AT_THE_EDGE, Dot, Dots, draw_dots, sentences, without_value
from plots.drawing import Drawing
from results.statistics import median
from plots.measures import Measure, by_source, columns, values
from results.reader import Run

SD = Measure("wavefront_sd_edges", "wavefront SD (mean edge lengths)", lambda value: f"{value:.3f}")


def figures(run: Run) -> list[Drawing]:
    def measured(mesh: str, solver: str) -> list[Dot]:
        sample = by_source(values(run, mesh, solver, SD))
        return [Dot.of(median(sample))] if sample else []

    solvers = [solver for solver in columns(run) if solver in run.solvers]
    figure = draw_dots(run, Dots(SD.label, solvers, measured))
    with_sd = [s for s in solvers if any(measured(mesh, s) for mesh in run.meshes)]
    return [
        Drawing(
            name="figure_5_10",
            title="Figure 5.10: wavefront quality",
            caption=sentences(
                "Standard deviation of the distances of all windows on the wavefront, mean over "
                "samples at fixed steps of progress, in mean edge lengths of the mesh; medians "
                "over sources with 95% bootstrap intervals. Smaller is a smoother wavefront. The "
                "thesis prints no numbers for it.",
                AT_THE_EDGE,
                without_value(run, with_sd),
            ),
            figure=figure,
        )
    ]
