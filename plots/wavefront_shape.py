"""Figures A.1 to A.5: the wavefront of one solver, on the same model at the same moment."""

from __future__ import annotations

from plots import style
from plots.dots import sentences
from plots.drawing import Drawing
from results.published import THESIS_SOLVERS
from plots.recordings import Recording, recordings
from results.reader import ResultError, Run
from plots.wavefronts import Lines, draw_wavefront

MOMENT = 50
"""Per cent of the vertices reached."""


def shape(run: Run, number: int, solver: str) -> Drawing:
    """@param number of the figure in the thesis's appendix"""
    recording = recordings(run)[0]
    if solver not in recording.solvers:
        raise ResultError(f"{run.file}: no recordings of {solver} on {recording.mesh.name}")
    look = style.solver_styles(run.solvers)[solver]
    lines = Lines(
        f"wavefront of {solver}", recording.wavefront(solver, MOMENT), look.color, 1.4
    )
    base = next(one for one in THESIS_SOLVERS if one in recording.solvers)
    pictures = draw_wavefront(recording, [lines], recording.wavefront(base, MOMENT))
    return Drawing(
        name=f"figure_a_{number}",
        title=f"Figure A.{number}: wavefront of {solver}",
        caption=sentences(
            f"Windows on the wavefront of {solver} on {recording.mesh.label} when {MOMENT}% of "
            "the vertices were reached; Figures A.1 to A.5 show the same moment from the same side.",
            _spread(recording, solver),
            pictures.sentence,
        ),
        figure=pictures.figure,
    )


def _spread(recording: Recording, solver: str) -> str:
    edge = recording.mesh.mean_edge_length
    spread = {
        one: float(recording.snapshot(one, MOMENT)["distance"].std()) / edge
        for one in THESIS_SOLVERS
        if one in recording.solvers
    }
    listed = ", ".join(
        f"{one} {spread[one]:.2f}" for one in sorted(spread, key=lambda one: spread[one])
    )
    return (
        f"The standard deviation of the {len(recording.snapshot(solver, MOMENT)):,} windows' "
        f"distances is {spread[solver]:.2f} mean edge lengths; from the smoothest: {listed}."
    )
