"""Meshes and the distances on them."""

from __future__ import annotations

import math
import operator
import os
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from geodesic_bench import _native
from geodesic_bench.arrays import (
    OUT_OF_RANGE,
    Points,
    Surface,
    face_array,
    numbers,
    surface_point,
    surface_points,
    vertex_array,
)

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

FASTEST = "edge-based"
MOST_THREADS = 1024

SurfacePoint = int | tuple[int, ArrayLike] | ArrayLike
"""A vertex; a point in a face: the face and a weight of each of its corners, which are divided by
their sum, one of them 0 on an edge; or a place in space, three coordinates, which stands for the
nearest point of the surface."""

SurfacePoints = ArrayLike | SurfacePoint | Sequence[SurfacePoint]
"""An array of vertices or of places, of shape (k, 3), one point, or a list of points. Three whole
numbers are vertices."""

FAR = 0.01
"""A place that is farther from the surface than this part of the mesh's longest side gives a warning:
it was probably meant in other units or axes."""


@dataclass(frozen=True, eq=False)
class Path:
    """A shortest path, from its source to its target."""

    points: NDArray[np.float64]
    """(k, 3): where it begins, crosses edges, runs through vertices, and ends."""
    faces: NDArray[np.uint32]
    """(k - 1,): the face that it crosses, straight, between each point and the next one."""
    travelled: NDArray[np.float64]
    """(k,): its length up to each point, in the unit of the coordinates."""

    @property
    def length(self) -> float:
        return float(self.travelled[-1])


class Mesh:
    """A triangle mesh that distances are measured on. It does not change, and any number of threads
    may use it.

    Parameters
    ----------
    vertices : (n, 3) real numbers, or a mesh of another package
        Coordinates, of any type and memory order; copied as float64. An object with `vertices` and
        `faces` (trimesh, Open3D through NumPy), or `points` and `cells` of triangles (meshio).
    faces : (m, 3) integers, m > 0
        Indices of vertices from 0, counter-clockwise seen from outside; copied. Not beside an
        object.
    cross_non_manifold : bool
        Paths go from a face into each of the others at an edge of more than two faces, and at one
        between faces that do not agree on the outside. Otherwise such edges are boundaries. The
        solver must be one that does so: edge-based, mmp, fwp-mmp.

    Raises
    ------
    ValueError
        For another shape, a face that names a vertex twice or one that is not there, and a
        coordinate that is not finite. What else makes distances meaningless is not looked for:
        `defects` lists it, and `read_mesh` refuses it.

    The first query builds the structure that solvers walk over. The solver of the last query stays
    with the mesh, and so does its memory.

    >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
    >>> mesh
    Mesh(3 vertices, 1 faces)
    >>> mesh.distances([1])
    array([3., 0., 5.])
    """

    _shared: _native.SharedMesh

    def __init__(
        self, vertices: Any, faces: ArrayLike | None = None, *, cross_non_manifold: bool = False
    ) -> None:
        if faces is None:
            vertices, faces = _arrays_of(vertices)
        points = vertex_array(vertices)
        corners = face_array(faces, len(points))
        self._shared = _native.SharedMesh(points, corners, cross_non_manifold)

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Coordinates, of shape (n, 3); read-only."""
        return self._shared.vertices

    @property
    def faces(self) -> NDArray[np.uint32]:
        """Indices of vertices, of shape (m, 3); read-only."""
        return self._shared.faces

    @overload
    def distances(
        self,
        sources: SurfacePoints,
        initial: ArrayLike | None = ...,
        limit: float | None = ...,
        solver: str = ...,
        *,
        return_nearest: Literal[False] = ...,
        **parameters: float | str,
    ) -> NDArray[np.float64]: ...
    @overload
    def distances(
        self,
        sources: SurfacePoints,
        initial: ArrayLike | None = ...,
        limit: float | None = ...,
        solver: str = ...,
        *,
        return_nearest: Literal[True],
        **parameters: float | str,
    ) -> tuple[NDArray[np.float64], NDArray[np.int64]]: ...
    def distances(
        self,
        sources: SurfacePoints,
        initial: ArrayLike | None = None,
        limit: float | None = None,
        solver: str = FASTEST,
        *,
        return_nearest: bool = False,
        **parameters: float | str,
    ) -> NDArray[np.float64] | tuple[NDArray[np.float64], NDArray[np.int64]]:
        """The distance of every vertex from the nearest of some sources.

        Parameters
        ----------
        sources : (k,) integers, or k points, or one
            Vertices, points in faces, and places: `(7, (1, 1, 1))` is the middle of face 7. Any solver
            takes points in faces; for one that knows vertices only they become vertices of a finer
            mesh at every call.
        initial : (k,) numbers or one number, >= 0, optional
            The distance that each source begins with, in the unit of the coordinates.
        limit : float, optional
            Vertices that are farther are not reached; a small limit makes a query fast.
        solver : str
            A name of `solvers()`; all exact ones give the same distances up to rounding.
        return_nearest : bool
            Return the nearest source of every vertex, too: the one where its path begins. For a
            solver that remembers paths.
        parameters
            Those of the solver, where it has any: `geodesic-bench list` says which.

        Returns
        -------
        (n,) float64
            In the unit of the coordinates and the order of the vertices; inf for a vertex that no
            path leads to or that lies beyond the limit.
        (n,) int64
            With `return_nearest`, positions in `sources`; -1 where the distance is inf.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> mesh.distances([0, 1], initial=[0, 1.5])
        array([0. , 1.5, 4. ])
        >>> mesh.distances(0, limit=3.5)
        array([ 0.,  3., inf])
        >>> mesh.distances([1, 2], return_nearest=True)
        (array([3., 0., 0.]), array([0, 0, 1]))
        >>> mesh.distances([2, (0, (1, 1, 0))])
        array([1.5, 1.5, 0. ])
        """
        points = surface_points(sources, "source", self._surface())
        count = points.vertices.shape
        begin = numbers(0 if initial is None else initial, "initial distances")
        if begin.ndim and begin.shape != count:
            raise ValueError(
                f"initial distances must be one a source: {begin.size} for {count[0]} sources"
            )
        begin = np.broadcast_to(begin, count)
        name = _configured(solver, parameters)
        farthest = math.inf if limit is None else limit
        if return_nearest:
            return _native.distances_and_nearest(self._shared, name, points, begin, farthest)
        return _native.distances(self._shared, name, points, begin, farthest)

    def path(
        self,
        source: SurfacePoint,
        target: SurfacePoint,
        solver: str = FASTEST,
        **parameters: float | str,
    ) -> Path:
        """A shortest path over the surface.

        Parameters
        ----------
        source, target : an integer, a pair (integer, three numbers), or three numbers
            A vertex, a point in a face as for `distances`, or a place.
        solver : str
        parameters
            As for `distances`; a solver that remembers paths.

        Raises
        ------
        ValueError
            When no path leads there.

        >>> mesh = Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> path = mesh.path(1, 3)
        >>> path.points
        array([[1. , 0. , 0. ],
               [0.5, 0.5, 0. ],
               [0. , 1. , 0. ]])
        >>> path.faces, round(path.length, 6)
        (array([0, 1], dtype=uint32), 1.414214)
        >>> round(mesh.path((0, (0, 1, 1)), 1).length, 6)
        0.5
        """
        end = surface_point(target, "target", self._surface())
        return self._paths(source, end, solver, parameters)[0]

    def paths(
        self,
        source: SurfacePoint,
        targets: SurfacePoints,
        solver: str = FASTEST,
        **parameters: float | str,
    ) -> list[Path]:
        """A shortest path to each of some points, by one solve; otherwise as `path`.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> [path.length for path in mesh.paths(0, [1, 2])]
        [3.0, 4.0]
        """
        ends = surface_points(targets, "target", self._surface())
        return self._paths(source, ends, solver, parameters)

    def nearest_point(self, places: ArrayLike) -> tuple[Any, Any]:
        """The points of the surface that are nearest to places in space.

        Parameters
        ----------
        places : (3,) or (k, 3) real numbers
            Looks at every face for each of them.

        Returns
        -------
        one point and its distance through space, or a list of k points and (k,) float64
            A vertex, or a pair of a face and (3,) weights, as `distances` and `path` take them.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> mesh.nearest_point([3, 0, 0.5])
        (1, 0.5)
        >>> (face, weights), distance = mesh.nearest_point([1, 1, 0])
        >>> face, weights.round(3), distance
        (0, array([0.417, 0.333, 0.25 ]), 0.0)
        """
        given = numbers(places, "places")
        if given.ndim not in (1, 2) or given.shape[-1] != 3:
            raise ValueError(f"places must have the shape (3,) or (k, 3), not {given.shape}")
        found, away = self._nearest(given.reshape(-1, 3))
        points = [
            int(vertex) if vertex != OUT_OF_RANGE else (int(face), weights)
            for vertex, face, weights in zip(*found, strict=True)
        ]
        return (points[0], float(away[0])) if given.ndim == 1 else (points, away)

    def _paths(
        self, source: SurfacePoint, ends: Points, solver: str, parameters: dict[str, float | str]
    ) -> list[Path]:
        begin = surface_point(source, "source", self._surface())
        found = _native.paths(self._shared, _configured(solver, parameters), begin, ends)
        return [Path(*arrays) for arrays in found]

    def _nearest(self, places: NDArray[np.float64]) -> tuple[Points, NDArray[np.float64]]:
        vertices, faces, weights, away = _native.nearest(self._shared, np.ascontiguousarray(places))
        return Points(vertices, faces, weights), away

    def _surface(self) -> Surface:
        def nearest(places: NDArray[np.float64], what: str) -> Points:
            points, away = self._nearest(places)
            extent = float(np.ptp(self.vertices, axis=0).max())
            if away.size and away.max() > FAR * extent:
                place = tuple(places[away.argmax()].tolist())
                warnings.warn(
                    f"{what} {place} is {away.max():.3g} from the surface, whose nearest point is"
                    f" taken; the longest side of the mesh is {extent:.3g}",
                    stacklevel=5,
                )
            return points

        return Surface(len(self.vertices), len(self.faces), nearest)

    def distance_matrix(
        self,
        rows: SurfacePoints,
        columns: SurfacePoints | None = None,
        threads: int = 0,
        dtype: DTypeLike = "float64",
        limit: float | None = None,
        progress: bool = False,
        solver: str = FASTEST,
        **parameters: float | str,
    ) -> NDArray[Any] | csr_matrix:
        """The distances from each of some points by itself.

        Parameters
        ----------
        rows : (k,) integers, or k points, or one
            Sources, one solve each: vertices, and points in faces as for `distances`.
        columns : (l,) integers, or l points, or one, optional
            Where distances are kept; all vertices if not given. A solve ends at the farthest.
        threads : int
            Rows that are solved at a time; 0: as many as there are processors. Each thread has a
            solver with its own memory. The matrix is the same for any number.
        dtype : float64 or float32
            Of the matrix; solvers always compute in float64.
        limit : float, optional
            Makes the matrix sparse: entries that are farther are not stored.
        progress : bool
            Show a bar, by tqdm.
        solver : str
        parameters
            As for `distances`.

        Returns
        -------
        (k, l) array, or scipy.sparse.csr_matrix with a limit
            In the unit of the coordinates. A dense matrix has inf where no path leads. What is
            stored in a sparse one is reached, the zeros too.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> mesh.distance_matrix([0, 2], columns=[1, 2])
        array([[3., 4.],
               [5., 0.]])
        >>> mesh.distance_matrix([0, 1, 2], limit=4, dtype="float32").nnz
        7
        >>> middle = (0, (0, 1, 1))
        >>> mesh.distance_matrix([0, middle], columns=[1, middle])
        array([[3. , 2.5],
               [2.5, 0. ]])
        """
        surface = self._surface()
        sources = surface_points(rows, "row", surface)
        targets = None if columns is None else surface_points(columns, "column", surface)
        if not 0 <= operator.index(threads) <= MOST_THREADS:
            raise ValueError(f"threads must be between 0 and {MOST_THREADS}, not {threads}")
        if np.dtype(dtype) not in (np.float64, np.float32):
            raise ValueError(f"dtype must be float64 or float32, not {dtype}")
        is_double = np.dtype(dtype) == np.float64
        what = (self._shared, _configured(solver, parameters), sources, targets)
        workers = threads or os.cpu_count() or 1
        shape = len(sources.vertices), len((targets or self).vertices)
        if limit is None:
            dense = _native.dense_float64 if is_double else _native.dense_float32
            try:
                with _bar(shape[0], progress) as show:
                    return dense(*what, workers, show)
            except MemoryError:
                raise MemoryError(
                    f"no room for a matrix of {shape[0]} rows and {shape[1]} columns in {dtype}: ask"
                    " for fewer at a time, or write it with geodesic-bench solve --matrix"
                ) from None
        from scipy.sparse import csr_matrix

        sparse = _native.sparse_float64 if is_double else _native.sparse_float32
        with _bar(shape[0], progress) as show:
            return csr_matrix(sparse(*what, limit, workers, show), shape=shape)

    def __repr__(self) -> str:
        return f"Mesh({len(self.vertices)} vertices, {len(self.faces)} faces)"

    def __reduce__(self) -> tuple[Any, ...]:
        crosses = self._shared.crosses_non_manifold
        return partial(Mesh, cross_non_manifold=crosses), (self.vertices, self.faces)


def read_mesh(
    file: str | os.PathLike[str], repair: bool = False, *, cross_non_manifold: bool = False
) -> Mesh:
    """The mesh of an OBJ, OFF, PLY or STL file, with the file's vertex numbers.

    Parameters
    ----------
    file : path
    repair : bool
        Repair what would be refused; docs/adding-a-mesh.md says how. Vertices keep their numbers.
    cross_non_manifold : bool
        As of Mesh; what it concerns is not refused then.

    Raises
    ------
    ValueError
        When the file cannot be read, or distances on it have no meaning.

    What may surprise, and what was repaired, is one UserWarning.
    """
    mesh = Mesh.__new__(Mesh)
    try:
        mesh._shared, remarks = _native.read(os.fspath(file), repair, cross_non_manifold)
    except ValueError as error:
        raise ValueError(_in_python(str(error))) from None
    if remarks:
        warnings.warn(f"{os.fspath(file)}: {'; '.join(remarks)}", stacklevel=2)
    return mesh


def defects(mesh: Mesh) -> list[_native.Defect]:
    """What is wrong with a mesh, errors first: on a mesh with errors, distances mean another surface
    than its author's.

    >>> defects(Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0], [9, 9, 9]], [[0, 1, 2]]))
    [<warning: 1 isolated vertex (first: vertex 3)>]
    """
    return _native.defects(mesh._shared)


def solvers() -> dict[str, _native.Solver]:
    """Every solver by name, with the paper to cite.

    >>> solvers()["mmp"].family
    'MMP'
    """
    return {solver.name: solver for solver in _native.solvers()}


def _arrays_of(mesh: Any) -> tuple[Any, Any]:
    """Of another package's mesh: vertices and faces."""
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return mesh.vertices, mesh.faces
    if hasattr(mesh, "points") and hasattr(mesh, "cells"):
        kinds = {block.type for block in mesh.cells}
        if kinds == {"triangle"}:
            return mesh.points, np.concatenate([block.data for block in mesh.cells])
        raise ValueError(f"the mesh has cells of {', '.join(sorted(kinds))}: triangles are needed")
    raise ValueError(
        "a mesh is made from vertices and faces, or from one object that has them, or points and"
        " cells"
    )


def _in_python(message: str) -> str:
    """A message of the program, with arguments in place of its flags."""
    for flag in ("--repair", "--cross-non-manifold"):
        message = message.replace(flag, f"{flag[2:].replace('-', '_')}=True")
    return message


def _configured(solver: str, parameters: dict[str, float | str]) -> str:
    """The solver's name with values of its parameters: "avtp?lambda=32"."""
    for name in ("radius", "max_distance", "cutoff"):
        if name in parameters:
            raise ValueError(f"there is no {name}: a distance to stop at is limit=")
    values = "&".join(f"{key.replace('_', '-')}={value}" for key, value in parameters.items())
    return f"{solver}?{values}" if values else solver


@contextmanager
def _bar(total: int, shown: bool) -> Iterator[Callable[[int], None] | None]:
    """What a bar is told of the rows that are done; None without a bar."""
    if not shown:
        yield None
        return
    from tqdm.auto import tqdm

    with tqdm(total=total, unit="row") as bar:

        def show(done: int) -> None:
            bar.update(done - bar.n)

        yield show
