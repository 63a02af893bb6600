"""Meshes with vertices at the same place, joined and not."""

from __future__ import annotations

import json
import pickle
import subprocess
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import BENCH, write_obj

gb = pytest.importorskip("geodesic_bench")

# Two unit squares on the edge from (1, 0, 0) to (1, 1, 0), whose vertices are 1, 2 and 4, 5. The last
# face collapses when they are joined.
VERTICES = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [2, 0, 0], [2, 1, 0]]
FACES = [[0, 1, 2], [1, 4, 2], [0, 2, 3], [4, 6, 7], [4, 7, 5]]


def welded(weld: Any = True) -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return gb.Mesh(VERTICES, FACES, weld=weld)


@pytest.mark.parametrize("weld", [True, 0, 1e-6, np.True_])
def test_distances_over_a_welded_seam_are_those_of_the_plane_in_the_numbers_of_the_input(weld: Any) -> None:
    mesh = welded(weld)
    for source in range(8):
        line = np.linalg.norm(np.subtract(VERTICES, VERTICES[source]), axis=1)
        np.testing.assert_allclose(mesh.distances(source), line, rtol=1e-15)
    matrix = mesh.distance_matrix(range(8))
    np.testing.assert_array_equal(matrix[[4, 5]], matrix[[1, 2]])
    np.testing.assert_array_equal(matrix[:, [4, 5]], matrix[:, [1, 2]])
    path = mesh.path((0, (1, 1, 1)), 7)
    assert path.faces[0] == 0 and set(path.faces) < {0, 3, 4}
    assert path.length == pytest.approx(np.hypot(4 / 3, 2 / 3), rel=1e-15)
    assert mesh.nearest_point([1.9, 0.1, 1])[0][0] == 3
    assert gb.defects(mesh) == []


def test_a_seam_that_is_not_joined_gives_one_warning_and_infinite_distances() -> None:
    faces = [FACES[0], *FACES[2:]]
    with pytest.warns(UserWarning, match="2 vertices where an earlier one lies .*; weld=True joins") as warned:
        mesh = gb.Mesh(VERTICES, faces)
    assert len(warned) == 1
    assert np.isinf(mesh.distances(0)[4:]).all()
    assert [defect.kind for defect in gb.defects(mesh)] == ["coincident_vertex", "several_components"]


def test_a_face_that_collapsed_contains_no_point() -> None:
    with pytest.raises(ValueError, match="face 1 collapsed when vertices were joined, .*; name a vertex of it"):
        welded().distances((1, (1, 1, 1)))


@pytest.mark.parametrize("weld", [-1, np.nan, np.inf])
def test_a_weld_takes_no_other_distance(weld: float) -> None:
    with pytest.raises(ValueError, match="must be finite and 0 or more, not"):
        gb.Mesh(VERTICES, FACES, weld=weld)


def test_copies_and_pickles_keep_what_is_joined(tmp_path: Path) -> None:
    mesh = welded()
    expected = mesh.distances(5)
    for copy in (pickle.loads(pickle.dumps(mesh)), gb.Mesh(mesh)):
        np.testing.assert_array_equal(copy.distances(5), expected)
        assert copy.faces.tolist() == mesh.faces.tolist()
    prepared = mesh.prepare()
    prepared.save(tmp_path / "plane.prepared")
    again = welded().load_prepared(tmp_path / "plane.prepared")
    np.testing.assert_array_equal(again.distances(5), prepared.distances(5))


def test_a_file_gives_the_same_bits_from_python_and_from_the_command_line(tmp_path: Path) -> None:
    file, out = tmp_path / "plates.obj", tmp_path / "d.npy"
    write_obj(file, VERTICES, FACES)
    done = "weld: vertices joined to an earlier one: 2; weld: faces left out .*: 1"
    with pytest.warns(UserWarning, match=done) as warned:
        mesh = gb.read_mesh(file, weld=True)
    assert len(warned) == 1
    np.testing.assert_array_equal(mesh.distances(5), welded().distances(5))
    command = [str(BENCH), "solve", "--weld", str(file), "--source", "5", "--output", str(out), "--check"]
    ran = subprocess.run(command, check=True, capture_output=True, text=True)
    assert ran.stderr.count("weld: vertices joined to an earlier one: 2") == 1
    assert "--weld" not in ran.stderr
    np.testing.assert_array_equal(np.load(out), mesh.distances(5))
    assert json.loads(ran.stdout)["vertices"] == 8
