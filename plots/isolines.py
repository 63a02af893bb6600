"""Isolines of the distance field, from the vertices' distances: one straight segment per face.

The distance is interpolated linearly between vertices. An exact isoline consists of arcs of circles
and has corners where paths of two kinds meet; a segment cuts off the corners inside its face.
"""

from __future__ import annotations

import numpy as np

from plots.camera import Floats
from plots.recordings import Recording

STEPS = 40
"""Number of equal steps up to the greatest distance, with a level between every two steps."""


def levels(recording: Recording) -> Floats:
    return np.arange(1, STEPS) * recording.greatest / STEPS


def isoline(recording: Recording, level: float) -> Floats:
    """Returns segments (n, 2, 3), one in each face that the level crosses and whose corners are reached."""
    surface, distances = recording.surface, recording.distances
    values = distances[surface.faces]
    above = values >= level
    crossed = above.any(axis=1) & ~above.all(axis=1) & np.isfinite(values).all(axis=1)
    values, above = values[crossed], above[crossed]
    corners = surface.vertices[surface.faces[crossed]]
    rows = np.arange(len(values))
    # The corner that lies alone on its side of the level.
    odd = np.argmax(above == (above.sum(axis=1) == 1)[:, None], axis=1)
    ends = []
    for other in ((odd + 1) % 3, (odd + 2) % 3):
        near, far = values[rows, odd], values[rows, other]
        share = ((level - near) / (far - near))[:, None]
        ends.append((1 - share) * corners[rows, odd] + share * corners[rows, other])
    return np.stack(ends, axis=1)


def isolines(recording: Recording) -> list[Floats]:
    """Returns the isolines of all levels."""
    return [isoline(recording, level) for level in levels(recording)]
