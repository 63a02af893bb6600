"""Isolines of the distance field on several models, as in the thesis's Figure 6.4."""

from __future__ import annotations

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.lines import Line2D

from plots import style
from plots.camera import Camera
from plots.drawing import Drawing
from plots.isolines import STEPS, isolines
from plots.models import titled
from plots.panels import MODELS, panels
from plots.recordings import Recording, recordings
from plots.surface import draw_lines, draw_surface
from plots.wavefronts import SOURCE, draw_source
from results.reader import Run

THICK = 5
"""A line whose number is a multiple of this is thick, as on a map."""
COLORS = colormaps["viridis"]
BRIGHTEST = 0.72
"""Used share of the colour map: brighter colours are not legible on the surface."""


def figure(run: Run) -> Drawing:
    found = recordings(run)[:MODELS]
    picture, hidden = panels(found, lambda one: np.concatenate(isolines(one)), _draw)
    style.legend_above(picture, [Line2D([], [], label="source", **SOURCE)])
    return Drawing(
        title=titled(run, "Isolines of the distance field", "Figure 6.4"),
        caption=_caption() + hidden,
        figure=picture,
    )


def _draw(axes: Axes, recording: Recording, camera: Camera, inches: float) -> bool:
    buffer = draw_surface(axes, recording.surface, camera, inches)
    for number, line in enumerate(isolines(recording), 1):
        color = to_hex(COLORS(BRIGHTEST * number / (STEPS - 1)))
        width = 0.9 if number % THICK == 0 else 0.45
        draw_lines(axes, buffer, line, color, width)
    return draw_source(axes, buffer, recording)


def _caption() -> str:
    return (
        "Lines of equal distance from the source, from the exact distances of the vertices and "
        f"straight across each face: {STEPS - 1} on each model, at equal steps of its greatest "
        f"distance. Every {THICK}th is thick; they go from dark blue near the source to green. "
        "Hidden lines are left out."
    )
