"""Synthetic test data: runs with other rows, meshes with known distances, and recordings in the formats
of real ones.

The windows on the wavefront of a solver are the edges that cross a level after each edge has been moved
by a random offset. The standard deviation of the offsets depends on the solver.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from plots.camera import Floats
from plots.recordings import CURVE, FRAMES, MOMENTS, PATHS, SNAPSHOT
from plots.surface import edges
from plots.zbuffer import Integers
from results.columns import Columns
from results.published import THESIS_SOLVERS
from results.reader import Mesh, Run, Solver, Source

SAMPLES = 64
SPREAD = {"mmp": 0.2, "ich": 0.25, "edge-based": 0.5, "fwp-mmp": 0.7, "fwp-ch": 0.8}
"""Standard deviation of the distances on the wavefront, in mean edge lengths, by solver."""
INEXACT, EXCESS = "dijkstra", 0.05

Geometry = tuple[Floats, Integers]
Data = dict[str, Any]
Changed = Callable[[Callable[[Data], object]], Path]
"""Type of the fixture `changed`."""


def solver(name: str, exactness: str = "exact", **more: Any) -> Solver:
    return Solver(name, "F", "", exactness == "exact", False, "", exactness, **more)


def mesh(name: str, vertices: int = 100) -> Mesh:
    """Returns a mesh that is not a model of the thesis."""
    return Mesh(name, 64 * "0", vertices, 2 * vertices, 1.0, None, False)


def row(of: str, on: str, source: Source = 0, **more: Any) -> Data:
    """Returns the row of one answer. CPU time and real time are 1 ms unless `more` has others."""
    return {
        "solver": of, "mesh": on, "source": source, "repetition_index": 0, "outcome": "ok",
        "processor": "P", "cpu_time": 1.0, "real_time": 1.0, "prepare_time": 0.0, "threads": 1,
    } | more  # fmt: skip


def run_of(
    solvers: Iterable[Solver], meshes: Iterable[Mesh], rows: Sequence[Data], **ours: Any
) -> Run:
    """Returns a run of the rows, with those solvers, meshes and sources that the rows name.

    @param ours members of `geodesic_bench` in the context"""
    sources: dict[str, list[Source]] = {}
    for one in rows:
        known = sources.setdefault(one["mesh"], [])
        known += [one["source"]] * (one["source"] not in known)
    names = {one["solver"] for one in rows}
    return Run(
        Path("run.json"), {"geodesic_bench": {"plugins": []} | ours},
        {each.name: each for each in meshes if each.name in sources},
        {each.name: each for each in solvers if each.name in names},
        sources, [], Columns.of(rows),
    )  # fmt: skip


def with_rows(run: Run, rows: Sequence[Data], **others: Any) -> Run:
    """@param rows rows in the form of the JSON file
    @param others other members of the run"""
    return replace(run, columns=Columns.of(rows), **others)


def data_of(run: Run) -> list[Data]:
    return [row.data for row in run.rows]


def changed_rows(run: Run, change: Callable[[Data], Data | None]) -> Run:
    rows = map(change, data_of(run))
    return with_rows(run, [row for row in rows if row is not None])


def without_recordings(row: Data) -> Data:
    return {key: value for key, value in row.items() if key != "recordings"}


def of_solvers(run: Run, *names: str) -> Run:
    return replace(
        run,
        columns=run.columns.take(run.columns.where("solver", *names)),
        solvers={name: run.solvers[name] for name in names},
        skipped=[skip for skip in run.skipped if skip.solver is None or skip.solver in names],
    )


def grid(columns: int, rows: int, *, closed: bool) -> Integers:
    """Returns the faces of a grid of columns x rows vertices. If `closed`, both directions are periodic."""
    i, j = np.meshgrid(
        np.arange(columns - (not closed)), np.arange(rows - (not closed)), indexing="ij"
    )
    a, b = i * rows + j, (i + 1) % columns * rows + j
    c, d = (i + 1) % columns * rows + (j + 1) % rows, i * rows + (j + 1) % rows
    faces = [np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)]
    both: Integers = np.concatenate([one.reshape(-1, 3) for one in faces])
    return both


def plane(columns: int, rows: int) -> Geometry:
    """Returns a unit square."""
    x, y = np.meshgrid(np.linspace(0, 1, columns), np.linspace(0, 1, rows), indexing="ij")
    vertices = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    return vertices, grid(columns, rows, closed=False)


def torus(columns: int, rows: int, radius: float = 1.0, tube: float = 0.4) -> Geometry:
    u, v = np.meshgrid(
        np.arange(columns) * 2 * np.pi / columns, np.arange(rows) * 2 * np.pi / rows, indexing="ij"
    )
    across = radius + tube * np.cos(v)
    points = [across * np.cos(u), tube * np.sin(v), -across * np.sin(u)]
    return np.column_stack([one.ravel() for one in points]), grid(columns, rows, closed=True)


def sphere(rings: int, segments: int, radius: float = 1.0) -> Geometry:
    """Returns a sphere with outward faces. The first vertex is the north pole (z), the last the south pole."""
    theta, phi = np.meshgrid(
        np.arange(1, rings + 1) * np.pi / (rings + 1), np.arange(segments) * 2 * np.pi / segments,
        indexing="ij",
    )  # fmt: skip
    band = [np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)]
    vertices = np.vstack([[0, 0, 1], np.column_stack([b.ravel() for b in band]), [0, 0, -1]])
    round_ = np.arange(segments)
    after = (round_ + 1) % segments
    last, first = len(vertices) - 1, 1 + (rings - 1) * segments
    faces = [
        np.column_stack([np.zeros_like(round_), 1 + round_, 1 + after]),
        np.column_stack([np.full_like(round_, last), first + after, first + round_]),
    ]
    for ring in range(rings - 1):
        a, b = 1 + ring * segments + round_, 1 + ring * segments + after
        faces += [np.column_stack([a, a + segments, b]),
                  np.column_stack([b, a + segments, b + segments])]  # fmt: skip
    return radius * vertices, np.concatenate(faces).astype(np.int64)


def mean_edge_length(vertices: Floats, faces: Integers) -> float:
    ends = vertices[edges(faces)]
    return float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).mean())


def record(
    run_folder: Path, mesh: str, source: int, geometry: Geometry, distances: Floats
) -> dict[str, str]:
    """Writes RUN/recordings/<mesh>. Returns the `recordings` of each solver of the thesis. Also records
    INEXACT, whose distances are too long by EXCESS in the farther half."""
    vertices, faces = geometry
    folder = run_folder / "recordings" / mesh / f"src{source}"
    folder.mkdir(parents=True)
    np.save(folder.parent / "vertices.npy", vertices.astype("<f4"))
    np.save(folder.parent / "faces.npy", faces.astype("<u4"))
    np.save(folder / "distances.npy", distances.astype("<f8"))
    _record_paths(folder, vertices, source)
    edge = mean_edge_length(vertices, faces)
    (folder / INEXACT).mkdir()
    excess = np.where(distances > np.median(distances), 1 + EXCESS, 1)
    np.save(folder / INEXACT / "distances.npy", (excess * distances).astype("<f8"))
    return {
        solver: _record_solver(folder / solver, run_folder, solver, faces, distances, edge)
        for solver in THESIS_SOLVERS
    }


def _record_paths(folder: Path, vertices: Floats, source: int) -> None:
    """Records straight lines in space as paths. Vertices belong to cells by their distance in space."""
    targets = (source + 1 + np.arange(4) * (len(vertices) // 5)) % len(vertices)
    shares = np.linspace(0, 1, 9)[:, None]
    lines = [vertices[source] + shares * (vertices[to] - vertices[source]) for to in targets]
    np.save(folder / "path_points.npy", np.concatenate(lines).astype("<f4"))
    pieces = np.zeros(len(targets), PATHS)
    pieces["target"], pieces["first"] = targets, len(shares) * np.arange(len(targets))
    np.save(folder / "path_pieces.npy", pieces)
    sources = np.array([source, *targets])
    far = np.linalg.norm(vertices[:, None] - vertices[sources], axis=2)
    np.save(folder / "cell_sources.npy", sources.astype("<u4"))
    np.save(folder / "cells.npy", far.argmin(axis=1).astype("<u4"))


def _record_solver(
    folder: Path, run_folder: Path, solver: str, faces: Integers, distances: Floats, edge: float
) -> str:
    folder.mkdir()
    sides = edges(faces)
    ends = np.sort(distances[sides], axis=1)
    sd = SPREAD[solver] * edge
    random = np.random.default_rng(THESIS_SOLVERS.index(solver))
    moved = random.normal(0, sd, len(sides))
    curve = np.zeros(SAMPLES, CURVE)
    ranked = np.sort(distances)
    for index in range(SAMPLES):
        reached = (index + 1) * len(distances) // SAMPLES
        level = ranked[reached - 1]
        windows = 3 * int(np.count_nonzero((ends[:, 0] < level) & (ends[:, 1] >= level)))
        curve[index] = (reached, windows, max(level - 2 * sd, 0), level, sd)
    np.save(folder / "curve.npy", curve)
    np.save(folder / "reached_by.npy", np.searchsorted(curve["mean"], distances).astype("<u4"))
    moments = {f"snapshot-{moment}": moment / 100 for moment in MOMENTS}
    frames = {f"frame-{i}": i / FRAMES for i in range(1, FRAMES)}
    for name, share in (moments | frames).items():
        level = ranked[int(share * len(distances))]
        on = (ends[:, 0] + moved < level) & (ends[:, 1] + moved >= level)
        snapshot = np.zeros(np.count_nonzero(on), SNAPSHOT)
        snapshot["origin"], snapshot["head"] = sides[on].T
        snapshot["end"] = 1
        snapshot["distance"] = ends[on, 0]
        if on.any():
            np.save(folder / f"{name}.npy", snapshot)
    return str(folder.relative_to(run_folder))
