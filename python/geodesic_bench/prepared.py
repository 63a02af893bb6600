"""Solvers that are prepared for a mesh."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, overload

from numpy.typing import ArrayLike, DTypeLike, NDArray

from geodesic_bench import _native
from geodesic_bench.immutable import Immutable

if TYPE_CHECKING:
    import numpy as np
    from scipy.sparse import csr_matrix

    from geodesic_bench.field import Field
    from geodesic_bench.lines import Path as PathOnMesh
    from geodesic_bench.mesh import Mesh, SurfacePoint, SurfacePoints


@dataclass(frozen=True)
class Certificate:
    """Relative errors that a preparation measured on its own mesh, against an exact solver."""

    sources: int
    """Number of random vertices whose distances to all vertices were compared."""
    mean_error: float
    largest_error: float


class Prepared(Immutable):
    """A solver that is prepared for a mesh, from `Mesh.prepare` or `Mesh.load_prepared`. Its queries are those of
    Mesh, without the arguments of the solver. Any number of threads may use it; they share the preparation. It can
    be pickled, together with its mesh.

    >>> from geodesic_bench import Mesh
    >>> mesh = Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
    >>> prepared = mesh.prepare(threads=1, check=2)
    >>> prepared
    Prepared(straight-graph?check=2 of Mesh(3 vertices, 1 faces))
    >>> prepared.distances([1])
    array([3., 0., 5.])
    >>> prepared.certificate
    Certificate(sources=2, mean_error=0.0, largest_error=0.0)
    """

    mesh: Mesh
    """The mesh, which answers the same queries with `solver=` this object."""

    def __init__(self, mesh: Mesh, pool: _native.SolverPool) -> None:
        self.mesh = mesh
        self._pool = pool

    @property
    def solver(self) -> str:
        """Name of the solver, with the parameters that are not at their default."""
        return self._pool.solver.name

    @property
    def certificate(self) -> Certificate | None:
        """The measured errors, if the parameter `check` asked for them."""
        found = self._pool.certificate
        return None if found is None else Certificate(*found)

    @overload
    def distances(
        self,
        sources: SurfacePoints,
        targets: SurfacePoints | None = ...,
        *,
        initial: ArrayLike | None = ...,
        limit: float | None = ...,
        return_nearest: Literal[False] = ...,
    ) -> NDArray[np.float64]: ...
    @overload
    def distances(
        self,
        sources: SurfacePoints,
        targets: SurfacePoints | None = ...,
        *,
        initial: ArrayLike | None = ...,
        limit: float | None = ...,
        return_nearest: Literal[True],
    ) -> tuple[NDArray[np.float64], NDArray[np.int64]]: ...
    def distances(
        self,
        sources: SurfacePoints,
        targets: SurfacePoints | None = None,
        *,
        initial: ArrayLike | None = None,
        limit: float | None = None,
        return_nearest: bool = False,
    ) -> NDArray[np.float64] | tuple[NDArray[np.float64], NDArray[np.int64]]:
        """As `Mesh.distances`."""
        if return_nearest:  # two calls, since an overload takes a literal
            return self.mesh.distances(
                sources, targets, initial=initial, limit=limit, solver=self, return_nearest=True
            )
        return self.mesh.distances(sources, targets, initial=initial, limit=limit, solver=self)

    def solve(
        self, sources: SurfacePoints, *, initial: ArrayLike | None = None, limit: float | None = None
    ) -> Field:
        """As `Mesh.solve`."""
        return self.mesh.solve(sources, initial=initial, limit=limit, solver=self)

    def path(self, source: SurfacePoints, target: SurfacePoint) -> PathOnMesh:
        """As `Mesh.path`."""
        return self.mesh.path(source, target, solver=self)

    def paths(self, source: SurfacePoints, targets: SurfacePoints) -> list[PathOnMesh | None]:
        """As `Mesh.paths`."""
        return self.mesh.paths(source, targets, solver=self)

    def path_through(
        self, points: SurfacePoints, *, closed: bool = False, straighten: bool = False
    ) -> PathOnMesh:
        """As `Mesh.path_through`."""
        return self.mesh.path_through(points, closed=closed, straighten=straighten, solver=self)

    def pair_distances(self, a: SurfacePoints, b: SurfacePoints, *, threads: int = 0) -> NDArray[np.float64]:
        """As `Mesh.pair_distances`."""
        return self.mesh.pair_distances(a, b, threads=threads, solver=self)

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
    ) -> NDArray[Any] | csr_matrix:
        """As `Mesh.distance_matrix`."""
        return self.mesh.distance_matrix(
            rows,
            columns,
            threads=threads,
            dtype=dtype,
            limit=limit,
            progress=progress,
            out=out,
            solver=self,
        )

    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes the preparation, for `Mesh.load_prepared` and the command line.

        Parameters
        ----------
        file : path
            Replaced if it exists.
        """
        Path(file).write_bytes(_native.saved(self._pool))

    def __repr__(self) -> str:
        return f"Prepared({self.solver} of {self.mesh!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return loaded, (self.mesh, _native.saved(self._pool))


def loaded(mesh: Mesh, saved: bytes) -> Prepared:
    """Returns what was saved."""
    return Prepared(mesh, _native.load(mesh._shared, saved))
