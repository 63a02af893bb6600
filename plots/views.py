"""Which way to look at a model: standing upright, and from the side that shows most of the lines
that the picture is about."""

from __future__ import annotations

import numpy as np
from plots.camera import Floats, framing, looking
from results.reader import Mesh
from plots.surface import Surface
from plots.zbuffer import z_buffer

UPRIGHT = {"horse": 2}
"""Axis that points up in the file, by thesis's model; y in most others."""
FLAT = 0.35
"""A mesh whose height z is less than this share of its width and depth is a landscape."""
ELEVATION, ABOVE_A_LANDSCAPE = 18.0, 50.0
"""Degrees."""
AZIMUTHS = np.arange(20.0, 360.0, 30.0)
"""Degrees; none looks along an axis, where models lose their depth."""
TRIAL_PIXELS = 160
SOURCE_COUNTS = 2.0
"""So many times more must be seen of the lines from where the source is hidden."""


def best_axes(mesh: Mesh, surface: Surface, lines: Floats, source: int) -> Floats:
    """The axes of the camera that sees most of the lines (n, 2, 3), and if possible the source."""
    size = np.ptp(surface.vertices, axis=0)
    landscape = size[2] < FLAT * size[:2].min()
    up = 2 if landscape else UPRIGHT.get(mesh.thesis_model or "", 1)
    elevation = ABOVE_A_LANDSCAPE if landscape else ELEVATION
    trials = [looking(up, azimuth, elevation) for azimuth in AZIMUTHS]
    return max(trials, key=lambda axes: _seen(axes, surface, lines, source))


def _seen(axes: Floats, surface: Surface, lines: Floats, source: int) -> float:
    """Length of the lines as it appears, with something for the source."""
    camera = framing(axes, surface.vertices)
    width = max(1, round(TRIAL_PIXELS * camera.width / max(camera.width, camera.height)))
    buffer = z_buffer(surface.vertices, surface.faces, camera, width)
    pieces, _ = buffer.visible_pieces(lines)
    length = float(np.linalg.norm(pieces[:, 1] - pieces[:, 0], axis=1).sum())
    seen = buffer.visible(surface.vertices[[source]])[0]
    return length * (SOURCE_COUNTS if seen else 1)
