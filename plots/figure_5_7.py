"""Figure 5.7: the edge-based solver's wavefront against an isoline of the distance field."""

from __future__ import annotations


import numpy as np
from plots import style
from plots.dots import sentences
from plots.drawing import Drawing
from plots.measures import EDGE_BASED
from plots.recordings import MOMENTS, Recording, recordings
from results.reader import Run
from plots.wavefronts import Lines, draw_wavefront

NEAR = 2
"""Mean edge lengths; where 95% of the windows are within, the wavefront follows the isoline."""


def figures(run: Run) -> list[Drawing]:
    recording = recordings(run, EDGE_BASED)[0]
    moment, level = _moment(recording)
    wavefront = recording.wavefront(EDGE_BASED, moment)
    isoline = recording.isolines.at(level)
    pictures = draw_wavefront(
        recording,
        [
            Lines("isoline of the distance field", isoline, style.ISOLINE, 1.8),
            Lines("wavefront of edge-based", wavefront, style.WAVEFRONT, 1.2),
        ],
        wavefront,
    )
    return [
        Drawing(
            name="figure_5_7",
            title="Figure 5.7: wavefront and isoline",
            caption=sentences(
                f"Blue: windows on the wavefront of {EDGE_BASED} on {recording.mesh.label} when "
                f"{moment}% of the vertices were reached. Red: the exact isoline.",
                _claim(recording, moment, level),
                pictures.sentence,
            ),
            figure=pictures.figure,
        )
    ]


def _moment(recording: Recording) -> tuple[int, float]:
    """The moment whose mean distance is nearest to the level of an isoline, and that level."""
    levels = np.unique(recording.isolines.levels)
    means = {
        moment: float(recording.snapshot(EDGE_BASED, moment)["distance"].mean())
        for moment in MOMENTS
    }
    moment = min(means, key=lambda moment: float(np.abs(levels - means[moment]).min()))
    return moment, float(levels[np.abs(levels - means[moment]).argmin()])


def _claim(recording: Recording, moment: int, level: float) -> str:
    edge = recording.mesh.mean_edge_length
    distance = recording.snapshot(EDGE_BASED, moment)["distance"]
    mean = distance.mean()
    far = np.percentile(np.abs(distance - mean), 95) / edge
    agrees = "which agrees with" if far <= NEAR else "which is further than suits"
    return (
        f"Its level is {abs(level - mean) / edge:.2f} mean edge lengths from the mean distance of "
        f"the windows, and 95% of the windows are within {far:.2f} mean edge lengths of that "
        f"mean, {agrees} the thesis's claim that the wavefront is an approximate isoline."
    )
