"""Fields of distances, which answer many questions with one solve."""

from __future__ import annotations

import os
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from geodesic_bench import _native
from geodesic_bench.arrays import surface_point
from geodesic_bench.immutable import Immutable
from geodesic_bench.lines import Isoline, LogMap, Path

if TYPE_CHECKING:
    from geodesic_bench.mesh import Mesh, SurfacePoint, SurfacePoints


class Field(Immutable):
    """The distances from the nearest of some sources, and the paths from it, from `Mesh.solve`. It is immutable,
    and any number of threads may use it. It keeps its mesh, and 32 bytes a vertex, with `anywhere=True` about
    2,000; no solver.

    With a solver that does not remember paths, `distances`, `at` and `isolines` work; the others raise a
    ValueError.

    >>> from geodesic_bench import Mesh
    >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
    >>> field = mesh.solve([1, 2])
    >>> field
    Field(of Mesh(3 vertices, 1 faces))
    >>> field.distances, field.nearest
    (array([3., 0., 0.]), array([0, 0, 1]))
    """

    mesh: Mesh
    """The mesh of the distances."""

    def __init__(self, mesh: Mesh, solved: _native.Field) -> None:
        self.mesh = mesh
        self._solved = solved

    @property
    def distances(self) -> NDArray[np.float64]:
        """(n,): the distance of every vertex, inf where no path leads within the limit; read-only."""
        return self._solved.distances

    @cached_property
    def nearest(self) -> NDArray[np.int64]:
        """(n,): for every vertex the index of its nearest source among the sources, -1 where the distance is inf;
        read-only. Found when it is first read, in linear time."""
        nearest = self._solved.nearest
        nearest.flags.writeable = False
        return nearest

    def at(self, points: SurfacePoints) -> NDArray[np.float64]:
        """Returns the distances of points.

        Parameters
        ----------
        points : (k,) integers, or k points, or one
            As the sources of `Mesh.distances`. The distance of a vertex is looked up. Another point takes about a
            microsecond in a field that was solved with `anywhere=True`. Otherwise the data of the solve are
            searched, on scans for 1 to 10 ms in the mean; a solver that does not remember paths solves once more
            for all.

        Returns
        -------
        (k,) float64
            Distances as exact as those of the vertices; inf where no path leads within the limit.

        >>> from geodesic_bench import Mesh
        >>> field = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).solve(0)
        >>> field.at([1, (0, (0, 1, 1))])
        array([3. , 2.5])
        """
        return self._solved.at(self.mesh._points(points, "point"))

    def nearest_at(self, points: SurfacePoints) -> NDArray[np.int64]:
        """Returns the nearest sources of points, as indices into the sources.

        Parameters
        ----------
        points : (k,) integers, or k points, or one
            As in `at`, which takes as long.

        Returns
        -------
        (k,) int64
            -1 where the distance is inf.
        """
        return self._solved.nearest_at(self.mesh._points(points, "point"))

    def gradient(self, points: SurfacePoints) -> NDArray[np.float64]:
        """Returns the gradients of the distance at points: vectors of length 1 in the planes of their faces, in
        which the shortest path arrives. At a vertex that is the plane of the face in which the path ends.

        Parameters
        ----------
        points : (k,) integers, or k points, or one
            As in `at`. For others than vertices the field must be solved with `anywhere=True`.

        Returns
        -------
        (k, 3) float64
            nan at a source and where no path leads within the limit. The negative gradient points back along the
            path.

        >>> from geodesic_bench import Mesh
        >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> mesh.solve(0, anywhere=True).gradient((0, (0, 1, 1)))
        array([[0.6, 0.8, 0. ]])
        """
        return self._solved.gradients(self.mesh._points(points, "point"))

    def path_to(self, point: SurfacePoint) -> Path:
        """Returns a shortest path from the nearest source to a point, without another solve.

        Parameters
        ----------
        point : one point
            As in `Mesh.distances`.

        Raises
        ------
        ValueError
            If no path leads to the point within the limit.

        >>> from geodesic_bench import Mesh
        >>> field = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).solve([1, 2])
        >>> path = field.path_to(0)
        >>> path.length, path.source
        (3.0, 0)
        """
        (path,) = self._solved.paths_to(self.mesh._points(point, "point", surface_point), True)
        assert path is not None
        return Path(*path)

    def paths_to(self, points: SurfacePoints) -> list[Path | None]:
        """Returns a shortest path from the nearest source to each point, without another solve.

        Parameters
        ----------
        points : (k,) integers, or k points, or one
            As in `Mesh.distances`.

        Returns
        -------
        list of k paths
            None where no path leads within the limit.
        """
        found = self._solved.paths_to(self.mesh._points(points, "point"), False)
        return [path and Path(*path) for path in found]

    def isolines(self, levels: int | Sequence[float] | NDArray[Any]) -> list[Isoline]:
        """Returns the lines of equal distance, as `Mesh.isolines`.

        Parameters
        ----------
        levels : int, or (k,) numbers > 0
            As in `Mesh.isolines`.
        """
        return self.mesh.isolines(self.distances, levels)

    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes the mesh with its distances.

        Parameters
        ----------
        file : path
            .ply, binary, with the property `quality`, by which MeshLab colours; or .vtk, the binary legacy format of
            ParaView and PyVista, with the point data `distance`. Unreachable vertices have inf.

        Raises
        ------
        ValueError, OSError
            For another suffix, and when the file cannot be written.
        """
        FilePath(file).write_bytes(self._solved.file_bytes(os.fspath(file)))

    def log_map(self) -> LogMap:
        """Returns polar coordinates of every vertex around its nearest source: the length of its shortest path, and
        the angle at which that leaves the source. On planes and cones both are exact; beyond a saddle vertex, where
        paths bend, all vertices of its shadow have the angle of the path to it. `Mesh.trace` goes back.

        Raises
        ------
        ValueError
            For the reasons of `path_to` and `Mesh.trace`.
        """
        return LogMap(*self._solved.log_map())

    def __reduce__(self) -> NoReturn:
        raise TypeError("a field cannot be pickled: pickle its distances, or the mesh, and solve again")

    def __repr__(self) -> str:
        return f"Field(of {self.mesh!r})"
