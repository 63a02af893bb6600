"""Isolines from Python are those of the program, and bad levels are refused in one line."""

from __future__ import annotations

import json
import math
from itertools import groupby
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import solve

gb = pytest.importorskip("geodesic_bench")


def test_an_isoline_lies_on_its_faces_and_has_its_length(mesh: Any) -> None:
    distances = mesh.distances(5)
    lines = mesh.isolines(distances, 7)
    assert {line.level for line in lines} == {distances.max() * i / 8 for i in range(1, 8)}
    for line in lines:
        assert line.points.shape == (len(line.faces) + 1, 3)
        assert line.points.dtype == np.float64
        assert line.closed == (line.points[0] == line.points[-1]).all()
        steps = np.linalg.norm(np.diff(line.points, axis=0), axis=1)
        np.testing.assert_allclose(np.cumsum(steps), line.travelled[1:], rtol=1e-12)
        assert line.travelled[0] == 0
        assert line.length == line.travelled[-1]
        near, far = distances[mesh.faces[line.faces]].min(axis=1), distances[mesh.faces[line.faces]].max(axis=1)
        assert ((near < line.level) & (line.level <= far)).all()


def test_isolines_are_those_of_the_program(file: Path, tmp_path: Path) -> None:
    written = tmp_path / "lines.json"
    printed = json.loads(solve(file, "--source", 5, "--isolines", written, "--levels", 6))["isolines"]
    mesh = gb.read_mesh(file)
    lines = mesh.isolines(mesh.distances(5), 6)
    read = json.loads(written.read_text())["isolines"]
    assert len(read) == len(lines)
    for got, line in zip(read, lines, strict=True):
        assert (got["level"], got["closed"], got["length"]) == (line.level, line.closed, line.length)
        assert [point["position"] for point in got["points"]] == line.points.tolist()
        assert [point["next_face"] for point in got["points"]] == [*line.faces.tolist(), None]
    for level in printed:
        same = [line for line in lines if line.level == level["level"]]
        assert level["lines"] == len(same)
        assert level["length"] == pytest.approx(sum(line.length for line in same), rel=1e-14)


def test_levels_keep_the_order_in_which_they_are_given(mesh: Any) -> None:
    lines = mesh.isolines(mesh.distances(5), [3, 1.5])
    assert [level for level, _ in groupby(line.level for line in lines)] == [3, 1.5]
    assert mesh.isolines(mesh.distances(5), []) == []
    assert mesh.isolines(mesh.distances(5), [1e6]) == []


@pytest.mark.parametrize(
    ("levels", "says"),
    [
        ([math.nan], "the level of an isoline must be a finite distance above 0, not nan"),
        ([1, math.inf], "the level of an isoline must be a finite distance above 0, not inf"),
        ([0], "the level of an isoline must be a finite distance above 0, not 0"),
        (0, "the number of levels must be between 1 and 10000, not 0"),
        (-1, "the number of levels must be between 1 and 10000, not -1"),
        (2**40, "the number of levels must be between 1 and 10000, not 1099511627776"),
        (1.5, "levels must be their number, an integer, or a list, such as [0.5], not 1.5"),
        ([[1]], "levels must be their number, an integer, or a list, such as [0.5], not [[1]]"),
        (True, "levels must be real numbers, not bool"),
        ("3", "levels must be real numbers, not text"),
    ],
)
def test_levels_that_are_none_are_refused(mesh: Any, levels: Any, says: str) -> None:
    with pytest.raises(ValueError, match="") as error:
        mesh.isolines(mesh.distances(0), levels)
    assert str(error.value) == says


def test_distances_that_are_none_are_refused(mesh: Any) -> None:
    distances = mesh.distances(0)
    with pytest.raises(ValueError, match=r"distances must have the shape \(144,\), one a vertex, not \(3,\)"):
        mesh.isolines([0, 1, 2], 3)
    distances[7] = math.nan
    for levels in (3, [1.0]):
        with pytest.raises(ValueError, match="the distance of vertex 7 must be 0 or more, not nan"):
            mesh.isolines(distances, levels)


@pytest.mark.parametrize("suffix", [".obj", ".ply"])
def test_saved_lines_are_the_bytes_of_the_program(suffix: str, mesh: Any, file: Path, tmp_path: Path) -> None:
    by_program, saved = tmp_path / f"a{suffix}", tmp_path / f"b{suffix}"
    field = mesh.solve(7)
    for option, lines in {
        ("--isolines", "--levels", "5"): field.isolines(5),
        ("--paths", "--target", "7,99,140"): field.paths_to([7, 99, 140]),
    }.items():
        solve(file, "--source", 7, *option[1:], option[0], by_program)
        gb.save_lines(saved, lines)
        assert saved.read_bytes() == by_program.read_bytes()


def test_lines_that_cannot_be_saved_are_refused(mesh: Any, tmp_path: Path) -> None:
    field = mesh.solve(7)
    for name, lines, message in (
        ("a.json", [field.path_to(99)], "cannot write '.*a.json': lines are written as .obj or .ply"),
        ("a.obj", [field.path_to(99), *field.isolines(2)], "isolines and other lines need a file each"),
        ("a.obj", [np.zeros((2, 3))], "lines must be paths or isolines, not ndarray"),
    ):
        with pytest.raises(ValueError, match=f"^{message}$"):
            gb.save_lines(tmp_path / name, lines)
    gb.save_lines(tmp_path / "a.obj", [None, mesh.trace(50, 0.0, 1.0)])
    assert (tmp_path / "a.obj").read_text().count("l ") == 1
    gb.save_lines(tmp_path / "one.obj", field.path_to(99))
    assert [each.name for each in sorted(tmp_path.iterdir())] == ["a.obj", "one.obj"]
