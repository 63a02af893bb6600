"""Reads a run's recordings: surfaces, distances, wavefronts and their curves.

results/README.md describes the files. For any fault in a file, a ResultError with a message of one
line names the file.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plots.camera import Floats
from plots.surface import Surface
from plots.zbuffer import Integers
from results.published import THESIS_SOLVERS
from results.reader import Mesh, ResultError, Run, Source

MOMENTS = (25, 50, 75)
"""Per cent of the vertices reached at which the wavefront is recorded."""

FRAMES = 64
"""Equal steps of progress at which `run --frames` records the wavefront."""
NONE = 0xFFFFFFFF
"""Stands for no sample or no source in files of their numbers."""

CURVE = np.dtype(
    [("reached", "<u4"), ("windows", "<u8"), ("least", "<f8"), ("mean", "<f8"), ("sd", "<f8")]
)
SNAPSHOT = np.dtype(
    [("origin", "<u4"), ("head", "<u4"), ("begin", "<f4"), ("end", "<f4"), ("distance", "<f8")]
)
PATHS = np.dtype([("target", "<u4"), ("first", "<u4")])

Table = NDArray[Any]
"""An array of one of the structures above."""


@dataclass(frozen=True)
class Cells:
    sources: Integers
    """Source vertices."""
    nearest: Integers
    """Index of the nearest source in `sources`, by vertex; len(sources) for unreached vertices."""


@dataclass(frozen=True)
class Recording:
    """The recording of one source on one mesh. A file is read at the first access."""

    mesh: Mesh
    source: Source
    vertices: list[int]
    """The source vertex, or the vertices of the set of sources."""
    folder: Path
    """RUN/recordings/<mesh>/src<source>"""
    solvers: dict[str, Path]
    """Folders of the exact solvers in `folder`; they contain wavefronts."""
    inexact: dict[str, Path] = field(default_factory=dict)
    """Folders of the other solvers in `folder`; they contain distances."""

    @property
    def origin(self) -> str:
        if isinstance(self.source, int):
            return f"vertex {self.source}"
        return f"the {len(self.vertices):,} sources {self.source}"

    @cached_property
    def surface(self) -> Surface:
        vertices = _floats(self.folder.parent / "vertices.npy", "<f4", (self.mesh.vertices, 3))
        file = self.folder.parent / "faces.npy"
        faces = _load(file, np.dtype("<u4"), (self.mesh.faces, 3))
        _require(int(faces.max()) < len(vertices), file, "a face has a vertex that does not exist")
        return Surface(vertices, faces.astype(np.int64))

    @cached_property
    def distances(self) -> Floats:
        """Exact distances by vertex; infinite for unreached vertices."""
        file = self.folder / "distances.npy"
        distances = self._distances(file)
        _require(distances.min() >= 0, file, "a distance is negative")
        reached = distances[np.isfinite(distances)]
        _require(reached.size > 0 and reached.max() > 0, file, "no vertex is reached")
        return distances

    def inexact_distances(self, solver: str) -> Floats:
        """Returns the solver's distances by vertex. Heat methods may give negative ones."""
        return self._distances(self.inexact[solver] / "distances.npy")

    def _distances(self, file: Path) -> Floats:
        distances = _load(file, np.dtype("<f8"), (self.mesh.vertices,))
        _require(not np.isnan(distances).any(), file, "a distance is not a number")
        return distances

    @property
    def greatest(self) -> float:
        """Greatest distance of a reached vertex."""
        return float(self.distances[np.isfinite(self.distances)].max())

    @property
    def has_paths(self) -> bool:
        return (self.folder / "path_pieces.npy").exists()

    @cached_property
    def paths(self) -> list[Floats]:
        """Paths from the source to vertices all over the mesh, each as segments (n, 2, 3)."""
        points = _floats(self.folder / "path_points.npy", "<f4", (None, 3))
        file = self.folder / "path_pieces.npy"
        pieces = _load(file, PATHS, (None,))
        first = pieces["first"].astype(np.int64)
        _require(first[0] == 0 and first[-1] < len(points), file, "points and pieces do not match")
        counts = np.diff(first, append=len(points))
        _require(counts.min() >= 2, file, "a path has fewer than two points")
        _require(int(pieces["target"].max()) < self.mesh.vertices, file, "a target does not exist")
        whole = np.split(points, first[1:])
        return [np.stack([path[:-1], path[1:]], axis=1) for path in whole]

    @property
    def has_cells(self) -> bool:
        return (self.folder / "cells.npy").exists()

    @cached_property
    def cells(self) -> Cells:
        """Voronoi cells of several sources, among them this recording's source."""
        file = self.folder / "cell_sources.npy"
        sources = _load(file, np.dtype("<u4"), (None,)).astype(np.int64)
        _require(int(sources.max()) < self.mesh.vertices, file, "a source does not exist")
        file = self.folder / "cells.npy"
        nearest = _load(file, np.dtype("<u4"), (self.mesh.vertices,)).astype(np.int64)
        valid = (nearest < len(sources)) | (nearest == NONE)
        _require(bool(valid.all()), file, "a nearest source does not exist")
        return Cells(sources, np.minimum(nearest, len(sources)))

    def curve(self, solver: str) -> Table:
        """Returns the wavefront at equal steps of progress, as a CURVE array."""
        file = self.solvers[solver] / "curve.npy"
        curve = _load(file, CURVE, (None,))
        numbers = np.column_stack([curve[name] for name in ("least", "mean", "sd")])
        _require_amounts(numbers, file)
        _require(len(curve) > 1, file, "fewer than two samples")
        _require(bool((np.diff(curve["reached"].astype(np.int64)) > 0).all()), file, "no progress")
        return curve

    def snapshot(self, solver: str, moment: int) -> Table:
        """Returns the windows on the wavefront as a SNAPSHOT array. @param moment one of MOMENTS"""
        return self._windows(self.solvers[solver] / f"snapshot-{moment}.npy")

    def has_frames(self, solver: str) -> bool:
        return (self.solvers[solver] / "reached_by.npy").exists()

    def frames(self, solver: str) -> list[Table]:
        """Returns SNAPSHOT arrays of the windows on the wavefront when 1, 2, ... FRAMES of FRAMES equal
        parts of the reachable vertices had a distance. An array is empty if the wavefront was empty."""
        files = [self.solvers[solver] / f"frame-{i + 1}.npy" for i in range(FRAMES)]
        return [self._windows(file) if file.exists() else np.empty(0, SNAPSHOT) for file in files]

    def samples_of_frames(self, solver: str) -> Integers:
        """Returns the index in the curve of each frame; the curve's length for frames after its end."""
        reachable = int(np.isfinite(self.distances).sum())
        reached = self.curve(solver)["reached"].astype(np.int64)
        return np.searchsorted(FRAMES * reached, reachable * np.arange(1, FRAMES + 1))

    def first_frames(self, solver: str) -> Integers:
        """Returns, by vertex, the first frame, from 0, in which it has a distance; FRAMES without one."""
        file = self.solvers[solver] / "reached_by.npy"
        samples = _load(file, np.dtype("<u4"), (self.mesh.vertices,)).astype(np.int64)
        count = len(self.curve(solver))
        valid = (samples < count) | (samples == NONE)
        _require(bool(valid.all()), file, "a sample is not in the curve")
        frames = np.searchsorted(self.samples_of_frames(solver), samples)
        return np.where(np.isfinite(self.distances), np.minimum(frames, FRAMES - 1), FRAMES)

    def _windows(self, file: Path) -> Table:
        windows = _load(file, SNAPSHOT, (None,))
        ends = np.column_stack([windows["origin"], windows["head"]])
        _require(int(ends.max()) < self.mesh.vertices, file, "a window is not on an edge")
        begin, end = windows["begin"], windows["end"]
        on_edge = (begin >= 0) & (begin <= end) & (end <= 1)
        _require(bool(on_edge.all()), file, "a window extends beyond its edge")
        _require_amounts(windows["distance"], file)
        return windows

    def wavefront(self, solver: str, moment: int) -> Floats:
        """Returns the windows of a snapshot as segments (n, 2, 3)."""
        windows = self.snapshot(solver, moment)
        origin = self.surface.vertices[windows["origin"]]
        along = self.surface.vertices[windows["head"]] - origin
        begin, end = windows["begin"][:, None], windows["end"][:, None]
        return np.stack([origin + begin * along, origin + end * along], axis=1)


def recordings(run: Run, *solvers: str) -> list[Recording]:
    """Returns one recording per mesh, of its first recorded source, the best for the thesis's figures
    first. If several meshes are or stand for one model of the thesis, only the best is returned.

    @param solvers exact solvers that must have been recorded
    @raises ResultError if there is no such recording"""
    if missing := set(solvers) - set(run.solvers):
        raise ResultError(f"{run.file}: no {' and no '.join(sorted(missing))} in this run")
    found: dict[str, Recording] = {}
    for row in run.rows:
        if row.recordings is None:
            continue
        folder = run.file.parent / row.recordings
        mesh = run.meshes[row.mesh]
        if row.mesh not in found:
            vertices = run.source_vertices(row.mesh, row.source)
            found[row.mesh] = Recording(mesh, row.source, vertices, folder.parent, {})
        one = found[row.mesh]
        if row.source == one.source:
            kind = one.solvers if run.solvers[row.solver].exact else one.inexact
            kind[row.solver] = folder
    useful = [one for one in found.values() if one.solvers and set(solvers) <= set(one.solvers)]
    if not useful:
        whose = f" of {' and '.join(solvers)}" if solvers else ""
        raise ResultError(f"{run.file}: no recordings{whose}; run --recordings auto makes them")
    best: dict[str, Recording] = {}
    for one in sorted(useful, key=_merit, reverse=True):
        best.setdefault(one.mesh.thesis_model or one.mesh.name, one)
    return list(best.values())


def _merit(recording: Recording) -> tuple[bool, int, bool, int]:
    of_thesis = sum(solver in recording.solvers for solver in THESIS_SOLVERS)
    mesh = recording.mesh
    return mesh.thesis_model is not None, of_thesis, not mesh.stand_in, mesh.vertices


def _floats(file: Path, kind: str, shape: Sequence[int | None]) -> Floats:
    numbers = _load(file, np.dtype(kind), shape)
    _require(bool(np.isfinite(numbers).all()), file, "a number is not finite")
    return numbers.astype(float)


def _load(file: Path, kind: np.dtype[Any], shape: Sequence[int | None]) -> Table:
    """@param shape expected shape; None stands for any number except 0"""
    try:
        data: Table = np.load(file, allow_pickle=False)
    except FileNotFoundError:
        raise ResultError(f"{file}: no such file; was the run interrupted?") from None
    except (OSError, ValueError, EOFError) as error:
        raise ResultError(f"{file}: not a .npy file, perhaps truncated: {error}") from None
    _require(data.dtype == kind, file, f"holds {data.dtype}, not {kind}")
    fits = data.ndim == len(shape) and all(
        has > 0 if wanted is None else has == wanted
        for has, wanted in zip(data.shape, shape, strict=True)
    )
    _require(fits, file, f"has the shape {data.shape}, not {tuple(n or 'any' for n in shape)}")
    return data


def _require_amounts(numbers: Floats, file: Path) -> None:
    valid = bool(np.isfinite(numbers).all() and numbers.min() >= 0)
    _require(valid, file, "a value is not a number of 0 or more")


def _require(holds: bool, file: Path, otherwise: str) -> None:
    if not holds:
        raise ResultError(f"{file}: {' '.join(otherwise.split())}")
