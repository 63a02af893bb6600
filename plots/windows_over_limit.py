"""Window propagations over the window limit, per solver and mesh; published beside ours."""

from __future__ import annotations


from results import published
from plots.dots import AT_THE_EDGE, Dot, Dots, draw_dots, sentences, without_value
from plots.drawing import Drawing
from results.statistics import geometric_mean
from plots.measures import columns
from plots.ratios import BY_KEY
from results.reader import Run

RATIO = BY_KEY["propagations over the limit"]


def figures(run: Run) -> list[Drawing]:
    def measured(mesh: str, solver: str) -> list[Dot]:
        sample = RATIO.measured(run, mesh, solver)
        return [Dot.of(geometric_mean([sample]))] if sample else []

    solvers = [solver for solver in columns(run) if solver in run.solvers]
    figure = draw_dots(run, Dots(RATIO.label, solvers, measured, RATIO.published, left=0.9))
    counting = [s for s in solvers if any(measured(mesh, s) for mesh in run.meshes)]
    return [
        Drawing(
            name="windows_over_limit",
            title="Window propagations over the window limit",
            caption=sentences(
                "Windows propagated across a face over the windows that MMP leaves on the edges: "
                "1 is a solver that propagates no window in vain. Geometric means over sources "
                "with 95% bootstrap intervals.",
                f"Thin diamonds: {published.citation()}, Table 5.2; hollow where a stand-in was "
                f"measured, so that they are context only. {RATIO.note}",
                AT_THE_EDGE,
                without_value(run, counting),
            ),
            figure=figure,
        )
    ]
