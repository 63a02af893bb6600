"""Meshes whose edges of more than two faces are crossed."""

from __future__ import annotations

import json
import pickle
import subprocess
from pathlib import Path

import numpy as np
import pytest
from python_package import BENCH, write_obj

gb = pytest.importorskip("geodesic_bench")

# Three unit squares on the edge from (0, 0, 0) to (0, 1, 0); faces of both orientations.
VERTICES = [
    [0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [-1, 0, 0], [-1, 1, 0], [0, 0, 1], [0, 1, 1],
]  # fmt: skip
FACES = [[0, 2, 3], [0, 3, 1], [0, 4, 5], [0, 1, 5], [0, 6, 7], [0, 7, 1]]


@pytest.mark.parametrize("solver", ["edge-based", "mmp", "fwp-mmp"])
def test_any_two_sheets_of_an_edge_are_a_plane(solver: str) -> None:
    mesh = gb.Mesh(VERTICES, FACES, cross_non_manifold=True)
    far = np.hypot(2, 1)
    expected = [1, np.sqrt(2), 0, 1, 2, far, 2, far]
    np.testing.assert_allclose(mesh.distances(2, solver=solver), expected, rtol=1e-15)
    path = mesh.path(2, 7, solver=solver)
    assert path.length == pytest.approx(far, rel=1e-15)
    through = [[1.0, 0, 0], [1 / 3, 1 / 3, 0], [0, 0.5, 0], [0.0, 1, 1]]
    np.testing.assert_allclose(path.points, through, atol=1e-15)


def test_the_command_path_crosses_them_too(tmp_path: Path) -> None:
    write_obj(tmp_path / "book.obj", VERTICES, FACES)
    words = [str(BENCH), "path", "book.obj", "--through", "2,7", "--cross-non-manifold"]
    ended = subprocess.run(words, check=True, capture_output=True, text=True, cwd=tmp_path)
    assert json.loads(ended.stdout)["length"] == pytest.approx(np.hypot(2, 1), rel=1e-15)


def test_without_the_flag_such_an_edge_is_refused_or_made_a_boundary() -> None:
    with pytest.raises(ValueError, match="1 non-manifold edge .*; 1 edge between incons"):
        gb.Mesh(VERTICES, FACES)
    with pytest.warns(UserWarning, match="non-manifold edges cut") as warned:
        mesh = gb.Mesh(VERTICES, FACES, repair=True)
    assert len(warned) == 1
    assert mesh.distances(2)[7] == 1 + np.sqrt(2)
    again = pickle.loads(pickle.dumps(mesh))
    assert (again.distances(2) == mesh.distances(2)).all()


def test_a_solver_that_does_not_cross_them_says_so() -> None:
    mesh = gb.Mesh(VERTICES, FACES, cross_non_manifold=True)
    with pytest.raises(ValueError, match="ich: does not cross edges of more than two faces"):
        mesh.distances(0, solver="ich")


def test_a_copy_and_a_file_keep_what_is_crossed(tmp_path: Path) -> None:
    mesh = gb.Mesh(VERTICES, FACES, cross_non_manifold=True)
    expected = mesh.distances(2)
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(mesh)).distances(2), expected)
    write_obj(tmp_path / "book.obj", VERTICES, FACES)
    with pytest.raises(ValueError, match="non-manifold edge"):
        gb.read_mesh(tmp_path / "book.obj")
    with pytest.warns(UserWarning, match="non-manifold edge"):
        read = gb.read_mesh(tmp_path / "book.obj", cross_non_manifold=True)
    np.testing.assert_array_equal(read.distances(2), expected)


def test_a_repair_leaves_the_edges_that_are_crossed(tmp_path: Path) -> None:
    file = tmp_path / "book.obj"
    write_obj(file, VERTICES, [*FACES, FACES[0], [0, 1, 1]])
    with pytest.raises(ValueError, match="1 repeated face .*use repair=True"):
        gb.read_mesh(file, cross_non_manifold=True)
    with pytest.warns(UserWarning, match="repeated faces dropped, the first of each kept: 1") as warned:
        read = gb.read_mesh(file, repair=True, cross_non_manifold=True)
    assert "cut" not in str(warned[0].message)
    far = np.hypot(2, 1)
    np.testing.assert_allclose(read.distances(2), [1, np.sqrt(2), 0, 1, 2, far, 2, far], rtol=1e-15)
