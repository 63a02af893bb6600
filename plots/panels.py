"""Pictures of several models side by side, of the same height."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plots import style
from plots.camera import Camera, Floats, framing
from plots.curves import title
from plots.recordings import Recording
from plots.surface import best_axes

MODELS = 6
COLUMNS = 3
"""Largest number of panels in one row; more models take two rows."""
TITLE_INCHES = 0.6
LEGEND_INCHES = 0.3
TALLEST = 1.1
"""Largest height of a panel over its width."""

Draw = Callable[[Axes, Recording, Camera, float], bool]
"""Fills the axes, whose width is given in inches; returns whether the source is visible."""


def panels(
    found: Sequence[Recording], lines: Callable[[Recording], Floats], draw: Draw
) -> tuple[Figure, str]:
    """@param found at most MODELS
    @param lines segments (n, 2, 3); each model is seen from the side that shows most of them
    @return the figure, with room for a legend above, and a sentence on sources that are hidden"""
    columns = len(found) if len(found) <= COLUMNS else math.ceil(len(found) / 2)
    rows = math.ceil(len(found) / columns)
    cameras = [best_camera(recording, lines(recording)) for recording in found]
    height = min(max(camera.height / camera.width for camera in cameras), TALLEST)
    inches = style.WIDTH / columns
    picture = style.new_figure(LEGEND_INCHES + rows * (TITLE_INCHES + inches * height))
    hidden = []
    every = in_rows(picture, len(found), columns)
    for axes, recording, camera in zip(every, found, cameras, strict=True):
        if not draw(axes, recording, camera.of_shape(height), inches):
            hidden.append(recording.mesh.name)
        axes.set_title(title(recording.mesh).replace(", ", "\n"), fontsize=9)
    return picture, f" The source is hidden on {', '.join(hidden)}." if hidden else ""


def in_rows(picture: Figure, count: int, columns: int) -> list[Axes]:
    """Returns `count` axes in rows; the last row may have fewer than the others."""
    every = list(picture.subplots(math.ceil(count / columns), columns, squeeze=False).flat)
    for axes in every[count:]:
        axes.remove()
    return every[:count]


def best_camera(recording: Recording, lines: Floats) -> Camera:
    """Returns a camera on the side that shows most of the lines (n, 2, 3), with the whole model in view."""
    surface = recording.surface
    axes = best_axes(recording.mesh, surface, lines, recording.vertices[0])
    return framing(axes, surface.vertices)
