#!/usr/bin/python3
"""Figure 6.4: isolines of the distance field on several models."""

from __future__ import annotations

import math
import sys

import numpy as np
import style
from camera import framing
from command_line import draw
from curves import title
from drawing import Drawing
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.lines import Line2D
from recordings import Recording, recordings
from results import Run
from surface import draw_lines, draw_surface
from views import best_axes
from wavefronts import SOURCE, draw_source

MODELS = 6
COLUMNS = 3
"""In one row; more models take two."""
ROW_INCHES = 2.5
THICK = 5
"""Every so many levels the line is thick, as on a map."""
COLORS = colormaps["viridis"]
BRIGHTEST = 0.72
"""Of the colours; what is brighter cannot be read on the surface."""


def figures(run: Run) -> list[Drawing]:
    found = recordings(run)[:MODELS]
    columns = len(found) if len(found) <= COLUMNS else math.ceil(len(found) / 2)
    rows = math.ceil(len(found) / columns)
    figure = style.new_figure(0.4 + ROW_INCHES * rows)
    grid = figure.subplots(rows, columns, squeeze=False)
    panels = list(grid.flat)
    for axes in panels[len(found) :]:
        axes.remove()
    seen = [
        _draw(axes, recording, style.WIDTH / columns)
        for axes, recording in zip(panels, found, strict=False)
    ]
    style.legend_above(figure, [Line2D([], [], label="source", **SOURCE)])
    hidden = [one.mesh.name for one, is_seen in zip(found, seen, strict=True) if not is_seen]
    return [
        Drawing(
            name="figure_6_4",
            title="Figure 6.4: isolines of the distance field",
            caption=_caption(found, hidden),
            figure=figure,
        )
    ]


def _draw(axes: Axes, recording: Recording, inches: float) -> bool:
    isolines = recording.isolines
    camera = framing(
        best_axes(recording.mesh, recording.surface, isolines.segments, recording.source),
        recording.surface.vertices,
    )
    buffer = draw_surface(axes, recording.surface, camera, inches)
    levels = np.unique(isolines.levels)
    for number, level in enumerate(levels, 1):
        color = to_hex(COLORS(BRIGHTEST * level / levels[-1]))
        width = 0.9 if number % THICK == 0 else 0.45
        draw_lines(axes, buffer, isolines.at(level), color, width)
    axes.set_adjustable("datalim")  # so that all panels have one size, and titles one line
    axes.set_title(title(recording.mesh).replace(", ", "\n"), fontsize=9)
    return draw_source(axes, buffer, recording)


def _caption(found: list[Recording], hidden: list[str]) -> str:
    counts = ", ".join(
        f"{len(np.unique(one.isolines.levels))} on {one.mesh.name}" for one in found
    )
    words = (
        "Lines of equal exact distance from the source, arcs of circles within each face, at "
        f"equal steps: {counts}. Every {THICK}th is thick; they go from dark blue near the source "
        "to green. Hidden lines are left out."
    )
    return words + (f" The source is hidden on {', '.join(hidden)}." if hidden else "")


if __name__ == "__main__":
    sys.exit(draw(__doc__, figures))
