"""The contents of the page as JSON: plain numbers and names, and compressed arrays.

An array is {"type": "f4", "data": base64 of its little-endian bytes, compressed in zlib's format}.
"""

from __future__ import annotations

import base64
import zlib
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.colors import to_hex
from numpy.typing import NDArray

from plots import paths, style
from plots.camera import Floats
from plots.isolines import isolines
from plots.recordings import Cells, Recording, Table
from plots.surface import best_axes, upwards
from plots.zbuffer import Integers
from results.published import THESIS_SOLVERS
from results.reader import ResultError

PARTS = 255
"""Number of parts of an edge to which the ends of windows are rounded."""
COLORS = 24
"""Number of colours for distances."""
PALE = 0.35
"""Share of white in these colours, so that lines are visible."""
THICK = 5
"""Every THICK-th isoline is thick, as on a map."""


def packed(array: NDArray[Any], kind: str) -> dict[str, str]:
    """@param kind type of NumPy: f4, u4, i4 or u1"""
    numbers = np.ascontiguousarray(array, dtype="<" + kind)
    return {"type": kind, "data": base64.b64encode(zlib.compress(numbers.tobytes(), 9)).decode()}


@dataclass(frozen=True)
class Edges:
    """The half-edges of faces: 3 f + k runs from corner k of face f to the next one."""

    faces: Integers

    def numbers(self, a: Integers, b: Integers) -> tuple[Integers, NDArray[np.bool_]]:
        """Returns a half-edge between each pair of vertices, and whether it runs from b to a.
        @raises ResultError when a pair has no edge"""
        keys, half_edges = self._sorted
        wanted = self._key(a, b)
        place = np.minimum(np.searchsorted(keys, wanted), len(keys) - 1)
        if (keys[place] != wanted).any():
            raise ResultError("a window of the recording is on no edge of the mesh")
        found: Integers = half_edges[place]
        return found, self.faces.ravel()[found] != a

    @cached_property
    def _sorted(self) -> tuple[Integers, Integers]:
        keys = self._key(self.faces, np.roll(self.faces, -1, axis=1)).ravel()
        half_edges = np.argsort(keys, kind="stable")
        return keys[half_edges], half_edges

    def _key(self, a: Integers, b: Integers) -> Integers:
        count = int(self.faces.max()) + 1
        return np.asarray(np.minimum(a, b) * count + np.maximum(a, b))


def with_frames(recording: Recording) -> list[str]:
    """Returns the solvers whose wavefronts were recorded, those of the thesis first."""
    there = [solver for solver in recording.solvers if recording.has_frames(solver)]
    return sorted(there, key=lambda one: (*THESIS_SOLVERS, one).index(one))


def scene(recording: Recording, solvers: list[str], up: int | None = None) -> dict[str, Any]:
    """@param solvers names from `with_frames`, shown side by side; may be empty
    @param up the axis that points up: 0 for x, 1 for y, 2 for z; None for the axis of the figures
    @raises ResultError"""
    surface, mesh = recording.surface, recording.mesh
    up = upwards(mesh, surface) if up is None else up
    lines = isolines(recording)
    edges = Edges(surface.faces)
    return {
        "vertices": packed(surface.vertices, "f4"),
        "faces": packed(surface.faces, "u4"),
        "axes": best_axes(mesh, surface, np.concatenate(lines), recording.vertices[0], up).tolist(),
        "up": up,
        "sources": recording.vertices,
        "paths": _paths(recording.paths) if recording.has_paths else None,
        "cells": _cells(recording.cells) if recording.has_cells else None,
        "distances": packed(_finite(recording.distances), "f4"),
        "greatest": recording.greatest,
        "colors": _colors(),
        "isolines": _isolines(lines),
        "solvers": [_solver(recording, solver, edges) for solver in solvers],
    }


def _finite(distances: Floats) -> Floats:
    """Replaces infinite distances by -1, because JSON and WebGL have no infinity."""
    return np.where(np.isfinite(distances), distances, -1)


def _colors() -> list[str]:
    colors = colormaps["viridis"](np.linspace(0, 1, COLORS))[:, :3]
    return [to_hex(color) for color in PALE + (1 - PALE) * colors]


def _paths(segments: list[Floats]) -> dict[str, Any]:
    return {"segments": packed(np.concatenate(segments), "f4"), "color": paths.PATH}


def _cells(cells: Cells) -> dict[str, Any]:
    return {
        "sources": cells.sources.tolist(),
        "nearest": packed(cells.nearest, "u4"),
        "colors": [*paths.CELLS, paths.OF_NO_CELL],
    }


def _isolines(lines: list[Floats]) -> dict[str, Any]:
    """@param lines segments, by level"""
    thick = lines[THICK - 1 :: THICK]
    thin = [line for number, line in enumerate(lines, 1) if number % THICK]
    return {
        "thin": packed(np.concatenate(thin), "f4"),
        "thick": packed(np.concatenate(thick), "f4"),
    }


def _solver(recording: Recording, solver: str, edges: Edges) -> dict[str, Any]:
    """A segment has the difference of its half-edge to that of the previous segment; the first one of a
    frame has the difference to 0. Most differences are small and compress well."""
    frames = recording.frames(solver)
    segments = [_segments(frame, edges) for frame in frames]
    steps, begins, ends = (np.concatenate(parts) for parts in zip(*segments, strict=True))
    curve = recording.curve(solver)
    samples = recording.samples_of_frames(solver)
    spread = np.append(curve["sd"], 0)[np.minimum(samples, len(curve))]
    return {
        "name": solver,
        "color": style.solver_styles([solver])[solver].color,
        "windows": [len(frame) for frame in frames],
        "spread": [round(float(sd) / recording.mesh.mean_edge_length, 3) for sd in spread],
        "first": packed(recording.first_frames(solver), "u1"),
        "segments": [len(one) for one, _, _ in segments],
        "steps": packed(steps, "i4"),
        "begins": packed(begins, "u1"),
        "ends": packed(ends, "u1"),
    }


def _segments(frame: Table, edges: Edges) -> tuple[Integers, Integers, Integers]:
    """Joins the windows of a frame that touch on a half-edge into segments.
    @return the differences between successive half-edges, and both ends in PARTS of the edge"""
    origin, head = (frame[name].astype(np.int64) for name in ("origin", "head"))
    edge, turned = edges.numbers(origin, head)
    begin = np.where(turned, 1 - frame["end"], frame["begin"])
    end = np.where(turned, 1 - frame["begin"], frame["end"])
    low, high = (np.rint(PARTS * one).astype(np.int64) for one in (begin, end))
    order = np.lexsort((low, edge))
    edge, low, high = edge[order], low[order], high[order]
    # The farthest end so far on the same edge. The keys of two edges differ by more than an edge's length.
    far = np.maximum.accumulate(edge * 2 * PARTS + high) if len(edge) else high
    starts = np.flatnonzero(np.append(True, edge[1:] * 2 * PARTS + low[1:] > far[:-1])[: len(edge)])
    ends = np.append(starts[1:], len(edge))[: len(starts)] - 1
    return np.diff(edge[starts], prepend=0), low[starts], far[ends] - edge[ends] * 2 * PARTS
