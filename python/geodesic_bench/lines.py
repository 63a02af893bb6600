"""Lines over a mesh: paths and isolines."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass, fields
from pathlib import Path as FilePath
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from geodesic_bench import _native


@dataclass(frozen=True, eq=False, repr=False)
class Polyline:
    """A line over the surface that is straight in each face. Path describes its attributes."""

    points: NDArray[np.float64]
    faces: NDArray[np.int64]
    travelled: NDArray[np.float64]

    @property
    def length(self) -> float:
        """Length, in the unit of the coordinates."""
        return float(self.travelled[-1])

    def __repr__(self) -> str:
        """Without the arrays, which may fill pages: Path(3 points, length=1.41421, source=0)."""
        others = [field.name for field in fields(self)[len(fields(Polyline)) :]]
        shown = "".join(f", {name}={getattr(self, name)!r}" for name in others)
        return f"{type(self).__name__}({len(self.points)} points, length={self.length:.6g}{shown})"


@dataclass(frozen=True, eq=False, repr=False)
class Path(Polyline):
    """A shortest path, from its source to its target, straight in each face.

    Attributes
    ----------
    points : (k, 3) float64
        Its begin, its points on edges and at vertices, and its end.
    faces : (k - 1,) int64
        The face that it crosses between each point and the next.
    travelled : (k,) float64
        Its length up to each point, in the unit of the coordinates.
    length : float
        Its whole length. The distance of its end is larger by the initial distance of its source, if any.
    source : int
        Index of its source among the sources: the nearest of them. 0 of a path through several points.
    """

    source: int


@dataclass(frozen=True, eq=False, repr=False)
class StraightestLine(Polyline):
    """A line that goes straight on over the surface, from `Mesh.trace`.

    Attributes
    ----------
    points, faces, travelled, length
        As of a Path.
    ends_at_boundary : bool
        Whether it is shorter than it was to be, because it has reached the boundary.
    """

    ends_at_boundary: bool


@dataclass(frozen=True, eq=False, repr=False)
class Isoline(Polyline):
    """A line on which the distance, interpolated linearly along the edges, is the level.

    Attributes
    ----------
    points, faces, travelled, length
        As of a Path.
    level : float
        A distance, in the unit of the coordinates.
    closed : bool
        Whether the last point is the first one again.
    """

    level: float
    closed: bool


def save_lines(file: str | os.PathLike[str], lines: Polyline | Iterable[Polyline | None]) -> None:
    """Writes paths, straightest lines or isolines as polylines, as `geodesic-bench solve` does with --paths and
    --isolines.

    Parameters
    ----------
    file : path
        .obj, with a line each; isolines are in a group a level. Or .ply, binary, with edges, the number of the line
        of each edge, and `travelled`, or of isolines `level`, of each vertex.
    lines : a line, or an iterable of them
        Isolines only, or none of them. None, which `paths_to` has where no path leads, is left out.

    Raises
    ------
    ValueError, OSError
        For another suffix, for isolines beside other lines, and when the file cannot be written.
    """
    given = [lines] if isinstance(lines, Polyline) else [line for line in lines if line is not None]
    for line in given:
        if not isinstance(line, Polyline):
            raise ValueError(f"lines must be paths or isolines, not {type(line).__name__}")
    of_isolines = [isinstance(line, Isoline) for line in given]
    if len(set(of_isolines)) > 1:
        raise ValueError("isolines and other lines need a file each")
    name = os.fsdecode(file)
    if not name.lower().endswith((".obj", ".ply")):
        raise ValueError(f"cannot write '{name}': lines are written as .obj or .ply")
    rows = [
        (line.points, line.travelled, line.level, line.closed)
        if isinstance(line, Isoline)
        else (line.points, line.travelled, 0.0, False)
        for line in given
    ]
    FilePath(name).write_bytes(_native.line_bytes(name, rows, any(of_isolines)))


class LogMap(NamedTuple):
    """Polar coordinates of vertices around their nearest source, from `Field.log_map`."""

    lengths: NDArray[np.float64]
    """(n,): distances, inf where no path leads."""
    angles: NDArray[np.float64]
    """(n,): radians, counter-clockwise, measured on the surface, 0 at a source, nan where no path leads. In a face they
    begin at the direction from its first corner to its second; at a vertex at the side of its face of least number, or
    at the boundary, and go up to `Mesh.total_angle`."""
