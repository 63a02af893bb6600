"""Figure 6.4: isolines of the distance field on several models."""

from __future__ import annotations

import math

from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.lines import Line2D

from plots import style
from plots.camera import Camera, framing
from plots.curves import title
from plots.drawing import Drawing
from plots.recordings import Recording, recordings
from plots.surface import best_axes, draw_lines, draw_surface
from plots.wavefronts import SOURCE, draw_source
from results.reader import Run

MODELS = 6
COLUMNS = 3
"""In one row; more models take two."""
TITLE_INCHES = 0.6
TALLEST = 1.1
"""Height of a panel in its widths."""
THICK = 5
"""Each line of this number is thick, as on a map."""
COLORS = colormaps["viridis"]
BRIGHTEST = 0.72
"""Part of the colour map in use: brighter colours cannot be read on the surface."""


def figure(run: Run) -> Drawing:
    found = recordings(run, isolines=True)[:MODELS]
    columns = len(found) if len(found) <= COLUMNS else math.ceil(len(found) / 2)
    rows = math.ceil(len(found) / columns)
    cameras = [_camera(recording) for recording in found]
    height = min(max(camera.height / camera.width for camera in cameras), TALLEST)
    inches = style.WIDTH / columns
    picture = style.new_figure(0.3 + rows * (TITLE_INCHES + inches * height))
    grid = picture.subplots(rows, columns, squeeze=False)
    panels = list(grid.flat)
    for axes in panels[len(found) :]:
        axes.remove()
    seen = [
        _draw(axes, recording, camera.of_shape(height), inches)
        for axes, recording, camera in zip(panels, found, cameras, strict=False)
    ]
    style.legend_above(picture, [Line2D([], [], label="source", **SOURCE)])
    hidden = [one.mesh.name for one, is_seen in zip(found, seen, strict=True) if not is_seen]
    return Drawing(
        title="Figure 6.4: isolines of the distance field",
        caption=_caption(found, hidden),
        figure=picture,
    )


def _camera(recording: Recording) -> Camera:
    surface, lines = recording.surface, recording.isolines.segments
    return framing(
        best_axes(recording.mesh, surface, lines, recording.source), surface.vertices
    )


def _draw(axes: Axes, recording: Recording, camera: Camera, inches: float) -> bool:
    """Returns whether the source is seen."""
    isolines = recording.isolines
    buffer = draw_surface(axes, recording.surface, camera, inches)
    levels = isolines.steps(recording.greatest)
    for number, level in enumerate(levels, 1):
        color = to_hex(COLORS(BRIGHTEST * level / levels[-1]))
        width = 0.9 if number % THICK == 0 else 0.45
        draw_lines(axes, buffer, isolines.at(level), color, width)
    axes.set_title(title(recording.mesh).replace(", ", "\n"), fontsize=9)
    return draw_source(axes, buffer, recording)


def _caption(found: list[Recording], hidden: list[str]) -> str:
    counts = ", ".join(
        f"{len(one.isolines.steps(one.greatest))} on {one.mesh.name}" for one in found
    )
    words = (
        "Lines of equal exact distance from the source, arcs of circles within each face, at "
        f"equal steps: {counts}. Every {THICK}th is thick; they go from dark blue near the source "
        "to green. Hidden lines are left out."
    )
    return words + (f" The source is hidden on {', '.join(hidden)}." if hidden else "")
