"""What Figures 5.7 and A.1 to A.5 share: lines on a model, whole and close up."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from plots import style
from plots.camera import Camera, Floats, close_up, framing
from plots.curves import title
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from plots.recordings import Recording
from scipy.ndimage import uniform_filter
from plots.surface import draw_lines, draw_surface
from plots.views import best_axes
from plots.zbuffer import NOTHING, ZBuffer

CLOSE_UP_EDGES = 24
"""Width of the close-up in mean edge lengths."""
CLOSE_UP_SHARE = 0.4
"""It is no wider than this share of the model."""
TALLEST = 3.6
"""Inches."""
SOURCE = {
    "marker": "o", "markersize": 5.5, "markerfacecolor": "white", "markeredgecolor": style.INK,
    "markeredgewidth": 1.2, "linestyle": "",
}  # fmt: skip


@dataclass(frozen=True)
class Lines:
    label: str
    segments: Floats
    """(n, 2, 3)"""
    color: str
    width: float
    """Points, in the close-up; half of it on the whole model."""


@dataclass(frozen=True)
class Pictures:
    figure: Figure
    close_up: float
    """Its width in mean edge lengths."""
    source_is_seen: bool

    @property
    def sentence(self) -> str:
        where = "" if self.source_is_seen else " The source is on the side that is turned away."
        return (
            f"Right: what the square on the left holds, {self.close_up:.0f} mean edge lengths "
            f"wide, with the edges of the mesh. Hidden lines are left out.{where}"
        )


def draw_wavefront(recording: Recording, layers: Sequence[Lines], about: Floats) -> Pictures:
    """@param about the segments that the view is to show, and the close-up a part of"""
    mesh, surface = recording.mesh, recording.surface
    axes = best_axes(mesh, surface, about, recording.source)
    whole = framing(axes, surface.vertices)
    ratio = whole.width / whole.height
    tall = min(style.WIDTH / (1 + ratio), TALLEST)
    figure = style.new_figure(tall + 0.5)
    left, right = figure.subplots(1, 2, width_ratios=[ratio, 1])
    buffer = draw_surface(left, surface, whole, tall * ratio)
    near = _close_up(recording, buffer, about)
    near_buffer = draw_surface(right, surface, near, tall)
    drawn_faces = surface.faces[np.unique(near_buffer.face[near_buffer.face != NOTHING])]
    edges = np.unique(np.sort(drawn_faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)), axis=0)
    draw_lines(right, near_buffer, surface.vertices[edges], style.PALE, 0.25)
    for lines in layers:
        draw_lines(left, buffer, lines.segments, lines.color, lines.width / 2)
        draw_lines(right, near_buffer, lines.segments, lines.color, lines.width)
    _outline(left, near)
    seen = draw_source(left, buffer, recording)
    left.set_title(title(mesh))
    handles = [
        Line2D([], [], label=one.label, color=one.color, linewidth=one.width) for one in layers
    ]
    style.legend_above(figure, handles + ([Line2D([], [], label="source", **SOURCE)] * seen))
    return Pictures(figure, near.width / mesh.mean_edge_length, seen)


def draw_source(axes: Axes, buffer: ZBuffer, recording: Recording) -> bool:
    """Marks the source where it is not hidden, and says whether."""
    point = recording.surface.vertices[[recording.source]]
    seen = bool(buffer.visible(point)[0])
    if seen:
        x, y, _ = buffer.camera.project(point)[0]
        axes.plot([x], [y], **SOURCE, clip_on=False, zorder=5)
    return seen


def _close_up(recording: Recording, buffer: ZBuffer, about: Floats) -> Camera:
    """Where the lines cross what faces the viewer most, over the whole width of the close-up."""
    whole = buffer.camera
    width = min(
        CLOSE_UP_EDGES * recording.mesh.mean_edge_length,
        CLOSE_UP_SHARE * min(whole.width, whole.height),
    )
    towards = np.abs(recording.surface.face_normals @ whole.axes[2])
    facing = np.where(buffer.face == NOTHING, 0, towards[buffer.face])
    facing = uniform_filter(facing, round(width / buffer.pixel), mode="constant")
    middles = about.mean(axis=1)
    seen = middles[buffer.visible(middles)]
    if not len(seen):
        seen = middles
    x, y, _ = np.floor(buffer.to_pixels(seen)).astype(np.int64).T
    height_pixels, width_pixels = facing.shape
    merit = facing[np.clip(y, 0, height_pixels - 1), np.clip(x, 0, width_pixels - 1)]
    return close_up(whole.axes, seen[np.argmax(merit)], width)


def _outline(axes: Axes, camera: Camera) -> None:
    left, _, bottom, _ = camera.extent
    axes.add_patch(
        Rectangle(
            (left, bottom), camera.width, camera.height, fill=False, edgecolor=style.INK,
            linewidth=0.8, zorder=4,
        )
    )  # fmt: skip
