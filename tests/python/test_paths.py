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
