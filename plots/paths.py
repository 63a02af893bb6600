"""Exact shortest paths from one source, and Voronoi cells of several sources, on several models."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D

from plots import style
from plots.camera import Camera, Floats
from plots.drawing import Drawing
from plots.panels import MODELS, panels
from plots.recordings import Recording, recordings
from plots.surface import draw_lines, draw_surface, sides
from plots.wavefronts import SOURCE, draw_points, draw_source
from results.reader import ResultError, Run

PATH = "#b3261e"
CELLS = (
    "#8ec6ea", "#f2b179", "#7fd0b5", "#e6a6c9", "#f0e27a", "#b9b4e4", "#c2c9a0", "#e88f86",
)  # fmt: skip
"""Colours of the cells in turn: Okabe and Ito's hues, so pale that shading stays visible."""
OF_NO_CELL = "#d9dadd"


def figure(run: Run) -> Drawing:
    """@raises ResultError without recorded paths"""
    found = [one for one in recordings(run) if one.has_paths][:MODELS]
    if not found:
        raise ResultError(f"{run.file}: no paths; a solver that traces them must be recorded")
    picture, hidden = panels(found, lambda one: np.concatenate(one.paths), _draw_paths)
    handles = [
        Line2D([], [], label="shortest path", color=PATH, linewidth=1.1),
        Line2D([], [], label="source", **SOURCE),
    ]
    style.legend_above(picture, handles)
    counts = ", ".join(f"{len(one.paths)} on {one.mesh.name}" for one in found)
    return Drawing(
        title="Shortest paths from one source",
        caption=(
            f"Exact shortest paths from the source to vertices all over the model: {counts}. Each "
            "is straight across every face and, unfolded, across every edge; it bends at vertices "
            f"only. Hidden lines are left out.{hidden}"
        ),
        figure=picture,
    )


def _draw_paths(axes: Axes, recording: Recording, camera: Camera, inches: float) -> bool:
    buffer = draw_surface(axes, recording.surface, camera, inches)
    draw_lines(axes, buffer, np.concatenate(recording.paths), PATH, 0.8)
    return draw_source(axes, buffer, recording)


def cells(run: Run) -> Drawing:
    """@raises ResultError without recorded cells"""
    found = [one for one in recordings(run) if one.has_cells][:MODELS]
    if not found:
        raise ResultError(f"{run.file}: no cells; a solver that traces paths must be recorded")
    picture, _ = panels(found, _borders, _draw_cells)
    style.legend_above(picture, [Line2D([], [], label="sources", **SOURCE)])
    counts = ", ".join(f"{len(one.cells.sources)} on {one.mesh.name}" for one in found)
    return Drawing(
        title="Voronoi cells of several sources",
        caption=(
            f"The vertices nearest to each of several sources, by exact distances: {counts}. A face "
            "between cells is divided among its corners. Sources on the far side are left out."
        ),
        figure=picture,
    )


def _borders(recording: Recording) -> Floats:
    """Returns the edges between cells."""
    every = sides(recording.surface.faces)
    owners = recording.cells.nearest[every]
    borders: Floats = recording.surface.vertices[every[owners[:, 0] != owners[:, 1]]]
    return borders


def _draw_cells(axes: Axes, recording: Recording, camera: Camera, inches: float) -> bool:
    nearest, sources = recording.cells.nearest, recording.cells.sources
    colors = np.array([to_rgb(color) for color in (*CELLS, OF_NO_CELL)])
    tinted = colors[np.where(nearest < len(sources), nearest % len(CELLS), len(CELLS))]
    buffer = draw_surface(axes, recording.surface, camera, inches, tinted, blend=False)
    draw_points(axes, buffer, recording.surface.vertices[sources])
    return True
