"""An orthographic camera on a surface.

Camera coordinates are (right, up, towards the viewer) in the mesh's unit of length.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

MARGIN = 0.02
"""Share of a picture's larger side that is left free around the model."""


@dataclass(frozen=True)
class Camera:
    axes: Floats
    """Three unit vectors as rows: right, up, towards the viewer."""
    center: tuple[float, float]
    """Centre of the picture in camera coordinates."""
    width: float
    height: float
    """Width and height of the picture in the mesh's unit of length."""

    def project(self, points: Floats) -> Floats:
        return points @ self.axes.T

    def of_shape(self, height: float) -> Camera:
        """Returns this camera with a picture enlarged so that its height over its width is `height`."""
        width = max(self.width, self.height / height)
        return replace(self, width=width, height=height * width)

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """left, right, bottom, top"""
        x, y = self.center
        return x - self.width / 2, x + self.width / 2, y - self.height / 2, y + self.height / 2


def looking(up: int, azimuth: float, elevation: float) -> Floats:
    """Returns the axes of a camera `azimuth` degrees around the axis `up` (0 is x, 1 y, 2 z) and
    `elevation` degrees, less than 90, above the horizon."""
    turn, rise = np.radians([azimuth, elevation])
    upwards, north, east = np.roll(np.eye(3), -up, axis=0)
    level = np.cos(turn) * east + np.sin(turn) * north
    towards = np.cos(rise) * level + np.sin(rise) * upwards
    right = np.cross(upwards, towards)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(towards, right), towards])


def framing(axes: Floats, points: Floats) -> Camera:
    """Returns the camera with these axes whose picture contains all points."""
    flat = points @ axes[:2].T
    low, high = flat.min(axis=0), flat.max(axis=0)
    middle, size = (low + high) / 2, high - low
    width, height = size + 2 * MARGIN * size.max()
    return Camera(axes, (float(middle[0]), float(middle[1])), float(width), float(height))


def close_up(axes: Floats, point: Floats, width: float) -> Camera:
    """Returns a camera whose picture is a square around a point."""
    x, y, _ = axes @ point
    return Camera(axes, (float(x), float(y)), width, width)
