"""Points in faces are accepted wherever vertices are. Every solver gives the same bits as the program."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import Arrays, solve

gb = pytest.importorskip("geodesic_bench")

pytestmark = pytest.mark.filterwarnings("ignore:.* from the surface, whose nearest point is taken")

POINTS: list[Any] = [
    5,
    (3, (0.2, 0.3, 0.5)),
    (200, (0.5, 0.5, 0.0)),
    (9, (0.0, 1.0, 0.0)),
    (np.array(17), np.array([0.25, 0.5, 0.25])),
    (3, (0.2, 0.3, 0.5)),
]
SOLVERS = ["edge-based", "mmp", "ch", "dijkstra"]


def written(points: list[Any]) -> str:
    return ",".join(
        str(p) if isinstance(p, int) else f"face:{p[0]}:" + ",".join(str(float(w)) for w in p[1])
        for p in points
    )


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_matrix_between_points_is_the_bits_of_the_program(
    solver: str, file: Path, tmp_path: Path
) -> None:
    mesh = gb.read_mesh(file)
    asked = (file, "--solver", solver, "--source", written(POINTS))
    columns = [(7, (0.1, 0.1, 0.8)), 140, (3, (0.2, 0.3, 0.5))]
    solve(*asked, "--each", "--output", tmp_path / "all.npy")
    whole = np.load(tmp_path / "all.npy")
    np.testing.assert_array_equal(mesh.distance_matrix(POINTS, solver=solver), whole)
    near = mesh.distance_matrix(POINTS, limit=6, solver=solver)
    assert 0 < near.nnz < whole.size
    np.testing.assert_array_equal(near.toarray(), np.where(whole <= 6, whole, 0))

    said = json.loads(solve(*asked, "--each", "--target", written(columns)))
    some = np.array([each["at_targets"] for each in said["solves"]])
    np.testing.assert_array_equal(mesh.distance_matrix(POINTS, columns, solver=solver), some)
    single = mesh.distance_matrix(POINTS, columns, threads=2, dtype="float32", solver=solver)
    np.testing.assert_array_equal(single, some.astype(np.float32))


@pytest.mark.parametrize("solver", SOLVERS)
def test_distances_from_points_are_the_bits_of_the_program(
    solver: str, file: Path, tmp_path: Path
) -> None:
    output = tmp_path / "distances.txt"
    solve(file, "--solver", solver, "--source", written(POINTS[1:3]) + "+0.75", "--output", output)
    got = gb.read_mesh(file).distances(POINTS[1:3], initial=[0, 0.75], solver=solver)
    np.testing.assert_array_equal(got, np.loadtxt(output))


def test_nearest_sources_and_paths_are_those_of_the_program(file: Path, tmp_path: Path) -> None:
    mesh = gb.read_mesh(file)
    output, paths = tmp_path / "distances.txt", tmp_path / "paths.json"
    asked = (file, "--solver", "edge-based", "--source")
    solve(*asked, written(POINTS), "--nearest-source", "--output", output, "--limit", 7)
    distances, nearest = mesh.distances(POINTS, limit=7, return_nearest=True)
    assert {-1, 0, 1, 2, 3, 4} == set(nearest.tolist())
    np.testing.assert_array_equal(np.stack([distances, nearest], axis=1), np.loadtxt(output))

    for target in [POINTS[4], 140]:
        solve(*asked, written([POINTS[1]]), "--target", written([target]), "--stop-at-targets",
              "--paths", paths)  # fmt: skip
        (expected,) = json.loads(paths.read_text())["paths"]
        got = mesh.path(POINTS[1], target)
        assert len(got.points) > 2
        assert got.points.tolist() == [point["position"] for point in expected["points"]]
        assert got.travelled.tolist() == [point["travelled"] for point in expected["points"]]
        assert got.faces.tolist() == [point["next_face"] for point in expected["points"][:-1]]
        assert got.length == expected["length"]


def test_a_place_is_the_point_of_the_program_wherever_points_are_taken(
    file: Path, tmp_path: Path
) -> None:
    mesh = gb.read_mesh(file)
    place, other = gb.Place(3.25, 4.5, 1), gb.Place(7.5, 2.25, -1.0)
    output = tmp_path / "d.npy"
    solve(file, "--source", "at:3.25,4.5,1,17,at:7.5,2.25,-1", "--output", output)
    expected = np.load(output)
    np.testing.assert_array_equal(mesh.distances([place, 17, other]), expected)
    points, above = mesh.nearest_point([place, other])
    np.testing.assert_allclose(mesh.distances([17, *points]), expected, rtol=1e-12)
    assert mesh.nearest_point(other) == (points[1], above[1])

    between = mesh.distance_matrix(np.array([place, other]), columns=[place, 0], limit=20)
    np.testing.assert_allclose(between.toarray(), mesh.distance_matrix(points, [points[0], 0]))
    path = mesh.path(place, np.array([other], np.float32))
    assert path.length == pytest.approx(mesh.distance_matrix(place, other)[0, 0], rel=1e-12)
    feet = path.points[[0, -1]]
    np.testing.assert_allclose(np.linalg.norm(feet - np.array([place, other]), axis=1), above, rtol=1e-12)


def test_no_point_of_the_surface_is_nearer_than_the_nearest(mesh: Any) -> None:
    chance = np.random.default_rng(5)
    places = chance.uniform(-2, 13, (40, 3))
    faces = chance.integers(len(mesh.faces), size=5000)
    weights = chance.dirichlet([0.5, 0.5, 0.5], 5000)
    some = np.einsum("ij,ijk->ik", weights, mesh.vertices[mesh.faces[faces]])
    points, distances = mesh.nearest_point(places)
    assert any(isinstance(point, int) for point in points)
    assert any(isinstance(point, tuple) for point in points)
    for place, distance in zip(places, distances, strict=True):
        assert distance <= np.linalg.norm(some - place, axis=1).min()
    assert mesh.nearest_point(np.zeros((0, 3)))[0] == []
    for wrong in (1.0, [1, 2], [[[1, 2, 3]]]):
        with pytest.raises(ValueError, match=r"^places must have the shape \(3,\) or \(n, 3\), not"):
            mesh.nearest_point(wrong)


def test_one_point_is_a_list_of_it(ground: Arrays) -> None:
    mesh = gb.Mesh(*ground)
    point = (3, (1, 2, 3))
    expected = mesh.distances([point])
    np.testing.assert_array_equal(mesh.distances(point), expected)
    np.testing.assert_array_equal(mesh.distances((point, 7)), mesh.distances([7, point]))
    np.testing.assert_array_equal(mesh.distance_matrix(point, columns=point), [[0]])
    corner = (3, (0, 0, 2))
    np.testing.assert_array_equal(mesh.distances(corner), mesh.distances(ground[1][3][2]))


def test_numbers_are_read_alike_wherever_points_are_taken(mesh: Any) -> None:
    """Three numbers may be vertices or a place. They are vertices if they are integers, and refused otherwise."""
    whole, place = np.array([1.0, 2.0, 0.0]), gb.Place(1, 2, 0)
    asks: list[Callable[[Any], Any]] = [
        mesh.distances,
        mesh.distance_matrix,
        lambda points: mesh.distances(5, points),
        lambda points: mesh.distance_matrix([5], points),
        lambda points: [path.length for path in mesh.paths(5, points)],
    ]
    for ask in asks:
        with pytest.raises(ValueError, match=r"float64: write \.astype\(int\) for indices, or Place\(x, y, z\) for a"):
            ask(whole)
        with pytest.raises(ValueError, match=r"must be integers, not float64: write Place\(x, y, z\) for a place$"):
            ask([0.1, 0.2, 0.3])
        unclear_words = r"s must be an array of vertices, tuples \(face, weights\) and Place"
        if ask == mesh.distance_matrix:  # a list in the list is a set
            unclear_words = r"row vertices must be integers, not float64: write Place\(x, y, z\)"
        for unclear in ([17, (0.2, 0.3, 0.5)], [(0.1, 0.2, 0.3), 17]):
            with pytest.raises(ValueError, match=unclear_words):
                ask(unclear)
        np.testing.assert_array_equal(ask(whole.astype(int)), ask([1, 2, 0]))
        np.testing.assert_array_equal(ask([place]), ask(whole.reshape(1, 3)))
        np.testing.assert_array_equal(ask(place), ask([place]))
        np.testing.assert_array_equal(ask([17, place]), ask((17, place)))
    for wrong in ("1", None, [1, 2]):
        with pytest.raises(ValueError, match="^the coordinates of a source must be "):
            mesh.distances(gb.Place(wrong, 0, 0))


def test_a_place_far_from_the_surface_gives_one_warning_at_the_line_of_the_caller(mesh: Any) -> None:
    """The longest side is 11."""
    near, far, farther = (gb.Place(0, 0, mesh.vertices[0, 2] + above) for above in (0.1, 1, 8))
    asks: list[tuple[Callable[[], Any], str]] = [
        (lambda: mesh.distances([far, 3, farther]), "source"),
        (lambda: mesh.distances(3, farther), "target"),
        (lambda: mesh.path(3, farther), "target"),
        (lambda: mesh.paths(farther, [3]), "source"),
        (lambda: mesh.distance_matrix([farther]), "row"),
    ]
    for ask, what in asks:
        with pytest.warns(UserWarning) as warned:
            ask()
        (one,) = warned
        assert str(one.message).startswith(f"a {what} is ") and one.filename == __file__
        assert "from the surface, whose nearest point is taken; the longest side of the mesh is 11" in str(one.message)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mesh.distances([near, 3])


@pytest.mark.parametrize(
    ("points", "said"),
    [
        ([np.array([3, 7]), np.ones((2, 3))], "a list of int64 of shape (2,) and float64 of shape (2, 3)"),
        ((np.array([3.0, 7]), np.ones((2, 3))), "a tuple of float64 of shape (2,) and float64 of shape (2, 3)"),
        ((np.array([3, 7]), np.ones((2, 2))), "a tuple of int64 of shape (2,) and float64 of shape (2, 2)"),
        (([3, 7, 8], np.ones((2, 3))), "a tuple of int64 of shape (3,) and float64 of shape (2, 3)"),
        ((np.ones((2, 3)), np.array([3, 7])), "a tuple of float64 of shape (2, 3) and int64 of shape (2,)"),
    ],
)  # fmt: skip
def test_arrays_that_are_no_faces_and_weights_are_refused_with_both_forms(
    mesh: Any, points: Any, said: str
) -> None:
    form = "many sources in faces are a tuple (faces, weights), of integers of shape (k,) and numbers of shape (k, 3)"
    with pytest.raises(ValueError) as refusal:
        mesh.distances(points)
    assert str(refusal.value) == f"{form}, not {said}"
    if isinstance(points, tuple):  # a list of two arrays is two sets
        with pytest.raises(ValueError, match=r"^many rows in faces are a tuple \(faces, weights\), of integers"):
            mesh.distance_matrix(points)


def test_several_points_are_refused_where_one_is_meant(mesh: Any) -> None:
    for points, number in (([1, 2, 3], 3), (np.array([1, 2]), 2), ([], 0)):
        for ask in (lambda target: mesh.path(0, target), mesh.solve(0).path_to):
            with pytest.raises(ValueError, match=f"^a (target|point) must be one point, not {number}$"):
                ask(points)


NO_POINT = "a source must be a vertex, a tuple (face, three weights), or Place(x, y, z)"
WEIGHTS = "the weights of a source must be finite, none negative, and not all 0, not "


@pytest.mark.parametrize(
    ("source", "message"),
    [
        (144, "source vertex 144 is not in the mesh of 144 vertices, numbered from 0 to 143"),
        ((1, (0.5, 0.5)), NO_POINT),
        ((-1, (1, 1, 1)), "source face -1 is not in the mesh of 242 faces, numbered from 0 to 241"),
        ((242, (1, 1, 1)), "source face 242 is not in the mesh of 242 faces, numbered from 0 to 241"),
        ((1, (0, 0, 0)), f"{WEIGHTS}(0.0, 0.0, 0.0)"),
        ((1, (1, -1, 1)), f"{WEIGHTS}(1.0, -1.0, 1.0)"),
        ((1, (1, np.inf, 1)), f"{WEIGHTS}(1.0, inf, 1.0)"),
        ((1, ("a", "b", "c")), "the weights of a source must be real numbers, not text"),
        ((1.5, (1, 1, 1)), "the face of a source must be integers, not float64"),
        ("a", "source vertices must be integers, not text"),
    ],
)  # fmt: skip
def test_a_point_that_is_none_is_refused(mesh: Any, source: object, message: str) -> None:
    with pytest.raises(ValueError) as refusal:
        mesh.path(source, 0)
    assert str(refusal.value) == message
    if "three weights" in message and not isinstance(source, tuple):
        return  # other functions read it as a list of vertices
    for ask in (mesh.distances, mesh.solve, mesh.distance_matrix):
        with pytest.raises(ValueError) as refusal:
            ask([7, source] if isinstance(source, tuple) else source)
        what = "row" if ask.__name__ == "distance_matrix" else "source"
        assert str(refusal.value) == message.replace("source", what)
