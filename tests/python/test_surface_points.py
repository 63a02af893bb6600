"""Points in faces are taken wherever vertices are: the bits of the program's, by every solver."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import BENCH, Arrays, write_obj

gb = pytest.importorskip("geodesic_bench")

POINTS: list[Any] = [
    5,
    (3, (0.2, 0.3, 0.5)),
    (200, (0.5, 0.5, 0.0)),
    (9, (0.0, 1.0, 0.0)),
    (np.int64(17), np.array([0.25, 0.5, 0.25])),
    (3, (0.2, 0.3, 0.5)),
]
SOLVERS = ["edge-based", "mmp", "ch", "dijkstra"]


def written(points: list[Any]) -> str:
    return ",".join(
        str(p) if isinstance(p, int) else f"face:{p[0]}:" + ",".join(str(float(w)) for w in p[1])
        for p in points
    )


@pytest.fixture(scope="module")
def file(ground: Arrays, tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("points") / "ground.obj"
    write_obj(file, gb.Mesh(*ground))
    return file


def solve(*words: object) -> None:
    subprocess.run([BENCH, "solve", *map(str, words)], check=True, capture_output=True)


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_matrix_between_points_is_the_bits_of_the_program(
    solver: str, file: Path, tmp_path: Path
) -> None:
    mesh = gb.read_mesh(file)
    asked = (file, "--solver", solver, "--source", written(POINTS))
    columns = [(7, (0.1, 0.1, 0.8)), 140, (3, (0.2, 0.3, 0.5))]
    for name, more, matrix in (
        ("all.npy", [], mesh.distance_matrix(POINTS, solver=solver)),
        (
            "some.npy",
            ["--target", written(columns), "--float32"],
            mesh.distance_matrix(POINTS, columns, threads=2, dtype="float32", solver=solver),
        ),
    ):
        solve(*asked, *more, "--matrix", tmp_path / name)
        np.testing.assert_array_equal(matrix, np.load(tmp_path / name))
    solve(*asked, "--target", written(columns), "--limit", 6, "--matrix", tmp_path / "near.npz")
    near = mesh.distance_matrix(POINTS, columns, limit=6, solver=solver)
    expected = np.load(tmp_path / "near.npz")
    assert 0 < near.nnz < near.shape[0] * near.shape[1]
    np.testing.assert_array_equal(near.data, expected["data"])
    np.testing.assert_array_equal(near.indices, expected["indices"])
    np.testing.assert_array_equal(near.indptr, expected["indptr"])


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
    expected = np.loadtxt(output)
    assert {-1, 0, 1, 2, 3, 4} == set(nearest.tolist())
    np.testing.assert_array_equal(np.stack([distances, nearest], axis=1), expected)

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


def test_one_point_is_a_list_of_it(ground: Arrays) -> None:
    mesh = gb.Mesh(*ground)
    point = (3, (1, 2, 3))
    expected = mesh.distances([point])
    np.testing.assert_array_equal(mesh.distances(point), expected)
    np.testing.assert_array_equal(mesh.distances([3, [1, 2, 3]]), expected)
    np.testing.assert_array_equal(mesh.distances((point, 7)), mesh.distances([7, point]))
    np.testing.assert_array_equal(mesh.distance_matrix(point, columns=point), [[0]])
    corner = (3, (0, 0, 2))
    np.testing.assert_array_equal(mesh.distances(corner), mesh.distances(ground[1][3][2]))


NO_POINT = "a source must be a vertex, a face and three weights, or a place in space"
WEIGHTS = "the weights of a source must be finite, none negative, and not all 0, not "


@pytest.mark.parametrize(
    ("source", "message"),
    [
        (144, "source vertex 144 is not in the mesh of 144 vertices"),
        ([1, 2], NO_POINT),
        (np.array([1, 2]), NO_POINT),
        ((1, (0.5, 0.5)), NO_POINT),
        ((-1, (1, 1, 1)), "source face -1 is not in the mesh of 242 faces"),
        ((242, (1, 1, 1)), "source face 242 is not in the mesh of 242 faces"),
        ((1, (0, 0, 0)), f"{WEIGHTS}(0.0, 0.0, 0.0)"),
        ((1, (1, -1, 1)), f"{WEIGHTS}(1.0, -1.0, 1.0)"),
        ((1, (1, np.inf, 1)), f"{WEIGHTS}(1.0, inf, 1.0)"),
        ((1, ("a", "b", "c")), "the weights of a source must be real numbers, not <U1"),
        ((1.5, (1, 1, 1)), "the face of a source must be integers, not float64"),
        ("a", "source vertices must be integers, not <U1"),
    ],
)  # fmt: skip
def test_a_point_that_is_none_is_refused(ground: Arrays, source: object, message: str) -> None:
    with pytest.raises(ValueError) as refusal:
        gb.Mesh(*ground).path(source, 0)
    assert str(refusal.value) == message
    if "three weights" in message and not isinstance(source, tuple):
        return  # a list of vertices elsewhere
    for ask in (gb.Mesh(*ground).distances, gb.Mesh(*ground).distance_matrix):
        with pytest.raises(ValueError) as refusal:
            ask([7, source] if isinstance(source, tuple) else source)
        what = "source" if ask.__name__ == "distances" else "row"
        assert str(refusal.value) == message.replace("source", what)


def test_a_place_is_the_nearest_point_wherever_points_are(ground: Arrays) -> None:
    mesh = gb.Mesh(*ground)
    chance = np.random.default_rng(3)
    corners = mesh.vertices[mesh.faces[chance.integers(len(mesh.faces), size=5)]]
    places = np.einsum("ijk,ij->ik", corners, chance.dirichlet([1, 1, 1], size=5))
    points, away = mesh.nearest_point(places)
    assert away.shape == (5,) and away.max() < 1e-12
    for place, point in zip(places, points, strict=True):
        np.testing.assert_array_equal(mesh.distances(place), mesh.distances([point]))
        np.testing.assert_array_equal(mesh.distances([place, 3]), mesh.distances([point, 3]))
        assert mesh.path(tuple(place), points[0]).length == mesh.path(point, points[0]).length
    rows = mesh.distance_matrix(places, columns=places)
    np.testing.assert_array_equal(rows, mesh.distance_matrix(points, columns=points))
    path = mesh.path(places[0].tolist(), places[1].tolist())
    np.testing.assert_allclose(path.points[[0, -1]], places[:2], atol=1e-12)


def test_the_nearest_point_of_one_place_is_one_point(ground: Arrays) -> None:
    mesh = gb.Mesh(*ground)
    point, away = mesh.nearest_point(mesh.vertices[7] + [0, 0, 0])
    assert (point, away) == (7, 0.0)
    with pytest.raises(ValueError, match=r"places must have the shape \(3,\) or \(k, 3\), not \(2,\)"):
        mesh.nearest_point([1, 2])


def test_a_place_far_from_the_surface_warns_with_its_distance() -> None:
    mesh = gb.Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
    with pytest.warns(UserWarning, match=r"source \(1.0, 1.0, 2.0\) is 2 from the surface") as warned:
        assert mesh.path((1, 1, 2), 0).length == pytest.approx(2**0.5)
    assert warned[0].filename == __file__
