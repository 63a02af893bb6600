"""Vertices and faces that paths may not enter."""

from __future__ import annotations

import json
import pickle
import subprocess
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import BENCH, Arrays, rough_ground, write_obj

gb = pytest.importorskip("geodesic_bench")

VERTICES, FACES = rough_ground(12)
WALL = [r * 12 + c for r in range(1, 8) for c in (5, 6)]
CUT = np.isin(FACES, WALL).any(axis=1)


def cut_mesh(**avoid: Any) -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return gb.Mesh(VERTICES, FACES, **avoid)


@pytest.mark.parametrize(
    "avoid",
    [
        {"avoid": WALL},
        {"avoid": np.isin(np.arange(144), WALL)},
        {"avoid": np.isin(np.arange(144), WALL).astype(object)},  # as from a nullable column of pandas
        {"avoid_faces": CUT},
        {"avoid_faces": CUT.tolist()},
        {"avoid_faces": np.flatnonzero(CUT).astype(np.int16)},
        {"avoid": WALL[:4], "avoid_faces": CUT},
    ],
)
def test_distances_are_the_bits_of_the_mesh_without_the_avoided_faces(avoid: dict[str, Any]) -> None:
    mesh, rest = cut_mesh(**avoid), gb.Mesh(VERTICES, FACES[~CUT])
    np.testing.assert_array_equal(mesh.distances(50), rest.distances(50))
    assert not np.array_equal(mesh.distances(50), cut_mesh().distances(50))
    np.testing.assert_array_equal(mesh.faces, FACES)
    assert np.isinf(mesh.distances(0)[WALL]).sum() == len(WALL)
    assert mesh.distances(WALL[3])[WALL[3]] == 0
    assert gb.defects(mesh) == []
    path = mesh.path(50, 59)
    assert path.length == pytest.approx(mesh.distances(50)[59], rel=1e-12)
    assert not CUT[path.faces].any()


def test_an_avoided_face_contains_no_point() -> None:
    face = int(CUT.argmax())
    with pytest.raises(ValueError, match=f"face {face} is avoided; name a point in another face"):
        cut_mesh(avoid=WALL).distances((face, (1, 1, 1)))


def test_copies_and_pickles_keep_what_is_avoided() -> None:
    mesh = cut_mesh(avoid_faces=CUT)
    for copy in (pickle.loads(pickle.dumps(mesh)), gb.Mesh(mesh), gb.Mesh(cut_mesh(avoid=WALL[:5]), avoid=WALL[5:])):
        np.testing.assert_array_equal(copy.distances(3), mesh.distances(3))
        np.testing.assert_array_equal(copy.faces, FACES)


@pytest.mark.parametrize("name, numbers", [("avoid", WALL), ("avoid_faces", np.flatnonzero(CUT).tolist())])
def test_a_file_gives_the_same_bits_from_python_and_from_the_command_line(
    name: str, numbers: list[int], tmp_path: Path
) -> None:
    file, wall, out = tmp_path / "ground.obj", tmp_path / "wall", tmp_path / "d.npy"
    write_obj(file, VERTICES, FACES)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mesh = gb.read_mesh(file, **{name: numbers})
    np.testing.assert_array_equal(mesh.distances(7), cut_mesh(**{name: numbers}).distances(7))
    option = "--" + name.replace("_", "-")
    for text in ("\n".join(map(str, numbers)), json.dumps(numbers)):
        wall.write_text(text)
        command = [str(BENCH), "solve", str(file), option, str(wall), "--source", "7", "--output", str(out), "--check"]
        ran = subprocess.run(command, check=True, capture_output=True, text=True)
        assert ran.stderr == ""
        np.testing.assert_array_equal(np.load(out), mesh.distances(7))


@pytest.mark.parametrize(
    "avoid, says",
    [
        ({"avoid": [144]}, "avoided vertex 144 is not in the mesh of 144 vertices"),
        ({"avoid": [-1]}, "avoid must be numbers of vertices or faces from 0, not -1"),
        ({"avoid_faces": [2**40]}, "avoid_faces must be numbers of vertices or faces from 0, not 1099511627776"),
        ({"avoid_faces": [242]}, "avoided face 242 is not in the mesh of 242 faces"),
        ({"avoid": CUT}, "the mask of avoided vertices has 242 flags, but the mesh has 144 vertices"),
        ({"avoid_faces": np.zeros(144, bool)}, "the mask of avoided faces has 144 flags, but the mesh has 242 faces"),
        ({"avoid_faces": CUT.astype(int)}, "has only the numbers 0 and 1, and repeats them"),
        ({"avoid_faces": CUT.astype(float)}, "must be integers, not float64: write .astype.int. for indices, or "),
        ({"avoid": True}, "avoid must be a list of numbers, or of a boolean for each vertex or face, not of shape"),
        ({"avoid": [[1, 2]]}, "not of shape .1, 2."),
        ({"avoid": np.ones(144, bool)}, "no face is left: all of them are avoided"),
    ],
)
def test_arrays_and_files_refuse_the_same(avoid: dict[str, Any], says: str, file: Path, ground: Arrays) -> None:
    for make, given in ((gb.Mesh, ground), (gb.read_mesh, (file,))):
        with pytest.raises(ValueError, match=says) as refused:
            make(*given, **avoid)
        assert "\n" not in str(refused.value)
