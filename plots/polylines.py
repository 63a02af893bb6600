"""Pieces of lines joined where they meet: fewer, longer lines draw and store better."""

from __future__ import annotations

import numpy as np
from plots.camera import Floats

Place = tuple[int, ...]


def joined(pieces: Floats, step: float) -> list[Floats]:
    """Lines (k, 2) that together draw the pieces (n, 2, 2), each once.
    @param step ends that are closer are one place"""
    rounded = np.round(pieces / step).astype(np.int64).tolist()
    begins: list[Place] = [tuple(begin) for begin, _ in rounded]
    ends: list[Place] = [tuple(end) for _, end in rounded]
    at: dict[Place, list[int]] = {}
    for index, both in enumerate(zip(begins, ends, strict=True)):
        for place in both:
            at.setdefault(place, []).append(index)
    left = [True] * len(pieces)

    def walk(place: Place) -> list[Floats]:
        """From a place as far as pieces that are left lead, which then are not."""
        points: list[Floats] = []
        while True:
            index = next((one for one in at[place] if left[one]), None)
            if index is None:
                return points
            left[index] = False
            far = 1 if begins[index] == place else 0
            points.append(pieces[index, far])
            place = (begins, ends)[far][index]

    lines = []
    for index, (begin, end) in enumerate(zip(begins, ends, strict=True)):
        if left[index]:
            left[index] = False
            before = walk(begin)[::-1]
            lines.append(np.array([*before, *pieces[index], *walk(end)]))
    return lines
