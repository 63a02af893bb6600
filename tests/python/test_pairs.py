"""Distances of pairs: those of a matrix, and of the program."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import solve

gb = pytest.importorskip("geodesic_bench")

CHANCE = np.random.default_rng(3)
A, B = CHANCE.integers(144, size=(2, 80))
POINTS: list[Any] = [5, (3, (0.2, 0.3, 0.5)), (200, (0.5, 0.5, 0.0)), 5, gb.Place(3.25, 4.5, 1)]


@pytest.mark.parametrize("solver", gb.solvers())
def test_pairs_are_the_entries_of_the_matrix(solver: str, mesh: Any) -> None:
    """To 1e-12: a solve from the other end adds the same lengths in another order."""
    matrix = mesh.distance_matrix(solver=solver)
    got = mesh.pair_distances(A, B, solver=solver)
    np.testing.assert_allclose(got, matrix[A, B], rtol=1e-12)
    hub = np.full(80, 7)
    np.testing.assert_array_equal(mesh.pair_distances(hub, B, solver=solver), matrix[7, B])
    np.testing.assert_allclose(mesh.pair_distances(A, hub, solver=solver), matrix[A, 7], rtol=1e-12)


def test_pairs_have_the_same_bits_on_any_number_of_threads(mesh: Any) -> None:
    alone = mesh.pair_distances(A, B, threads=1)
    for threads in (0, 2, 5):
        np.testing.assert_array_equal(mesh.pair_distances(A, B, threads=threads), alone)


@pytest.mark.filterwarnings("ignore:.* from the surface, whose nearest point is taken")
@pytest.mark.parametrize("solver", ["edge-based", "mmp", "ch", "dijkstra"])
def test_pairs_are_of_any_points_and_0_for_the_same(solver: str, mesh: Any) -> None:
    matrix = mesh.distance_matrix(POINTS, POINTS, solver=solver)
    i, j = (each.ravel() for each in np.indices(matrix.shape))
    got = mesh.pair_distances([POINTS[k] for k in i], [POINTS[k] for k in j], solver=solver)
    np.testing.assert_allclose(got, matrix.ravel(), rtol=1e-12, atol=1e-13)
    assert (mesh.pair_distances(POINTS, POINTS, solver=solver) == 0).all()


def test_pairs_in_two_components_are_infinite_and_no_pairs_have_no_distance() -> None:
    apart = gb.Mesh(np.vstack([np.eye(3), np.eye(3) + 5]), [[0, 1, 2], [3, 4, 5]])
    np.testing.assert_array_equal(apart.pair_distances([0, 0, 4], [4, 0, 1]), [np.inf, 0, np.inf])
    assert apart.pair_distances([], []).shape == (0,)
    assert apart.pair_distances(0, 4).shape == (1,)


def test_prepared_pairs_are_those_of_the_prepared_matrix(mesh: Any) -> None:
    prepared = mesh.prepare()
    matrix = prepared.distance_matrix()
    np.testing.assert_allclose(prepared.pair_distances(A, B, threads=2), matrix[A, B], rtol=1e-12)


def test_the_program_writes_the_same_bits_in_every_format(mesh: Any, file: Path, tmp_path: Path) -> None:
    expected = mesh.pair_distances(A, B)
    np.savetxt(tmp_path / "pairs.csv", np.stack([A, B], axis=1), fmt="%d", delimiter=",")
    (tmp_path / "pairs.json").write_text(json.dumps(np.stack([A, B], axis=1).tolist()))
    for pairs in ("pairs.csv", "pairs.json"):
        for threads in (1, 2):
            asked = (file, "--pairs", tmp_path / pairs, "--threads", threads)
            said = json.loads(solve(*asked))
            assert [(each["from"], each["to"]) for each in said["pairs"]] == list(zip(A, B, strict=True))
            np.testing.assert_array_equal([each["distance"] for each in said["pairs"]], expected)
            assert said["pair_count"] == 80 and said["solve_count"] == min(len(set(A)), len(set(B)))
    for output in ("d.txt", "d.npy", "d.csv"):
        assert "pairs" not in json.loads(solve(*asked, "--output", tmp_path / output))
    np.testing.assert_array_equal(np.loadtxt(tmp_path / "d.txt"), expected)
    np.testing.assert_array_equal(np.load(tmp_path / "d.npy"), expected)
    assert (tmp_path / "d.csv").read_text().startswith("pair,distance\n0,")
    np.testing.assert_array_equal(np.loadtxt(tmp_path / "d.csv", delimiter=",", skiprows=1)[:, 1], expected)


@pytest.mark.filterwarnings("ignore:.* from the surface, whose nearest point is taken")
@pytest.mark.parametrize(
    "text",
    [
        "face:3:0.2,0.3,0.5 5\n\n3.25,4.5,1,7,2,1\n",
        '[["face:3:0.2,0.3,0.5", 5], [[3.25, 4.5, 1], "at:7,2,1"]]',
    ],
)
def test_the_program_reads_pairs_of_any_points(text: str, mesh: Any, file: Path, tmp_path: Path) -> None:
    (tmp_path / "pairs").write_text(text)
    said = json.loads(solve(file, "--pairs", tmp_path / "pairs"))
    expected = mesh.pair_distances([POINTS[1], gb.Place(3.25, 4.5, 1)], [5, gb.Place(7, 2, 1)])
    np.testing.assert_array_equal([each["distance"] for each in said["pairs"]], expected)
    assert len(said["places"]) == 2
