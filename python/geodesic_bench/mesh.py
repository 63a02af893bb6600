"""Meshes and geodesic distances on them."""

from __future__ import annotations

import inspect
import logging
import math
import os
import re
import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from hashlib import sha256
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from geodesic_bench import _native
from geodesic_bench.arrays import (
    NONE,
    Place,
    Points,
    PointSets,
    chosen,
    face_array,
    number,
    numbers,
    point_sets,
    surface_point,
    surface_points,
    vertex_array,
)
from geodesic_bench.errors import UnknownArgument
from geodesic_bench.field import Field
from geodesic_bench.immutable import Immutable
from geodesic_bench.lines import Isoline, LogMap, Path, StraightestLine
from geodesic_bench.matrix_file import MatrixFile
from geodesic_bench.other_packages import arrays_of, read_by_other_package
from geodesic_bench.prepared import Prepared, loaded

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

FASTEST = "edge-based"
PREPARED = "straight-graph"
BREAK_EVEN = 5
"""Number of sources from which on it takes less time to prepare PREPARED than to solve exactly."""
ROWS_AT_ONCE = 64
"""Rows a thread of a matrix file between two records of what is finished."""
MOST_THREADS = 1024
MOST_THREADS_OF_A_SOLVER = 256

_NONE_JOINED = np.zeros(0, np.uint32)

_log = logging.getLogger("geodesic_bench")

OF_OTHER_PACKAGES = {
    "cutoff": "limit",
    "max_dist": "limit",
    "max_distance": "limit",
    "maxdist": "limit",
    "n_jobs": "threads",
    "num_threads": "threads",
    "radius": "limit",
    "workers": "threads",
}
"""Names of arguments in other packages, with the equivalent names here."""

SurfacePoint = ArrayLike | tuple[int, ArrayLike] | Place
"""A vertex, which is an integer; a point in a face, which is a tuple of the face and a weight for each of its
corners; or a Place. The weights are divided by their sum; on an edge one of them is 0."""

SurfacePoints = SurfacePoint | Sequence[SurfacePoint] | tuple[ArrayLike, ArrayLike]
"""One point; an array of vertices, integers of shape (k,); one of places, floats of shape (k, 3); a tuple of
arrays for points in faces, integers of shape (k,) and weights of shape (k, 3); or a list of any points."""


class Mesh(Immutable):
    """A triangle mesh for queries of distances and paths. It is immutable, and any number of threads may
    use it.

    Parameters
    ----------
    vertices : (n, 3) or (n, 2) real numbers, or a mesh of another package
        Coordinates, of any type and memory order; copied as float64. Without z it is 0. Without `faces`, a
        tuple of both, or a mesh of triangles of trimesh, PyVista, Open3D, meshio or nibabel (GIFTI).
    faces : (m, 3) integers, m > 0
        Indices of vertices from 0, counter-clockwise seen from outside; copied. A flat array is read as those of
        VTK: [3, a, b, c, 3, ...].
    repair : bool
        Repair defects that make distances meaningless and are otherwise refused (docs/adding-a-mesh.md).
        Vertices keep their numbers, and none are joined.
    cross_non_manifold : bool
        Paths cross edges of more than two faces, from a face into each of the others, and edges between
        faces of inconsistent orientation. Otherwise such edges are refused, or with `repair` boundaries.
        Only these solvers support it: edge-based, mmp, fwp-mmp.
    weld : bool or number
        Join the vertices at the same place, or within this distance of each other, so that paths cross
        seams. All keep their numbers, and each has the distance of the one of least number that it is
        joined to, which `faces` names then. A face that collapses stays in `faces`; it contains no points. Vertices
        without a face are not joined: a joined mesh is passed on as it is, not as its two arrays.
    avoid : integers or (n,) booleans
        Vertices that paths may not enter: all their faces are left out, after the weld. Distances are those
        of the mesh without these faces, and inf at a vertex without another face. All numbers stay, and
        `faces` as well; an avoided face contains no points.
    avoid_faces : integers or (m,) booleans
        The same for faces.

    Raises
    ------
    ValueError
        For arrays of another shape, a face with a repeated or missing vertex, a coordinate that is
        not finite, other defects that make distances meaningless, a distance that is negative or not
        finite, a mask of another length, and when all faces are avoided.

    Repairs give one UserWarning, and so do vertices of different faces at the same place that are not joined.

    The mesh keeps the solver of the last query and its memory.

    >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
    >>> mesh
    Mesh(3 vertices, 1 faces)
    >>> mesh.distances([1])
    array([3., 0., 5.])
    """

    _shared: _native.SharedMesh
    _faces: NDArray[np.int64] | None = None

    def __init__(
        self,
        vertices: Any,
        faces: ArrayLike | None = None,
        *,
        repair: bool = False,
        cross_non_manifold: bool = False,
        weld: bool | float = False,
        avoid: ArrayLike | None = None,
        avoid_faces: ArrayLike | None = None,
    ) -> None:
        joined_to, left_out = _NONE_JOINED, list[bool]()
        if isinstance(vertices, Mesh) and faces is None:
            points, corners = vertices.vertices, vertices._shared.faces
            joined_to, left_out = vertices._shared.joined_to, vertices._shared.left_out
            repair = True  # it was repaired, and may have edges that are cut
        else:
            if faces is None:
                vertices, faces = arrays_of(vertices)
            points = vertex_array(vertices)
            corners = face_array(faces, len(points))
        self._shared, remarks = _native.mesh(
            points,
            corners,
            joined_to,
            left_out,
            bool(repair),
            bool(cross_non_manifold),
            _weld_distance(weld),
            _avoided(avoid, avoid_faces),
        )
        if remarks:
            _warn("; ".join(remarks))

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Coordinates, of shape (n, 3); read-only."""
        return self._shared.vertices

    @property
    def faces(self) -> NDArray[np.int64]:
        """Indices of vertices, of shape (m, 3); read-only. Signed, so that differences do not wrap; the mesh keeps
        them from the first use on, in 24 bytes a face."""
        if self._faces is None:
            faces = self._shared.faces.astype(np.int64)
            faces.flags.writeable = False
            self._faces = faces
        return self._faces

    @property
    def _sizes(self) -> tuple[int, int]:
        """Numbers of vertices and faces."""
        return len(self._shared.vertices), len(self._shared.faces)

    @overload
    def distances(
        self,
        sources: SurfacePoints,
        targets: SurfacePoints | None = ...,
        *,
        initial: ArrayLike | None = ...,
        limit: float | None = ...,
        threads: int = ...,
        region_size: int = ...,
        solver: str | Prepared = ...,
        return_nearest: Literal[False] = ...,
        **parameters: float | str,
    ) -> NDArray[np.float64]: ...
    @overload
    def distances(
        self,
        sources: SurfacePoints,
        targets: SurfacePoints | None = ...,
        *,
        initial: ArrayLike | None = ...,
        limit: float | None = ...,
        threads: int = ...,
        region_size: int = ...,
        solver: str | Prepared = ...,
        return_nearest: Literal[True],
        **parameters: float | str,
    ) -> tuple[NDArray[np.float64], NDArray[np.int64]]: ...
    def distances(
        self,
        sources: SurfacePoints,
        targets: SurfacePoints | None = None,
        *,
        initial: ArrayLike | None = None,
        limit: float | None = None,
        threads: int = 1,
        region_size: int = 0,
        solver: str | Prepared = FASTEST,
        return_nearest: bool = False,
        **parameters: float | str,
    ) -> NDArray[np.float64] | tuple[NDArray[np.float64], NDArray[np.int64]]:
        """Returns the distance of every vertex, or of every target, from the nearest source.

        Parameters
        ----------
        sources : (k,) integers, or k points, or one
            Vertices, points in faces, and places in space: `(7, (1, 1, 1))` is the middle of face 7,
            `Place(0.1, 0.2, 0)` is the point of the surface that is nearest to this place. A tuple
            `(faces, weights)` of arrays of shapes (k,) and (k, 3) are k points in faces. Floats of
            shape (k, 3) are k places; one warning is given if any is far from the surface. All solvers
            accept all points. For a solver that supports only vertices, each call makes a finer mesh in which
            the points are vertices.
        targets : (l,) integers, or l points, or one, optional
            Points whose distances are returned; by default all vertices. The solve ends at the farthest one.
        initial : (k,) numbers or one number, >= 0, optional
            Initial distance of each source, in the unit of the coordinates.
        limit : float, optional
            Vertices beyond this distance are not reached; a small limit makes a query fast.
        threads : int
            Threads that work on this query, if the solver has this parameter (edge-based); 0 for the number of
            processors. One thread records the nearest sources. Any number from two on gives the same bits.
        region_size : int
            Vertices of a region of the mesh, with several threads (docs/performance.md); 0 for a choice by the
            size of the mesh.
        solver : str or Prepared
            A name of `solvers()`, or what `prepare` returned. All exact solvers return the same distances up
            to rounding.
        return_nearest : bool
            Also return the nearest source of every vertex or target, where its path begins. The solver
            must be one that remembers paths.
        parameters
            Other parameters of the solver, if it has any: `Solver.parameters`.

        Returns
        -------
        (n,) float64, or (l,) with targets
            Distances in the unit of the coordinates and the order of the vertices or targets; inf for one
            that is unreachable or beyond the limit.
        (n,) int64, or (l,) with targets
            With `return_nearest`, indices into `sources`; -1 where the distance is inf.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> mesh.distances([0, 1], initial=[0, 1.5])
        array([0. , 1.5, 4. ])
        >>> mesh.distances(0, limit=3.5)
        array([ 0.,  3., inf])
        >>> mesh.distances(0, [2, 1])
        array([4., 3.])
        >>> mesh.distances([1, 2], return_nearest=True)
        (array([3., 0., 0.]), array([0, 0, 1]))
        >>> mesh.distances([2, (0, (1, 1, 0))])
        array([1.5, 1.5, 0. ])
        """
        begins = self._sources(sources, initial)
        ends = None if targets is None else self._points(targets, "target")
        most = _limit(limit)
        if threads != 1:
            parameters["threads"] = threads
        if region_size != 0:
            parameters["region_size"] = region_size
        pool = self._pool(solver, parameters, self.distances)
        if not return_nearest:
            return _native.distances(pool, *begins, ends, most)
        if ends is not None:
            return _native.targets_and_nearest(pool, *begins, ends, most)
        solved = _native.solve(pool, *begins, most, False)
        return solved.distances.copy(), solved.nearest

    def solve(
        self,
        sources: SurfacePoints,
        *,
        initial: ArrayLike | None = None,
        limit: float | None = None,
        anywhere: bool = False,
        solver: str | Prepared = FASTEST,
        **parameters: float | str,
    ) -> Field:
        """Solves once for many questions: distances of vertices and points, nearest sources, paths, isolines.

        Parameters
        ----------
        sources : (k,) integers, or k points, or one
        initial : (k,) numbers or one number, >= 0, optional
        limit : float, optional
            As in `distances`.
        anywhere : bool
            Keep the windows of the solve, in about 2 kB a vertex, so that `Field.at`, `nearest_at` and `gradient`
            take about a microsecond for any point of the surface. Solvers that do not propagate windows ignore it.
        solver : str or Prepared
        parameters
            As in `distances`. A solver that remembers paths records them, which makes the solve 1.05 to 1.2
            times as long, on one thread.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> field = mesh.solve([0, 1])
        >>> field.distances, field.nearest, field.path_to(2).length
        (array([0., 0., 4.]), array([0, 1, 0]), 4.0)
        """
        begins = self._sources(sources, initial)
        pool = self._pool(solver, parameters, self.solve)
        return Field(self, _native.solve(pool, *begins, _limit(limit), anywhere))

    def path(
        self,
        source: SurfacePoints,
        target: SurfacePoint,
        *,
        solver: str | Prepared = FASTEST,
        **parameters: float | str,
    ) -> Path:
        """Returns a shortest path over the surface, from the nearest source.

        Parameters
        ----------
        source : one point, or (k,) integers, or k points
        target : one point
            As in `distances`.
        solver : str or Prepared
        parameters
            As in `distances`; the solver must be one that remembers paths.

        Raises
        ------
        ValueError
            If no path leads to the target.

        >>> mesh = Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> path = mesh.path(1, 3)
        >>> path.points
        array([[1. , 0. , 0. ],
               [0.5, 0.5, 0. ],
               [0. , 1. , 0. ]])
        >>> path.faces, round(path.length, 6)
        (array([0, 1]), 1.414214)
        >>> round(mesh.path((0, (0, 1, 1)), 1).length, 6)
        0.5
        >>> mesh.path([0, 2], 3).source  # a place in the list of sources
        0
        """
        end = self._points(target, "target", surface_point)
        begins = self._sources(source)
        pool = self._pool(solver, parameters, self.path)
        (path,) = _native.paths(pool, *begins, end, True)
        assert path is not None
        return Path(*path)

    def paths(
        self,
        source: SurfacePoints,
        targets: SurfacePoints,
        *,
        solver: str | Prepared = FASTEST,
        **parameters: float | str,
    ) -> list[Path | None]:
        """Returns a shortest path to each target from its nearest source, with a single solve, which ends at the
        farthest target.

        Parameters
        ----------
        source : one point, or (k,) integers, or k points
        targets : (k,) integers, or k points, or one
            As in `distances`.
        solver : str or Prepared
        parameters
            As in `path`.

        Returns
        -------
        list of k paths
            None for a target to which no path leads.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> [path.length for path in mesh.paths(0, [1, 2])]
        [3.0, 4.0]
        """
        ends = self._points(targets, "target")
        begins = self._sources(source)
        pool = self._pool(solver, parameters, self.paths)
        return [path and Path(*path) for path in _native.paths(pool, *begins, ends, False)]

    def path_through(
        self,
        points: SurfacePoints,
        *,
        closed: bool = False,
        straighten: bool = False,
        solver: str | Prepared = FASTEST,
        **parameters: float | str,
    ) -> Path:
        """Returns the shortest paths between successive points, joined, with one solve a piece.

        Parameters
        ----------
        points : (k,) integers, or k points
            At least two, as in `distances`; they may repeat.
        closed : bool
            Whether the last point is joined to the first one. The last point of the path is then its first
            one again.
        straighten : bool
            Whether to return the locally shortest curve in the class of the joined paths: what they become
            when they are pulled tight over the surface, which a boundary stops. The first and the last point
            stay in place unless the path is closed; it need not pass the others. At vertices the angle on
            both sides is at least pi, or one of the sides is off the surface.
        solver : str or Prepared
        parameters
            As in `path`.

        Raises
        ------
        ValueError
            If no path leads to one of the points, a closed path shrinks to a point when it is straightened,
            or one is to be straightened on a mesh whose paths cross non-manifold edges.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [3, 4, 0], [0, 4, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> mesh.path_through([0, 1, 2]).length, mesh.path_through([0, 1, 2], closed=True).length
        (7.0, 12.0)
        >>> mesh.path_through([0, 1, 2], straighten=True).length
        5.0
        """
        through = self._points(points, "point")
        pool = self._pool(solver, parameters, self.path_through)
        return Path(*_native.path_through(pool, through, bool(closed), bool(straighten)), 0)

    def isolines(self, distances: ArrayLike, levels: int | Sequence[float] | NDArray[Any]) -> list[Isoline]:
        """Returns the lines of equal distance, ordered by level, then by their face of least number.

        Parameters
        ----------
        distances : (n,) numbers, >= 0 or inf
            One for each vertex, from `distances`. They are interpolated linearly along the edges.
        levels : int, or (k,) numbers > 0
            Distances, whose lines are returned in their order; or the number of levels, which then cut the
            range from 0 to the largest finite distance into equal steps, without its ends.

        A line closes, or ends at a boundary, at an edge of more than two faces, or at a face with a vertex
        whose distance is inf. Smaller distances lie on its left, seen from outside. A vertex whose distance
        is the level counts as farther, and a line that would be this vertex alone is left out.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> (line,) = mesh.isolines(mesh.distances(0), [2])
        >>> line.points
        array([[2., 0., 0.],
               [0., 2., 0.]])
        >>> line.level, line.closed, line.faces, round(line.length, 6)
        (2.0, False, array([0]), 2.828427)
        >>> [line.level for line in mesh.isolines(mesh.distances(0), 3)]
        [1.0, 2.0, 3.0]
        """
        field = numbers(distances, "distances")
        if field.shape != (len(self.vertices),):
            raise ValueError(
                f"distances must have the shape ({len(self.vertices)},), one a vertex, not {field.shape}"
            )
        if isinstance(levels, int | np.integer) and not isinstance(levels, bool):
            if not 1 <= levels <= _native.MOST_LEVELS:
                raise ValueError(
                    f"the number of levels must be between 1 and {_native.MOST_LEVELS}, not {levels}"
                )
            chosen = _native.equal_levels(field, int(levels))
        else:
            chosen = numbers(levels, "levels")
            if chosen.ndim != 1:
                raise ValueError(f"levels must be their number, an integer, or a list, such as [0.5], not {levels!r}")
        lines = _native.isolines(self._shared, field, chosen)
        return [Isoline(points, faces, travelled, level, closed) for level, closed, points, faces, travelled in lines]

    def trace(self, begin: SurfacePoint, direction: float | ArrayLike, length: float) -> StraightestLine:
        """Goes straight on from a point, over the faces. At a vertex the line leaves the same angle on both sides
        (Polthier and Schmies 1998).

        Parameters
        ----------
        begin : one point
            As in `distances`.
        direction : number, or (3,) numbers
            An angle in radians, counter-clockwise, measured on the surface: at a vertex from 0 to `total_angle`, as
            `log_map` has it. Or a vector in space, which is projected to the face, at a vertex to the tangent plane.
        length : number >= 0
            Where the line ends, unless it reaches the boundary before.

        Raises
        ------
        ValueError
            For a vector across the surface or one that leads off it, a vertex without a face, a line through an end
            of an edge without a length, and a mesh with `cross_non_manifold`, whose faces have no orientation.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> line = mesh.trace(0, [1, 1, 0], 1)
        >>> line.points.round(3)[-1], line.ends_at_boundary
        (array([0.707, 0.707, 0.   ]), False)
        >>> mesh.trace(1, 0, 9).length          # along the edge where the angles at vertex 1 begin
        5.0
        """
        at = self._points(begin, "begin", surface_point)
        given = numbers(direction, "direction")
        if given.shape not in ((), (3,)):
            raise ValueError(f"a direction is an angle, or a vector of three numbers, not an array of shape {given.shape}")
        if given.shape == (3,):
            angle = _native.angle_of(self._shared, at, (given[0], given[1], given[2]))
        else:
            angle = float(given)
        ends, points, faces, travelled = _native.trace(self._shared, at, angle, number(length, "length"))
        return StraightestLine(points, faces, travelled, ends)

    def total_angle(self, point: SurfacePoint) -> float:
        """Returns the sum of the angles of the faces at a vertex, in radians; 2 pi at any other point."""
        return _native.total_angle(self._shared, self._points(point, "point", surface_point))

    def log_map(self, source: SurfacePoint, **options: Any) -> LogMap:
        """Returns polar coordinates of every vertex around a source: `Field.log_map` of one solve.

        Parameters
        ----------
        source : one point
            As in `distances`.
        options
            As in `solve`.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> mesh.log_map(0).lengths, mesh.log_map(0).angles.round(3)
        (array([0., 3., 4.]), array([0.   , 0.   , 1.571]))
        """
        return self.solve(source, **options).log_map()

    def pair_distances(
        self,
        a: SurfacePoints,
        b: SurfacePoints,
        *,
        threads: int = 0,
        solver: str | Prepared = FASTEST,
        **parameters: float | str,
    ) -> NDArray[np.float64]:
        """Returns the distance from each point of a list to the point at the same place of another list.

        Pairs that share a point take one solve, which ends at the farthest of their other points. An exact
        solver begins at the points of `b` if fewer of them differ, since its distances are symmetric.

        Parameters
        ----------
        a, b : (k,) integers, or k points, or one
            As the sources of `distances`.
        threads : int
            As in `distance_matrix`.
        solver : str or Prepared
        parameters
            As in `distances`.

        Returns
        -------
        (k,) float64
            Distances in the unit of the coordinates and the order of the pairs; inf where no path leads.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> mesh.pair_distances([0, 1, 0], [1, 2, (0, (0, 1, 1))])
        array([3. , 5. , 2.5])
        """
        begins, ends = self._points(a, "point of a"), self._points(b, "point of b")
        if len(begins) != len(ends):
            raise ValueError(f"a and b must have as many points: {len(begins)} and {len(ends)}")
        workers = _number_of_threads(threads)
        pool = self._pool(solver, parameters, self.pair_distances)
        return _native.pair_distances(pool, begins, ends, workers)

    @overload
    def nearest_point(self, places: Sequence[float]) -> tuple[SurfacePoint, float]: ...
    @overload
    def nearest_point(
        self, places: ArrayLike
    ) -> tuple[list[SurfacePoint], NDArray[np.float64]] | tuple[SurfacePoint, float]: ...
    def nearest_point(
        self, places: ArrayLike
    ) -> tuple[list[SurfacePoint], NDArray[np.float64]] | tuple[SurfacePoint, float]:
        """Returns the point of the surface that is nearest to a place in space.

        Parameters
        ----------
        places : (3,) real numbers or a Place, or (k, 3) or k of them
            Coordinates. The time for each place is linear in the number of faces of the mesh.

        Returns
        -------
        a vertex or a pair (face, three weights), or a list of k
            The nearest points, in the form that `distances` accepts.
        float, or (k,) float64
            Euclidean distances of the places from these points, in the unit of the coordinates.

        >>> mesh = Mesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> mesh.nearest_point([1, 2, 5])
        ((0, (0.25, 0.25, 0.5)), 5.0)
        >>> mesh.nearest_point([[1, 2, 0], [7, 0, 4]])
        ([(0, (0.25, 0.25, 0.5)), 1], array([0., 5.]))
        """
        array = numbers(places, "places")
        if array.ndim not in (1, 2) or array.shape[-1] != 3:
            raise ValueError(f"places must have the shape (3,) or (n, 3), not {array.shape}")
        vertices, faces, weights, distances = _native.nearest_points(
            self._shared, array.reshape(-1, 3)
        )
        points: list[SurfacePoint] = [
            int(vertices[i]) if vertices[i] != NONE else (int(faces[i]), tuple(weights[i].tolist()))
            for i in range(len(vertices))
        ]
        return (points, distances) if array.ndim == 2 else (points[0], float(distances[0]))

    def distance_matrix(
        self,
        rows: SurfacePoints | Sequence[SurfacePoints] | None = None,
        columns: SurfacePoints | None = None,
        *,
        threads: int = 0,
        dtype: DTypeLike | None = None,
        limit: float | None = None,
        progress: bool = False,
        out: NDArray[Any] | str | os.PathLike[str] | None = None,
        approximate: bool = False,
        solver: str | Prepared = FASTEST,
        **parameters: float | str,
    ) -> NDArray[Any] | csr_matrix:
        """Returns the distances from each of some points, or sets of points, which are separate sources.

        Parameters
        ----------
        rows : (k,) integers, or k points, or one, or a list of k lists of points, optional
            Sources, with one solve for each, as in `distances`; by default all vertices. An item that is a
            list is a set: its row has the distances from the nearest of its points. Since lists of three floats
            are places, `[[0, 1, 2], [7, 8]]` are two sets of vertices, and `[[0.0, 1, 2]]` is one place.
        columns : (l,) integers, or l points, or one, optional
            Points whose distances are returned; by default all vertices. A solve ends at the farthest one.
        threads : int
            Number of rows that are solved at the same time; 0 for the number of processors. Each thread
            has a solver with its own memory. The matrix does not depend on this number.
        dtype : float64 or float32
            Type of the matrix, by default that of `out` or float64; solvers always compute in float64.
        limit : float, optional
            Makes the matrix sparse: entries beyond this distance are not stored.
        progress : bool
            Show a progress bar of tqdm.
        out : (k, l) array of float64 or float32, or path, optional
            Where the matrix is written; only without a limit. An array is filled row by row, in any order;
            after Ctrl-C some rows are missing. A path is a .npy file, which may be larger than the memory.
            Until it is complete it is FILE.unfinished, and the same call continues it.
        approximate : bool
            Choose the solver that takes less time: the exact one for fewer than 5 rows, otherwise
            straight-graph, whose distances are never too short (docs/approximate.md). The preparation is kept as
            the solver of the last query. The logger "geodesic_bench" names the choice at level INFO.
        solver : str or Prepared
        parameters
            As in `distances`.

        Returns
        -------
        (k, l) array, or scipy.sparse.csr_matrix with a limit
            Distances in the unit of the coordinates; `out` if it was given, a read-only map of it if it is a
            file. A dense matrix has inf for unreachable points. All stored entries of a sparse matrix are
            reached, including stored zeros.

        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> mesh.distance_matrix([0, 2], columns=[1, 2])
        array([[3., 4.],
               [5., 0.]])
        >>> mesh.distance_matrix([0, 1, 2], limit=4, dtype="float32").nnz
        7
        >>> mesh.distance_matrix([[0, 1], 2])
        array([[0., 0., 4.],
               [4., 5., 0.]])
        >>> middle = (0, (0, 1, 1))
        >>> mesh.distance_matrix([0, middle], columns=[1, middle])
        array([[3. , 2.5],
               [2.5, 0. ]])
        """
        every = np.arange(self._sizes[0]) if rows is None else rows
        given = point_sets(every, "row", *self._sizes)
        sources = _native.PointSets(self._placed(given.all, "row"), given.begins)
        targets = None if columns is None else self._points(columns, "column")
        workers = _number_of_threads(threads)
        name = _name_of_type(out.dtype if dtype is None and isinstance(out, np.ndarray) else dtype)
        if approximate:
            if solver != FASTEST or parameters:
                raise ValueError("approximate=True chooses the solver: leave out solver and its parameters")
            if len(sources) >= BREAK_EVEN and not self._shared.crosses_non_manifold:
                solver = PREPARED
                parameters = {"threads": workers}
            _log.info("distance_matrix of %d rows: solver %s", len(sources), solver)
        pool = self._pool(solver, parameters, self.distance_matrix)
        shape = len(sources), self._sizes[0] if targets is None else len(targets)
        if limit is None:
            with _bar(shape[0], progress) as show:
                if isinstance(out, str | os.PathLike):
                    return self._matrix_file(out, name, pool, given, columns, workers, show)
                matrix = _matrix(shape, name) if out is None else _checked(out, shape, name)
                _native.dense(pool, sources, targets, workers, show, matrix)
            return matrix
        if out is not None:
            raise ValueError("a matrix with a limit is sparse: leave out either out or limit")
        from scipy.sparse import csr_matrix

        sparse = _native.sparse_float64 if name == "float64" else _native.sparse_float32
        most = number(limit, "limit")
        with _bar(shape[0], progress) as show:
            compressed = sparse(pool, sources, targets, most, workers, show)
        return csr_matrix(compressed, shape=shape)

    def _matrix_file(
        self,
        file: str | os.PathLike[str],
        name: str,
        pool: _native.SolverPool,
        given: PointSets,
        columns: SurfacePoints | None,
        workers: int,
        show: Callable[[int], None] | None,
    ) -> NDArray[Any]:
        """As `distance_matrix`, to a file."""
        ends = None if columns is None else surface_points(columns, "column", *self._sizes)
        targets = None if ends is None else _native.surface_points(self._shared, *ends)[0]
        shape = len(given.begins) - 1, self._sizes[0] if ends is None else len(ends.vertices)
        # The threads that prepare do not change the numbers.
        solver = re.sub(r"threads=\d+", "", pool.solver.name)
        arrays = [self.vertices, self._shared.faces, self._shared.joined_to, *given.all, given.begins, *(ends or ())]
        crosses = self._shared.crosses_non_manifold
        told = [_native.__version__, solver, name, crosses, [array.shape for array in arrays]]
        problem = sha256(repr(told).encode() + b"".join(array.tobytes() for array in arrays)).hexdigest()
        unfinished = MatrixFile(file, shape, name, problem)
        try:
            while unfinished.rows < shape[0]:
                begin, end = unfinished.rows, min(unfinished.rows + workers * ROWS_AT_ONCE, shape[0])
                some = given.part(begin, end)
                points, _ = _native.surface_points(self._shared, *some.all)
                sources = _native.PointSets(points, some.begins)
                shown = show and partial(_show_from, show, begin)
                _native.dense(pool, sources, targets, workers, shown, unfinished.part(begin, end))
                unfinished.keep(end)
            return unfinished.finish()
        except BaseException:
            unfinished.leave()
            raise

    def prepare(
        self, *, solver: str = PREPARED, threads: int = 0, **parameters: float | str
    ) -> Prepared:
        """Prepares a solver for many queries. This takes the time of about 4 exact solves; a distance of all
        vertices from a further source then takes about a tenth of an exact solve.

        Parameters
        ----------
        solver : str
            One of `solvers()` that prepares; straight-graph has distances that are never too short
            (docs/approximate.md), and it remembers paths.
        threads : int
            Threads that prepare; 0 for the number of processors. The result does not depend on this number.
        parameters
            As in `distances`. Those of straight-graph are `alpha`, smaller for smaller errors, and `check`, the
            number of random sources from which the errors are measured, for `Prepared.certificate`.

        >>> mesh = Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> prepared = mesh.prepare(alpha=0.1)
        >>> prepared.distance_matrix([0, 2], columns=[1, 3])
        array([[1., 1.],
               [1., 1.]])
        >>> round(prepared.path(1, 3).length, 4)
        1.4142
        """
        known = solvers()
        base = solver.split("?")[0] if isinstance(solver, str) else ""
        if base in known and not known[base].prepares:
            able = ", ".join(name for name, each in known.items() if each.prepares)
            raise ValueError(f"{base} prepares nothing that takes long: ask the mesh itself, or prepare {able}")
        name = _configured(solver, {"threads": threads, **parameters}, self.prepare)
        return Prepared(self, _native.prepare(self._shared, name))

    def load_prepared(self, file: str | os.PathLike[str]) -> Prepared:
        """Reads what `Prepared.save` or the command line wrote for this mesh.

        Parameters
        ----------
        file : path

        Raises
        ------
        OSError
            If the file cannot be read.
        ValueError
            If it is no preparation, or that of another mesh, or damaged.
        """
        saved = FilePath(file).read_bytes()
        try:
            return loaded(self, saved)
        except ValueError as error:
            raise ValueError(f"{os.fspath(file)}: {error}") from None

    def _pool(
        self,
        solver: str | Prepared,
        parameters: dict[str, float | str],
        method: Callable[..., Any],
    ) -> _native.SolverPool:
        if not isinstance(solver, Prepared):
            return _native.pool(self._shared, _configured(solver, parameters, method))
        if solver.mesh is not self:
            raise ValueError("solver is prepared for another mesh: prepare one for this mesh")
        if parameters:
            raise UnknownArgument(f"{solver.solver} is already prepared: leave out {', '.join(parameters)}")
        return solver._pool

    def _sources(
        self, values: SurfacePoints, initial: ArrayLike | None = None
    ) -> tuple[_native.SurfacePoints, NDArray[np.float64]]:
        """Returns the sources and the initial distance of each."""
        points = self._points(values, "source")
        count = (len(points),)
        begin = numbers(0 if initial is None else initial, "initial distances")
        if begin.ndim and begin.shape != count:
            raise ValueError(
                f"initial distances must be one a source: {begin.size} for {count[0]} sources"
            )
        return points, np.broadcast_to(begin, count)

    def _points(
        self, values: SurfacePoints, what: str, convert: Callable[..., Points] = surface_points
    ) -> _native.SurfacePoints:
        """Returns the points on the surface, and warns of a place that is far from it."""
        return self._placed(convert(values, what, *self._sizes), what)

    def _placed(self, given: Points, what: str) -> _native.SurfacePoints:
        points, remark = _native.surface_points(self._shared, *given)
        if remark:
            _warn(f"a {what} {remark}")
        return points

    def __repr__(self) -> str:
        vertices, faces = self._sizes
        return f"Mesh({vertices} vertices, {faces} faces)"

    def __reduce__(self) -> tuple[Any, ...]:
        shared = self._shared
        crosses = shared.crosses_non_manifold
        return _restored, (self.vertices, shared.faces, crosses, shared.joined_to, shared.left_out)


def read_mesh(
    file: str | os.PathLike[str],
    *,
    repair: bool = False,
    cross_non_manifold: bool = False,
    weld: bool | float = False,
    avoid: ArrayLike | None = None,
    avoid_faces: ArrayLike | None = None,
) -> Mesh:
    """Reads an OBJ, OFF, PLY or STL file, or by its suffix a file of triangles that another package reads, if that is
    installed. The mesh has the vertex numbers of the file.

    Parameters
    ----------
    file : path
        By pyvista or meshio: .vtk, .vtu; by pyvista: .vtp; by meshio: .msh, .mesh, .meshb, .med, .xdmf; by trimesh:
        .glb, .gltf, .3mf; by nibabel: .gii, and .pial, .white, .inflated, .smoothwm, .sphere, .orig of FreeSurfer.
    repair : bool
        Repair defects that would be refused (docs/adding-a-mesh.md). Vertices keep their numbers, and none
        are joined.
    cross_non_manifold : bool
        As in Mesh; such edges are then not refused, and a repair does not cut them.
    weld : bool or number
        As in Mesh, before the repair.
    avoid : integers or booleans
        As in Mesh, after the weld and before the repair, in the numbers of the file.
    avoid_faces : integers or booleans
        The same for faces.

    Raises
    ------
    ValueError
        If the file cannot be read, or if its defects make distances meaningless.

    Warnings about the mesh and its repairs are given as one UserWarning.
    """
    mesh = Mesh.__new__(Mesh)
    read = _read_by_other_package(file)
    mesh._shared, remarks = _native.read(
        os.fspath(file),
        bool(repair),
        bool(cross_non_manifold),
        _weld_distance(weld),
        _avoided(avoid, avoid_faces),
        read,
    )
    if remarks:
        _warn(f"{os.fspath(file)}: {'; '.join(remarks)}")
    return mesh


def _restored(
    vertices: NDArray[np.float64],
    faces: NDArray[np.uint32],
    crosses: bool,
    joined_to: NDArray[np.uint32],
    left_out: list[bool],
) -> Mesh:
    """A mesh from its pickle. Its warnings were given before."""
    mesh = Mesh.__new__(Mesh)
    arrays = vertices, faces, joined_to, left_out
    mesh._shared, _ = _native.mesh(*arrays, True, crosses, None, _avoided(None, None))
    return mesh


def _weld_distance(weld: bool | float) -> float | None:
    if isinstance(weld, bool | np.bool_):
        return 0.0 if weld else None
    return number(weld, "weld")


def _read_by_other_package(
    file: str | os.PathLike[str],
) -> tuple[NDArray[np.float64], NDArray[np.uint32]] | None:
    try:
        read = read_by_other_package(file)
        if read is None:
            return None
        points = vertex_array(read[0])
        return points, face_array(read[1], len(points))
    except ValueError as error:
        raise ValueError(f"{os.fspath(file)}: {error}") from None


def _avoided(vertices: ArrayLike | None, faces: ArrayLike | None) -> _native.Avoided:
    return _native.Avoided(*chosen(vertices, "avoid"), *chosen(faces, "avoid_faces"))


def defects(mesh: Mesh) -> list[_native.Defect]:
    """Returns the defects of a mesh, errors first. On a mesh with errors, distances are those of another
    surface than its author meant.

    >>> defects(Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0], [9, 9, 9]], [[0, 1, 2]]))
    [<warning: 1 isolated vertex (first: vertex 3)>]
    """
    return _native.defects(mesh._shared)


def solvers() -> dict[str, _native.Solver]:
    """Returns all solvers by name, with the papers to cite.

    >>> solvers()["mmp"].family
    'MMP'
    """
    return {solver.name: solver for solver in _native.solvers()}


def _configured(solver: str, parameters: dict[str, float | str], method: Callable[..., Any]) -> str:
    """Returns the solver's name with the values of its parameters, such as "avtp?lambda=32".

    @param method the method called by the user, whose argument an unknown parameter name may mean"""
    if not isinstance(solver, str):
        raise ValueError(f"solver must be a name of solvers(), not {solver!r}")
    if parameters and (known := solvers().get(solver.split("?")[0])):
        names = [name for name in inspect.signature(method).parameters if name != "parameters"]
        for key in parameters.keys() - set(known.parameters):
            if key in names:  # of some solvers only
                raise UnknownArgument(f"{known.name} has no parameter '{key}': leave it out")
            names += known.parameters
            if (meant := OF_OTHER_PACKAGES.get(key)) in names:
                raise UnknownArgument(f"no argument named '{key}' (did you mean '{meant}'?)")
            raise UnknownArgument(_native.unknown_name("argument", key, list(dict.fromkeys(names))))
    if "threads" in parameters:
        threads = min(_number_of_threads(parameters["threads"]), MOST_THREADS_OF_A_SOLVER)
        parameters = parameters | {"threads": threads}
    values = "&".join(f"{key.replace('_', '-')}={value}" for key, value in parameters.items())
    return f"{solver}{'&' if '?' in solver else '?'}{values}" if values else solver


def _limit(limit: float | None) -> float:
    return math.inf if limit is None else number(limit, "limit")


def _number_of_threads(threads: object) -> int:
    if not (isinstance(threads, int | np.integer) and 0 <= threads <= MOST_THREADS):
        raise ValueError(
            f"threads must be an integer between 0 and {MOST_THREADS}, not {threads!r}"
        )
    return int(threads) or os.cpu_count() or 1


def _name_of_type(dtype: DTypeLike) -> str:
    try:
        name = np.dtype(dtype).name
    except TypeError:
        name = ""
    if name not in ("float64", "float32"):
        raise ValueError(f"dtype must be float64 or float32, not {dtype}")
    return name


def _matrix(shape: tuple[int, int], name: str) -> NDArray[Any]:
    try:
        return np.empty(shape, name)
    except (MemoryError, ValueError):  # ValueError: its size is no integer of the machine
        raise MemoryError(
            f"no room for a matrix of {shape[0]} rows and {shape[1]} columns in {name}: ask for fewer at a"
            " time, or give a file as out"
        ) from None


def _checked(out: NDArray[Any], shape: tuple[int, int], name: str) -> NDArray[Any]:
    """Returns the array of a user if a matrix of this shape and type can be written to it."""
    if not isinstance(out, np.ndarray):
        raise ValueError(f"out must be an array of numpy or a path, not {type(out).__name__}")
    if out.shape != shape or out.dtype != np.dtype(name):
        raise ValueError(f"out must have the shape {shape} and the type {name}, not {out.shape} and {out.dtype}")
    if not out.flags.writeable:
        raise ValueError("out must be writeable: this array is read-only")
    return out


def _warn(message: str) -> None:
    """Warns with the line that called the package."""
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals["__name__"].startswith("geodesic_bench."):
        level, frame = level + 1, frame.f_back
    warnings.warn(message, stacklevel=level)


def _show_from(show: Callable[[int], None], begin: int, done: int) -> None:
    show(begin + done)


@contextmanager
def _bar(total: int, shown: bool) -> Iterator[Callable[[int], None] | None]:
    """Yields a function that sets the number of finished rows on a progress bar; None without a bar."""
    if not shown:
        yield None
        return
    from tqdm.auto import tqdm

    with tqdm(total=total, unit="row") as bar:

        def show(done: int) -> None:
            bar.update(done - bar.n)

        yield show
