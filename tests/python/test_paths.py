"""Paths from Python have the lengths of the distances and lie in the faces that they name."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

gb = pytest.importorskip("geodesic_bench")


def test_a_path_is_as_long_as_the_distance_and_lies_on_its_faces(mesh: Any) -> None:
    distances = mesh.distances(5)
    for target in (0, 5, 77, len(distances) - 1):
        path = mesh.path(5, target)
        assert path.points.shape == (len(path.faces) + 1, 3)
        np.testing.assert_array_equal(path.points[[0, -1]], mesh.vertices[[5, target]])
        steps = np.linalg.norm(np.diff(path.points, axis=0), axis=1)
        np.testing.assert_allclose(np.cumsum(steps), path.travelled[1:], rtol=1e-12)
        assert path.travelled[0] == 0
        assert path.length == pytest.approx(distances[target], rel=1e-12)
        corners = mesh.vertices[mesh.faces[path.faces]]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        for ends in (path.points[:-1], path.points[1:]):
            off = np.einsum("ij,ij->i", ends - corners[:, 0], normals)
            np.testing.assert_allclose(off, 0, atol=1e-12)


def test_a_line_is_shown_without_its_arrays(mesh: Any) -> None:
    path = mesh.path(5, 77)
    assert repr(path) == f"Path({len(path.points)} points, length={path.length:.6g}, source=0)"
    line = mesh.isolines(mesh.distances(0), [3.0])[0]
    assert repr(line) == f"Isoline({len(line.points)} points, length={line.length:.6g}, level=3.0, closed={line.closed})"


def test_the_nearest_source_is_that_of_the_least_row(mesh: Any) -> None:
    sources, initial = [0, 100, 60], [0.5, 0, 1]
    distances, nearest = mesh.distances(sources, initial=initial, return_nearest=True)
    rows = mesh.distance_matrix(sources) + np.array(initial)[:, None]
    np.testing.assert_allclose(rows[nearest, np.arange(len(nearest))], rows.min(axis=0), rtol=1e-12)
    np.testing.assert_array_equal(distances, mesh.distances(sources, initial=initial))
    targets = [99, 3, (7, (1, 1, 1))]
    ends, of_ends = mesh.distances(sources, targets, initial=initial, return_nearest=True)
    np.testing.assert_array_equal(of_ends[:2], nearest[targets[:2]])
    np.testing.assert_array_equal(ends, mesh.distances(sources, targets, initial=initial))
    between = mesh.distance_matrix(sources, targets[2:])[:, 0] + initial
    assert of_ends[2] == between.argmin()
    _, of_none = mesh.distances([0], [143, 0], limit=2, return_nearest=True)
    assert of_none.tolist() == [-1, 0]
    near, of_near = mesh.distances(sources, limit=2, return_nearest=True)
    np.testing.assert_array_equal(of_near == -1, np.isinf(near))


@pytest.mark.filterwarnings("ignore:.* from the surface, whose nearest point is taken")
def test_paths_by_one_solve_are_those_of_a_solve_each(mesh: Any) -> None:
    targets = [143, (200, (0.5, 0.5, 0)), 5, gb.Place(3, 7.5, 1)]
    paths = mesh.paths(5, targets)
    for path, target in zip(paths, targets, strict=True):
        alone = mesh.path(5, target)
        assert path.length == pytest.approx(alone.length, rel=1e-14)
        np.testing.assert_allclose(path.points, alone.points, atol=1e-12)
        np.testing.assert_array_equal(path.faces, alone.faces)
    assert mesh.paths(5, []) == []
    assert len(mesh.paths(5, 7)) == 1


def tube(sides: int, radii: list[float]) -> Any:
    """A mesh whose rings are regular polygons of these radii, one unit apart."""
    ring, side = np.divmod(np.arange(sides * len(radii)), sides)
    turn = 2 * np.pi * side / sides
    radius = np.array(radii)[ring]
    vertices = np.stack([radius * np.cos(turn), radius * np.sin(turn), ring], axis=1)
    a = np.arange(sides * (len(radii) - 1))
    b = a - a % sides + (a + 1) % sides
    faces = np.concatenate([np.stack([a, b, b + sides], axis=1), np.stack([a, b + sides, a + sides], axis=1)])
    return gb.Mesh(vertices, faces)


def test_a_path_through_points_is_as_long_as_the_paths_between_them(mesh: Any) -> None:
    points = [5, (200, (0.5, 0.5, 0)), 77, 77, (20, (0.2, 0.3, 0.5)), 143]
    pieces = [mesh.path(a, b).length for a, b in zip(points, points[1:], strict=False)]
    path = mesh.path_through(points)
    assert path.length == pytest.approx(sum(pieces), rel=1e-12)
    assert path.points.shape == (len(path.faces) + 1, 3)
    closed = mesh.path_through(points, closed=True)
    assert closed.length == pytest.approx(sum(pieces) + mesh.path(143, 5).length, rel=1e-12)
    np.testing.assert_array_equal(closed.points[0], closed.points[-1])
    straight = mesh.path_through(points, straighten=True)
    assert mesh.path(5, 143).length * (1 - 1e-12) <= straight.length < path.length
    np.testing.assert_array_equal(straight.points[[0, -1]], mesh.vertices[[5, 143]])


def test_a_loop_around_a_tube_becomes_the_polygon_at_its_waist() -> None:
    waist = tube(9, [2.0, 1.5, 1.0, 1.5, 2.0])
    loop = waist.path_through([0, 3, 15], closed=True, straighten=True)
    assert loop.length == pytest.approx(18 * np.sin(np.pi / 9), rel=1e-12)
    np.testing.assert_array_equal(loop.points[0], loop.points[-1])
    with pytest.raises(ValueError, match="^the loop shrinks to a point: it can be contracted on this surface$"):
        waist.path_through([0, 1, 10], closed=True, straighten=True)
    with pytest.raises(ValueError, match="at least two"):
        waist.path_through([3])
