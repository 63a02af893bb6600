"""A field answers with the bits of separate queries, after one solve."""

from __future__ import annotations

import copy
import pickle
import threading
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

gb = pytest.importorskip("geodesic_bench")

pytestmark = pytest.mark.filterwarnings("ignore:.* from the surface, whose nearest point is taken")

SOURCES: list[Any] = [5, (3, (0.2, 0.3, 0.5)), gb.Place(7, 7.5, 1)]
POINTS: list[Any] = [99, (7, (1, 1, 1)), gb.Place(3, 7.5, 1), 5]
TWO_PARTS = (np.vstack([np.eye(3), np.eye(3) + 5]), [[0, 1, 2], [3, 4, 5]])


@pytest.mark.parametrize("solver", ["edge-based", "mmp", "straight-graph"])
def test_a_field_has_the_answers_of_separate_queries(solver: str, mesh: Any) -> None:
    asked: dict[str, Any] = {"initial": [0.5, 0, 1], "limit": 8, "solver": solver}
    field = mesh.solve(SOURCES, **asked)
    distances, nearest = mesh.distances(SOURCES, **asked, return_nearest=True)
    np.testing.assert_array_equal(field.distances, mesh.distances(SOURCES, **asked))
    np.testing.assert_array_equal(field.distances, distances)
    np.testing.assert_array_equal(field.nearest, nearest)
    assert np.isinf(distances).any() and {-1, 0, 1, 2} == set(nearest.tolist())
    at = field.at(POINTS)
    if solver != "straight-graph":  # whose upper bounds differ between a target and a point that is searched
        np.testing.assert_allclose(at, mesh.distances(SOURCES, POINTS, **asked), rtol=1e-12)
    for point, distance, path in zip(POINTS, at, field.paths_to(POINTS), strict=True):
        assert path.length + asked["initial"][path.source] == pytest.approx(distance, rel=1e-12)
        np.testing.assert_array_equal(path.points, field.path_to(point).points)
    assert field.at(7).shape == (1,) and field.at([]).shape == (0,) and field.paths_to([]) == []
    for got, line in zip(field.isolines([1, 2]), mesh.isolines(distances, [1, 2]), strict=True):
        np.testing.assert_array_equal(got.points, line.points)


@pytest.mark.parametrize("solver", ["edge-based", "mmp", "straight-graph"])
def test_a_field_of_windows_has_the_distances_of_targets_at_any_points(solver: str, mesh: Any) -> None:
    asked: dict[str, Any] = {"initial": [0.5, 0, 1], "solver": solver}
    field, searched = mesh.solve(SOURCES, **asked, anywhere=True), mesh.solve(SOURCES, **asked)
    rng = np.random.default_rng(1)
    points = (rng.integers(len(mesh.faces), size=500), rng.dirichlet([1, 1, 1], 500))
    at = field.at(points)
    if solver != "straight-graph":  # which has no windows: these fields are the same
        np.testing.assert_array_equal(at, mesh.distances(SOURCES, points, **asked))
    np.testing.assert_allclose(at, searched.at(points), rtol=1e-12)
    np.testing.assert_array_equal(field.nearest_at(points), searched.nearest_at(points))
    some = list(zip(*points, strict=True))[:20]
    for path, distance, source in zip(field.paths_to(some), at, field.nearest_at(some), strict=False):
        assert path is not None and path.source == source
        ratio = (path.length + asked["initial"][path.source]) / distance
        assert ratio <= 1 + 1e-12
        assert ratio >= 1 - 1e-12 or solver == "straight-graph"  # the path of an upper bound may be shorter


class Column:
    """As those of pandas."""

    def __init__(self, array: Any) -> None:
        self.array = array

    def __array__(self, *_: object, **__: object) -> Any:
        return self.array


def test_two_arrays_name_the_same_points_as_a_list_of_tuples(mesh: Any) -> None:
    faces, weights = np.array([3, 7, 3]), np.array([[1, 1, 1], [0, 1, 3.0], [0.2, 0.3, 0.5]])
    field = mesh.solve(0, anywhere=True)
    pairs = [(int(face), tuple(row)) for face, row in zip(faces, weights, strict=True)]
    np.testing.assert_array_equal(field.at((faces, weights)), field.at(pairs))
    np.testing.assert_array_equal(mesh.distances((faces, weights)), mesh.distances(pairs))
    matrix = mesh.distance_matrix((faces, weights), [0])
    np.testing.assert_array_equal(matrix, mesh.distance_matrix(pairs, [0]))
    as_lists, as_objects = (faces.tolist(), weights.tolist()), (faces.astype(object), weights.astype(object))
    for others in (as_lists, as_objects, tuple(map(Column, (faces, weights))), tuple(map(Column, as_objects))):
        np.testing.assert_array_equal(field.at(others), field.at(pairs))
        np.testing.assert_array_equal(mesh.distance_matrix(others, [0]), matrix)
    with pytest.raises(ValueError, match=r"point face 999999 is not in the mesh"):
        field.at((np.array([3, 999999]), weights[:2]))
    with pytest.raises(ValueError, match=r"not \(-1\.0, 1\.0, 1\.0\)"):
        field.at((faces, np.array([[1, 1, 1], [-1.0, 1, 1], [1, 1, 1]])))


def test_gradients_of_a_plane_lead_away_from_the_nearest_source() -> None:
    x, y = (each.ravel() for each in np.meshgrid(np.arange(5.0), np.arange(4.0)))
    corner = np.flatnonzero((x < 4) & (y < 3))[:, None]
    plane = gb.Mesh(np.column_stack([x, y]), np.concatenate([corner + [0, 1, 6], corner + [0, 6, 5]]))
    field = plane.solve([0, 19], anywhere=True)
    places = np.column_stack([np.random.default_rng(2).uniform(0, [4, 3], (50, 2)), np.zeros(50)])
    away = places - np.column_stack([x, y, np.zeros(20)])[[0, 19]][field.nearest_at(places)]
    lengths = np.linalg.norm(away, axis=1)
    np.testing.assert_allclose(field.at(places), lengths, rtol=1e-12)
    np.testing.assert_allclose(field.gradient(places), away / lengths[:, None], atol=1e-12)
    assert np.isnan(field.gradient(19)).all()
    np.testing.assert_allclose(plane.solve(0).gradient(19), [[0.8, 0.6, 0]])
    with pytest.raises(ValueError, match=r"anywhere=True"):
        plane.solve(0).gradient((0, (1, 1, 1)))


def test_a_field_is_read_only_and_outlives_other_queries_and_the_name_of_its_mesh(mesh: Any) -> None:
    field = mesh.solve([5, 130])
    expected, path = field.distances.copy(), field.path_to(77)
    for array in (field.distances, field.nearest):
        assert not array.flags.writeable
    distances, nearest = mesh.distances([5, 130], return_nearest=True)
    assert distances.flags.writeable and nearest.flags.writeable
    mesh.distances(9)
    mesh.solve(9, solver="mmp")
    view, numbers = field.distances, (field.distances.dtype, field.nearest.dtype)
    del mesh
    np.testing.assert_array_equal(field.path_to(77).points, path.points)
    del field
    np.testing.assert_array_equal(view, expected)
    assert numbers == (np.float64, np.int64)


def test_threads_that_ask_one_field_at_once_get_the_same_bits(mesh: Any) -> None:
    field = mesh.solve(SOURCES)
    expected = field.at(POINTS)
    wrong: list[int] = []

    def ask(name: int) -> None:
        for _ in range(10):
            if not np.array_equal(field.at(POINTS), expected):
                wrong.append(name)

    threads = [threading.Thread(target=ask, args=(name,)) for name in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == []


def test_a_solver_without_paths_has_the_distances_of_a_field_and_refuses_its_paths(mesh: Any) -> None:
    field = mesh.solve(SOURCES, initial=[0, 1, 0], solver="dijkstra")
    queried = {"initial": [0, 1, 0], "solver": "dijkstra"}
    np.testing.assert_array_equal(field.distances, mesh.distances(SOURCES, **queried))
    expected = mesh.distances(SOURCES, POINTS, **queried)
    np.testing.assert_allclose(field.at(POINTS)[1:3], expected[1:3], rtol=1e-12)
    np.testing.assert_array_equal(field.at([99, 5]), field.distances[[99, 5]])
    asks: list[Callable[[], Any]] = [lambda: field.nearest, lambda: field.path_to(3), lambda: field.paths_to([3])]
    for ask in asks:
        with pytest.raises(ValueError, match="^dijkstra does not remember paths: take another solver"):
            ask()


def test_where_no_path_leads_there_is_none_and_the_others_are_kept() -> None:
    mesh = gb.Mesh(*TWO_PARTS)
    field = mesh.solve(0)
    targets = [1, 4, (1, (1, 1, 1)), 2]
    for paths in (mesh.paths(0, targets), field.paths_to(targets)):
        assert [path and round(path.length, 9) for path in paths] == [1.414213562, None, None, 1.414213562]
    assert field.at(targets)[1:3].tolist() == [np.inf, np.inf]
    for ask in (field.path_to, lambda target: mesh.path(0, target)):
        with pytest.raises(ValueError, match="^no path leads to vertex 4$"):
            ask(4)
        with pytest.raises(ValueError, match="^no path leads to the point in face 1$"):
            ask((1, (1, 1, 1)))
    with pytest.raises(ValueError, match="^point vertex 6 is not in the mesh of 6 vertices"):
        field.at(6)


def test_a_path_from_several_sources_is_from_the_nearest(mesh: Any) -> None:
    sources = [0, 100, (3, (0.2, 0.3, 0.5))]
    distances, nearest = mesh.distances(sources, return_nearest=True)
    for target, path in zip(range(144), mesh.paths(sources, range(144)), strict=True):
        assert path.source == nearest[target]
        assert path.length == pytest.approx(distances[target], rel=1e-12)
    assert mesh.path(sources, 101).source == 1


def test_a_field_that_is_to_be_pickled_says_what_can_be(mesh: Any) -> None:
    with pytest.raises(TypeError, match="^a field cannot be pickled: pickle its distances"):
        pickle.dumps(mesh.solve(0))


def test_a_copy_of_what_does_not_change_is_itself(mesh: Any) -> None:
    one = {"mesh": mesh, "field": mesh.solve(0), "prepared": mesh.prepare(threads=1)}
    for name, copied in copy.deepcopy(one).items():
        assert copied is one[name] and copy.copy(copied) is copied
