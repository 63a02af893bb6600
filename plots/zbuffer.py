"""A depth buffer over the triangles of a surface, to hide surfaces and lines.

Every pixel stores the nearest face at its centre. Points are compared with the plane of this face
and not with the depth at the pixel's centre, so that a line on a steep face does not vanish.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plots.camera import Camera, Floats

Integers = NDArray[np.int64]

CHUNK = 1 << 21
"""Approximate number of pairs of face and pixel in a chunk; bounds the memory."""
NOTHING = -1
"""Marks a pixel without a face."""
TOLERANCE = 2.0
"""Largest distance in pixels behind a face at which a point still lies on the face."""
EDGE_ON = 1e-9
"""Square pixels; a face that appears smaller than this is seen edge-on."""
SEAM = 1e-6
"""Share of its size by which a face is enlarged, so that no pixel is lost between two faces."""
STEP = 2.0
"""Largest length in pixels of the pieces of a line that are hidden or shown."""


@dataclass(frozen=True)
class ZBuffer:
    camera: Camera
    pixel: float
    """Side of a pixel in the mesh's unit of length."""
    depths: Floats
    """(2, faces): depths of each face's farthest and nearest corner, in pixels."""
    maps: Floats
    """(3, 3, faces): the weights of a face's first and second corner, and the depth of its plane, each as
    a, b, c of a + b x + c y with x, y in pixels from the lower left corner."""
    face: Integers
    """(height, width): the nearest face at each pixel's centre, or NOTHING; row 0 is lowest."""

    def to_pixels(self, points: Floats) -> Floats:
        left, _, bottom, _ = self.camera.extent
        pixels: Floats = (self.camera.project(points) - [left, bottom, 0]) / self.pixel
        return pixels

    def visible(self, points: Floats) -> NDArray[np.bool_]:
        """Returns whether each point on the surface is inside the picture and not hidden by a face."""
        at = self.to_pixels(points)
        height, width = self.face.shape
        inside = (at[:, 0] >= 0) & (at[:, 0] < width) & (at[:, 1] >= 0) & (at[:, 1] < height)
        shown = np.zeros(len(points), bool)
        at = at[inside]
        around = np.floor(at[:, :2] - 0.5).astype(np.int64)
        free, before = np.ones(len(at), bool), np.zeros(len(at), bool)
        for offset in ([0, 0], [1, 0], [0, 1], [1, 1]):
            x, y = np.clip(around + offset, 0, [width - 1, height - 1]).T
            face = self.face[y, x]
            hit = face != NOTHING
            free &= ~hit
            before[hit] |= at[hit, 2] >= self._depth(face[hit], *at[hit, :2].T) - TOLERANCE
        shown[inside] = before | free
        return shown

    def weights(self, face: Integers, x: Floats, y: Floats) -> Floats:
        """Returns the barycentric coordinates (n, 3) in faces of points (x, y) in pixels."""
        first, second = (_value(self.maps[i], face, x, y) for i in range(2))
        return np.column_stack([first, second, 1 - first - second])

    def _depth(self, face: Integers, x: Floats, y: Floats) -> Floats:
        """Returns the depths of the faces' planes at (x, y), limited to the depths of the faces."""
        farthest, nearest = self.depths[:, face]
        within: Floats = np.clip(_value(self.maps[2], face, x, y), farthest, nearest)
        return within

    def visible_pieces(self, segments: Floats) -> Floats:
        """Returns the visible pieces (m, 2, 2), in camera coordinates, of segments (n, 2, 3) on the surface."""
        ends = self.to_pixels(segments.reshape(-1, 3)).reshape(-1, 2, 3)
        lengths = np.linalg.norm(ends[:, 1, :2] - ends[:, 0, :2], axis=1)
        steps = np.maximum(np.ceil(lengths / STEP), 1).astype(np.int64)
        owner, index = expand(steps)
        begin = index / steps[owner]
        middle = begin + 0.5 / steps[owner]
        first, along = segments[owner, 0], segments[owner, 1] - segments[owner, 0]
        shown = self.visible(first + middle[:, None] * along)
        # A run of visible steps of one segment is a piece.
        new = np.ones(len(owner), bool)
        new[1:] = (owner[1:] != owner[:-1]) | ~shown[:-1]
        starts = np.flatnonzero(shown & new)
        last = np.ones(len(owner), bool)
        last[:-1] = (owner[1:] != owner[:-1]) | ~shown[1:]
        stops = np.flatnonzero(shown & last)
        of = owner[starts]
        fractions = np.column_stack([begin[starts], (index[stops] + 1) / steps[of]])
        flat = self.camera.project(segments[of].reshape(-1, 3)).reshape(-1, 2, 3)[:, :, :2]
        pieces: Floats = flat[:, :1] + fractions[:, :, None] * (flat[:, 1:] - flat[:, :1])
        return pieces


def _value(function: Floats, face: Integers, x: Floats, y: Floats) -> Floats:
    """@param function (3, faces), one of `ZBuffer.maps`"""
    a, b, c = (one[face] for one in function)
    value: Floats = a + b * x + c * y
    return value


def _maps(corners: Floats) -> Floats:
    """Returns `ZBuffer.maps`. A face seen edge-on gets a negative weight, so that it has no pixel."""
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (corners[:, i].T for i in range(3))
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    flat = np.abs(area) < EDGE_ON
    scale = 1 / np.where(flat, 1, area)
    first = scale * np.stack([bx * cy - by * cx, by - cy, cx - bx])
    second = scale * np.stack([cx * ay - cy * ax, cy - ay, ax - cx])
    depth = (az - cz) * first + (bz - cz) * second
    depth[0] += cz
    first[:, flat] = [[-1], [0], [0]]
    return np.stack([first, second, depth])


def expand(counts: Integers) -> tuple[Integers, Integers]:
    """Returns owners and indices: for [2, 3], [0, 0, 1, 1, 1] and [0, 1, 0, 1, 2]."""
    owner = np.repeat(np.arange(len(counts)), counts)
    return owner, np.arange(len(owner)) - np.repeat(np.cumsum(counts) - counts, counts)


def z_buffer(vertices: Floats, faces: Integers, camera: Camera, width: int) -> ZBuffer:
    """@param width of the picture in pixels"""
    pixel = camera.width / width
    shape = (max(1, round(camera.height / pixel)), width)
    left, _, bottom, _ = camera.extent
    corners = ((camera.project(vertices) - [left, bottom, 0]) / pixel)[faces]
    maps = _maps(corners)
    nearest = np.full(shape, NOTHING, np.int64)
    depth = np.full(shape, -np.inf)
    for face, x, y in _pixels_in_boxes(corners, shape):
        first = _value(maps[0], face, x + 0.5, y + 0.5)
        second = _value(maps[1], face, x + 0.5, y + 0.5)
        inside = (first >= -SEAM) & (second >= -SEAM) & (first + second <= 1 + SEAM)
        face, x, y = face[inside], x[inside], y[inside]
        at = _value(maps[2], face, x + 0.5, y + 0.5)
        nearer = at > depth[y, x]
        face, x, y, at = face[nearer], x[nearer], y[nearer], at[nearer]
        order = np.argsort(at, kind="stable")  # the nearest face of a pixel is written last
        nearest[y[order], x[order]] = face[order]
        depth[y[order], x[order]] = at[order]
    depths = np.stack([corners[:, :, 2].min(axis=1), corners[:, :, 2].max(axis=1)])
    return ZBuffer(camera, pixel, depths, maps, nearest)


def _pixels_in_boxes(
    corners: Floats, shape: tuple[int, int]
) -> Iterator[tuple[Integers, Integers, Integers]]:
    """Yields, in chunks, face, x and y of the pixels whose centres lie in the box around the face."""
    flat = corners[:, :, :2]
    limit = np.array(shape[::-1])
    low = np.clip(np.ceil(flat.min(axis=1) - 0.5), 0, limit).astype(np.int64)
    high = np.clip(np.floor(flat.max(axis=1) + 0.5), 0, limit).astype(np.int64)
    size = np.maximum(high - low, 0)
    counts = size[:, 0] * size[:, 1]
    there = np.flatnonzero(counts)
    chunks = np.cumsum(counts[there]) // CHUNK
    for chunk in np.split(there, np.flatnonzero(np.diff(chunks)) + 1):
        owner, index = expand(counts[chunk])
        face = chunk[owner]
        x, y = low[face, 0] + index % size[face, 0], low[face, 1] + index // size[face, 0]
        yield face, x, y
