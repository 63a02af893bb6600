"""A triangle mesh and its picture: a smoothly shaded image below vector lines, seen from the side that
shows most of these lines."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection

from plots.camera import Camera, Floats, framing, looking
from plots.zbuffer import NOTHING, Integers, ZBuffer, z_buffer
from results.reader import Mesh

PIXELS_PER_INCH = 400
"""Twice the resolution of a saved figure, which smooths the outline."""
CREASE = np.cos(np.radians(40))
"""Least cosine between the normals of a face and a vertex for which the corner is shaded smoothly."""
LIGHT = np.array([-0.45, 0.55, 0.7]) / np.linalg.norm([-0.45, 0.55, 0.7])
"""Unit vector towards the light, in camera coordinates."""
DARK, BRIGHT = np.array([0.50, 0.52, 0.56]), np.array([0.97, 0.965, 0.95])
"""Colours of a face that is turned away from the light, and of one that is turned towards it."""
UNDER_COLORS = 0.4
"""Share of a surface's colour that the shade does not darken, so that colours stay readable."""
UPRIGHT = {"horse": 2}
"""Axis that points up in the file, by model of the thesis; for other models it is y."""
FLAT = 0.35
"""A mesh whose height z is less than this share of its width and depth is a landscape."""
ELEVATION, ABOVE_A_LANDSCAPE = 18.0, 50.0
"""Elevation of the camera over most models, and over a landscape, in degrees."""
AZIMUTHS = np.arange(20.0, 360.0, 30.0)
"""Azimuths of the camera in degrees. None is along an axis, where models seem to have no depth."""
TRIAL_PIXELS = 160
SOURCE_COUNTS = 2.0
"""Factor by which a view that hides the source must show more of the lines than one that shows it."""


@dataclass(frozen=True)
class Surface:
    vertices: Floats
    """(n, 3)"""
    faces: Integers
    """(m, 3)"""

    @cached_property
    def face_normals(self) -> Floats:
        """Unit normals of the faces; 0 for a face without area."""
        return _unit(self._area_vectors)

    @cached_property
    def _area_vectors(self) -> Floats:
        a, b, c = (self.vertices[self.faces[:, i]] for i in range(3))
        vectors: Floats = np.cross(b - a, c - a)
        return vectors

    @cached_property
    def corner_normals(self) -> Floats:
        """Normals of the corners (m, 3, 3): those of the vertices or, beside a crease, of the face."""
        sums = np.zeros_like(self.vertices)
        for i in range(3):
            for axis in range(3):
                sums[:, axis] += np.bincount(
                    self.faces[:, i], self._area_vectors[:, axis], len(sums)
                )
        smooth = _unit(sums)[self.faces]
        flat = np.broadcast_to(self.face_normals[:, None], smooth.shape)
        agree = np.einsum("ijk,ijk->ij", smooth, flat) >= CREASE
        return np.where(agree[:, :, None], smooth, flat)


def sides(faces: Integers) -> Integers:
    """Returns the sides of each face in turn, as pairs of vertices (3 m, 2)."""
    return faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)


def edges(faces: Integers) -> Integers:
    """Returns each edge once, as pairs of vertices (n, 2) with the lesser one first."""
    return np.unique(np.sort(sides(faces), axis=1), axis=0)


def _unit(vectors: Floats) -> Floats:
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    units: Floats = vectors / np.where(lengths > 0, lengths, 1)
    return units


def shade(
    surface: Surface, buffer: ZBuffer, colors: Floats | None = None, *, blend: bool = True
) -> Floats:
    """Returns the picture (height, width, 3), row 0 lowest, white where there is no surface.
    @param colors of the vertices (n, 3); None: the surface is grey
    @param blend whether colours are interpolated within a face; if not, each point has the colour of
           the corner with the greatest barycentric coordinate"""
    image = np.ones((*buffer.face.shape, 3))
    y, x = np.nonzero(buffer.face != NOTHING)
    face = buffer.face[y, x]
    weights = buffer.weights(face, x + 0.5, y + 0.5)
    normals = np.einsum("ij,ijk->ik", weights, surface.corner_normals[face])
    normals = buffer.camera.project(_unit(normals))
    turned_away = surface.face_normals[face] @ buffer.camera.axes[2] < 0
    normals[turned_away] *= -1  # both sides are shaded alike
    bright = (0.5 + 0.5 * normals @ LIGHT) ** 1.2
    image[y, x] = DARK + bright[:, None] * (BRIGHT - DARK)
    if colors is not None:
        if not blend:
            weights = np.eye(3)[np.argmax(weights, axis=1)]
        own = np.einsum("ij,ijk->ik", weights, colors[surface.faces[face]])
        image[y, x] = np.clip(own * (UNDER_COLORS + (1 - UNDER_COLORS) * image[y, x]), 0, 1)
    return image


def draw_surface(
    axes: Axes, surface: Surface, camera: Camera, inches: float, colors: Floats | None = None,
    *, blend: bool = True,
) -> ZBuffer:  # fmt: skip
    """Fills the axes with the surface. Returns the depth buffer, which tells which lines are hidden.
    @param inches approximate width of the axes
    @param colors, blend as in shade()"""
    buffer = z_buffer(
        surface.vertices, surface.faces, camera, max(1, round(inches * PIXELS_PER_INCH))
    )
    axes.imshow(
        shade(surface, buffer, colors, blend=blend),
        extent=camera.extent, origin="lower", interpolation="antialiased",
    )  # fmt: skip
    axes.set_axis_off()
    return buffer


def draw_lines(axes: Axes, buffer: ZBuffer, segments: Floats, color: str, width: float) -> Floats:
    """Draws and returns the visible pieces of segments (n, 2, 3) on the surface.
    @param width in points"""
    pieces = buffer.visible_pieces(segments)
    axes.add_collection(
        LineCollection(pieces, colors=color, linewidths=width, capstyle="round"), autolim=False
    )
    return pieces


def best_axes(
    mesh: Mesh, surface: Surface, lines: Floats, source: int, up: int | None = None
) -> Floats:
    """Returns the axes of the camera that shows most of the lines (n, 2, 3) and, if possible, the source.

    @param up axis that points up; None: that of upwards()"""
    if up is None:
        up = upwards(mesh, surface)
    elevation = ABOVE_A_LANDSCAPE if _is_landscape(surface) else ELEVATION
    trials = [looking(up, azimuth, elevation) for azimuth in AZIMUTHS]
    return max(trials, key=lambda axes: _seen(axes, surface, lines, source))


def upwards(mesh: Mesh, surface: Surface) -> int:
    """Returns the axis that points up: 0 is x, 1 y, 2 z."""
    return 2 if _is_landscape(surface) else UPRIGHT.get(mesh.thesis_model or "", 1)


def _is_landscape(surface: Surface) -> bool:
    size = np.ptp(surface.vertices, axis=0)
    return bool(size[2] < FLAT * size[:2].min())


def _seen(axes: Floats, surface: Surface, lines: Floats, source: int) -> float:
    """Returns the visible length of the lines, times SOURCE_COUNTS if the source is visible."""
    camera = framing(axes, surface.vertices)
    width = max(1, round(TRIAL_PIXELS * camera.width / max(camera.width, camera.height)))
    buffer = z_buffer(surface.vertices, surface.faces, camera, width)
    pieces = buffer.visible_pieces(lines)
    length = float(np.linalg.norm(pieces[:, 1] - pieces[:, 0], axis=1).sum())
    seen = buffer.visible(surface.vertices[[source]])[0]
    return length * (SOURCE_COUNTS if seen else 1)
