"""Figure 6.4: isolines of the distance field on several models."""

from __future__ import annotations

from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.lines import Line2D

from plots import style
from plots.camera import Camera
from plots.drawing import Drawing
from plots.panels import MODELS, panels
from plots.recordings import Recording, recordings
from plots.surface import draw_lines, draw_surface
from plots.wavefronts import SOURCE, draw_source
from results.reader import Run

THICK = 5
"""Each line of this number is thick, as on a map."""
COLORS = colormaps["viridis"]
BRIGHTEST = 0.72
"""Part of the colour map in use: brighter colours cannot be read on the surface."""


def figure(run: Run) -> Drawing:
    found = recordings(run, isolines=True)[:MODELS]
    picture, hidden = panels(found, lambda one: one.isolines.segments, _draw)
    style.legend_above(picture, [Line2D([], [], label="source", **SOURCE)])
    return Drawing(
        title="Figure 6.4: isolines of the distance field",
        caption=_caption(found) + hidden,
        figure=picture,
    )


def _draw(axes: Axes, recording: Recording, camera: Camera, inches: float) -> bool:
    isolines = recording.isolines
    buffer = draw_surface(axes, recording.surface, camera, inches)
    levels = isolines.steps(recording.greatest)
    for number, level in enumerate(levels, 1):
        color = to_hex(COLORS(BRIGHTEST * level / levels[-1]))
        width = 0.9 if number % THICK == 0 else 0.45
        draw_lines(axes, buffer, isolines.at(level), color, width)
    return draw_source(axes, buffer, recording)


def _caption(found: list[Recording]) -> str:
    counts = ", ".join(
        f"{len(one.isolines.steps(one.greatest))} on {one.mesh.name}" for one in found
    )
    return (
        "Lines of equal exact distance from the source, arcs of circles within each face, at "
        f"equal steps: {counts}. Every {THICK}th is thick; they go from dark blue near the source "
        "to green. Hidden lines are left out."
    )
