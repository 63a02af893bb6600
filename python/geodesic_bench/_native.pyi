"""The compiled part (python/native/module.cpp). arrays.py checks its arguments. Public classes have their
documentation there."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

_Indices = NDArray[np.uint32]
_Progress = Callable[[int], None] | None
_Path = tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64], int]
"""The fields of lines.Path."""
_Compressed = tuple[NDArray[np.floating[Any]], NDArray[np.int64], NDArray[np.int64]]

__version__: str

class SharedMesh:
    @property
    def vertices(self) -> NDArray[np.float64]: ...
    @property
    def faces(self) -> _Indices: ...
    @property
    def joined_to(self) -> _Indices:
        """By vertex, the one that stands for it; empty when no vertices were joined."""
    @property
    def left_out(self) -> list[bool]:
        """By face, whether it collapsed or is avoided; empty when no face did or is."""
    @property
    def crosses_non_manifold(self) -> bool: ...

class Avoided:
    """Vertices and faces that paths may not enter. The number of flags is that of a mask, None for numbers."""

    def __init__(
        self, vertices: _Indices, vertex_flags: int | None, faces: _Indices, face_flags: int | None
    ) -> None: ...

class SolverPool:
    """Solvers of one name on one mesh."""

    @property
    def solver(self) -> Solver: ...
    @property
    def certificate(self) -> tuple[int, float, float] | None:
        """The fields of prepared.Certificate."""

class Field:
    """The data of a solve. It keeps the mesh, and no solver."""

    @property
    def distances(self) -> NDArray[np.float64]: ...
    @property
    def nearest(self) -> NDArray[np.int64]: ...
    def at(self, points: SurfacePoints) -> NDArray[np.float64]: ...
    def nearest_at(self, points: SurfacePoints) -> NDArray[np.int64]: ...
    def gradients(self, points: SurfacePoints) -> NDArray[np.float64]: ...
    def paths_to(self, points: SurfacePoints, required: bool) -> list[_Path | None]:
        """As `paths`."""
    def file_bytes(self, file: str) -> bytes: ...
    def log_map(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Returns the fields of lines.LogMap."""

class SurfacePoints:
    """Points of a mesh's surface."""

    def __len__(self) -> int: ...

class PointSets:
    """Sets of points: set i has the points from begins[i] to before begins[i + 1]."""

    def __init__(self, all: SurfacePoints, begins: NDArray[np.int64]) -> None: ...
    def __len__(self) -> int: ...

class Defect:
    @property
    def kind(self) -> str: ...
    @property
    def severity(self) -> str: ...
    @property
    def count(self) -> int: ...
    @property
    def first(self) -> str: ...

class Solver:
    @property
    def name(self) -> str: ...
    @property
    def family(self) -> str: ...
    @property
    def paper(self) -> str: ...
    @property
    def exact(self) -> bool: ...
    @property
    def remarks(self) -> str: ...
    @property
    def prepares(self) -> bool: ...
    @property
    def parameters(self) -> list[str]: ...

def mesh(
    vertices: NDArray[np.float64],
    faces: _Indices,
    joined_to: _Indices,
    left_out: list[bool],
    repair: bool,
    cross_non_manifold: bool,
    weld: float | None,
    avoided: Avoided,
) -> tuple[SharedMesh, list[str]]: ...
def read(
    file: str, repair: bool, cross_non_manifold: bool, weld: float | None, avoided: Avoided,
    read_before: tuple[NDArray[np.float64], _Indices] | None,
) -> tuple[SharedMesh, list[str]]:  # fmt: skip
    """Reads the file, unless its vertices and faces were read before."""
def defects(mesh: SharedMesh) -> list[Defect]: ...
def unknown_name(kind: str, name: str, known: list[str]) -> str: ...
def solvers() -> list[Solver]: ...
def surface_points(
    mesh: SharedMesh, vertices: _Indices, faces: _Indices, weights: NDArray[np.float64]
) -> tuple[SurfacePoints, str]:
    """Converts the arrays of arrays.Points. Returns a remark as well if a place is far from the surface."""
def pool(mesh: SharedMesh, solver: str) -> SolverPool:
    """Returns the mesh's pool, which it keeps until it is asked for another solver."""
def prepare(mesh: SharedMesh, solver: str) -> SolverPool:
    """Returns a new pool that is prepared."""
def saved(pool: SolverPool) -> bytes: ...
def load(mesh: SharedMesh, saved: bytes) -> SolverPool: ...
def distances(
    pool: SolverPool, sources: SurfacePoints, initial: NDArray[np.float64],
    targets: SurfacePoints | None, limit: float,
) -> NDArray[np.float64]: ...  # fmt: skip
def targets_and_nearest(
    pool: SolverPool, sources: SurfacePoints, initial: NDArray[np.float64],
    targets: SurfacePoints, limit: float,
) -> tuple[NDArray[np.float64], NDArray[np.int64]]: ...  # fmt: skip
def paths(
    pool: SolverPool, sources: SurfacePoints, initial: NDArray[np.float64],
    targets: SurfacePoints, required: bool,
) -> list[_Path | None]:
    """Returns None for a target to which no path leads; if paths are required, raises a ValueError."""
def solve(
    pool: SolverPool, sources: SurfacePoints, initial: NDArray[np.float64], limit: float,
    anywhere: bool,
) -> Field: ...
def path_through(
    pool: SolverPool, points: SurfacePoints, closed: bool, straighten: bool
) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]:
    """Returns the fields of lines.Polyline."""
MOST_LEVELS: int

def equal_levels(distances: NDArray[np.float64], count: int) -> NDArray[np.float64]: ...
def trace(
    mesh: SharedMesh, begin: SurfacePoints, angle: float, length: float
) -> tuple[bool, NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]:
    """Returns whether the line ends at the boundary, and the fields of lines.Polyline."""
def angle_of(mesh: SharedMesh, begin: SurfacePoints, vector: tuple[float, float, float]) -> float: ...
def total_angle(mesh: SharedMesh, point: SurfacePoints) -> float: ...
def isolines(
    mesh: SharedMesh, distances: NDArray[np.float64], levels: NDArray[np.float64]
) -> list[tuple[float, bool, NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]]:
    """Returns the fields of lines.Isoline."""
def line_bytes(
    file: str, lines: list[tuple[NDArray[np.float64], NDArray[np.float64], float, bool]], are_isolines: bool
) -> bytes:
    """Returns the bytes of a file, .obj or .ply, of lines: points, travelled, level and closed of lines.Isoline."""
def pair_distances(
    pool: SolverPool, a: SurfacePoints, b: SurfacePoints, threads: int
) -> NDArray[np.float64]: ...
def nearest_points(
    mesh: SharedMesh, places: NDArray[np.float64]
) -> tuple[_Indices, _Indices, NDArray[np.float64], NDArray[np.float64]]: ...
def dense(
    pool: SolverPool, rows: PointSets, columns: SurfacePoints | None, threads: int,
    progress: _Progress, out: NDArray[np.floating[Any]],
) -> None: ...  # fmt: skip
def sparse_float64(
    pool: SolverPool, rows: PointSets, columns: SurfacePoints | None, limit: float, threads: int,
    progress: _Progress,
) -> _Compressed: ...  # fmt: skip
def sparse_float32(
    pool: SolverPool, rows: PointSets, columns: SurfacePoints | None, limit: float, threads: int,
    progress: _Progress,
) -> _Compressed: ...  # fmt: skip
