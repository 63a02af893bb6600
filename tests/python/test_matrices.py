"""A matrix of distances: where it is written, and the solver that is chosen for it."""

from __future__ import annotations

import json
import logging
import subprocess
import sys
from array import array
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import BUILD, HERE, Arrays, solve

gb = pytest.importorskip("geodesic_bench")


@pytest.mark.parametrize("dtype", ["float64", "float32"])
def test_a_matrix_is_written_to_an_array_of_any_layout(mesh: Any, dtype: str, tmp_path: Path) -> None:
    expected = mesh.distance_matrix([5, 0, 99], columns=range(20), dtype=dtype)
    shape = expected.shape
    unaligned = np.zeros(expected.nbytes + 1, np.uint8)[1:].view(dtype).reshape(shape)
    for out in (
        np.zeros(shape, dtype),
        np.zeros(shape, dtype, order="F"),
        np.zeros((9, 50), dtype)[6::-3, 5:45:2],
        unaligned,
        np.memmap(tmp_path / "matrix", dtype, mode="w+", shape=shape),
    ):
        for threads in (1, 3):
            out[:] = 0
            got = mesh.distance_matrix([5, 0, 99], columns=range(20), threads=threads, out=out)
            assert got is out
            np.testing.assert_array_equal(out, expected)
    np.testing.assert_array_equal(np.fromfile(tmp_path / "matrix", dtype).reshape(shape), expected)
    surrounded = np.zeros((3, 22), dtype)
    mesh.distance_matrix([5, 0, 99], columns=range(20), out=surrounded[:, 1:-1])
    assert not surrounded[:, [0, -1]].any()


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"out": np.zeros((2, 144))}, "out must have the shape (1, 144) and the type float64, not (2, 144) and float64"),
        ({"out": np.zeros(144)}, "out must have the shape (1, 144) and the type float64, not (144,) and float64"),
        ({"out": np.zeros((1, 144), int)}, "dtype must be float64 or float32, not int64"),
        ({"out": np.zeros((1, 144), ">f8")}, "out must have the shape (1, 144) and the type float64, not (1, 144) and >f8"),
        ({"out": np.zeros((1, 144)), "dtype": "float32"}, "out must have the shape (1, 144) and the type float32, not"),
        ({"out": np.broadcast_to(0.0, (1, 144))}, "out must be writeable: this array is read-only"),
        ({"out": [[0.0] * 144]}, "out must be an array of numpy or a path, not list"),
        ({"out": np.zeros((1, 144)), "limit": 1}, "a matrix with a limit is sparse: leave out either out or limit"),
        ({"approximate": True, "solver": "mmp"}, "approximate=True chooses the solver: leave out solver and its"),
        ({"approximate": True, "alpha": 0.1}, "approximate=True chooses the solver: leave out solver and its"),
    ],
)  # fmt: skip
def test_matrices_that_cannot_be_written_are_refused(mesh: Any, options: Any, sentence: str) -> None:
    with pytest.raises(ValueError) as refused:
        mesh.distance_matrix([0], **options)
    assert str(refused.value).startswith(sentence)


FACE = (3, (0.2, 0.3, 0.5))
SETS: list[Any] = [[0, 1, 2], [7, 8], 5, [FACE, 99, 99], FACE, (140, 141), np.array([3])]


@pytest.mark.parametrize("solver", ["edge-based", "mmp", "ch", "dijkstra"])
def test_a_row_of_a_set_is_the_least_of_the_rows_of_its_points(solver: str, mesh: Any) -> None:
    """To 1e-12: a solve from a set orders its windows otherwise than one from a point."""
    got = mesh.distance_matrix(SETS, solver=solver)
    for row, points in zip(got, SETS, strict=True):
        each = mesh.distance_matrix(list(points) if isinstance(points, list) else points, solver=solver)
        np.testing.assert_allclose(row, each.min(axis=0), rtol=1e-12, atol=1e-13)
    sparse = mesh.distance_matrix(SETS, solver=solver, limit=3.0).toarray()
    np.testing.assert_array_equal(sparse, np.where(got <= 3, got, 0))


def test_rows_of_sets_do_not_depend_on_threads_files_or_columns(mesh: Any, tmp_path: Path) -> None:
    expected = mesh.distance_matrix(SETS, threads=1)
    np.testing.assert_array_equal(mesh.distance_matrix(SETS, threads=3), expected)
    np.testing.assert_array_equal(mesh.distance_matrix(tuple(SETS), columns=[4, 7]), expected[:, [4, 7]])
    many = SETS * 30  # several blocks of rows
    got = mesh.distance_matrix(many, out=tmp_path / "m.npy", threads=1)
    np.testing.assert_array_equal(got, np.tile(expected, (30, 1)))


MIDDLE = "face:3:0.2,0.3,0.5"
WRITTEN: list[list[int | str]] = [[0, 1, 2], [7, 8], [5], [MIDDLE, 99, 99], [MIDDLE], [140, 141], [3]]
"""SETS as the program reads them."""


@pytest.mark.parametrize("solver", ["edge-based", "dijkstra"])
def test_rows_of_sets_are_the_bits_of_the_program(solver: str, mesh: Any, file: Path, tmp_path: Path) -> None:
    single = [each[0] if len(each) == 1 else each for each in WRITTEN]
    (tmp_path / "sets.json").write_text(json.dumps(single))
    (tmp_path / "sets.csv").write_text("\n\n".join(",".join(map(str, each)) for each in WRITTEN))
    expected = mesh.distance_matrix(SETS, solver=solver)
    columns = [4, 7]
    for sets, threads in (("sets.json", 1), ("sets.csv", 3)):
        asked = (file, "--sets", tmp_path / sets, "--solver", solver, "--threads", threads)
        said = json.loads(solve(*asked, "--target", "4,7", "--output", tmp_path / "rows.npy"))
        assert [each["sources"] for each in said["solves"]] == WRITTEN
        np.testing.assert_array_equal(np.load(tmp_path / "rows.npy"), expected)
        np.testing.assert_array_equal([each["at_targets"] for each in said["solves"]], expected[:, columns])
    solve(*asked, "--output", tmp_path / "rows.csv")
    names, first, *_ = (tmp_path / "rows.csv").read_text().splitlines()
    assert names.startswith("sources,0,1,") and first.startswith('"0,1,2",0,0,0,')


def test_an_initial_distance_in_a_set_of_the_program_is_of_its_point(mesh: Any, file: Path, tmp_path: Path) -> None:
    (tmp_path / "sets").write_text("7 99+0.5\n99\n")
    solve(file, "--sets", tmp_path / "sets", "--output", tmp_path / "rows.npy")
    rows = mesh.distances([7, 99], initial=[0, 0.5]), mesh.distances(99)
    np.testing.assert_array_equal(np.load(tmp_path / "rows.npy"), rows)


def test_any_sequence_of_points_is_a_set_and_what_has_no_order_is_refused(mesh: Any) -> None:
    expected = mesh.distance_matrix([[0, 1, 2], [7, 8]])
    np.testing.assert_array_equal(mesh.distance_matrix([range(3), range(7, 9)]), expected)
    np.testing.assert_array_equal(mesh.distance_matrix([array("i", [0, 1, 2]), (7, 8)]), expected)
    np.testing.assert_array_equal(mesh.distance_matrix(np.array([[0, 1], [7, 8]]).tolist())[1], expected[1])
    for row, kind in (({7, 8}, "set"), ({7: 8}, "dict"), ((vertex for vertex in (7, 8)), "generator")):
        with pytest.raises(ValueError, match=rf"^rows must be .*, not a {kind}: call list\(\) first$"):
            mesh.distance_matrix([[0, 1, 2], row])


def test_lists_of_three_floats_are_places_and_those_of_integers_are_sets(mesh: Any) -> None:
    places = [[3.25, 4.5, 1], [7, 2, 1]]
    with pytest.warns(UserWarning, match="from the surface"):
        single = mesh.distance_matrix([gb.Place(*place) for place in places])
        np.testing.assert_array_equal(mesh.distance_matrix(places), single)
        of_set = mesh.distance_matrix([np.array(places), 3])
        mixed = mesh.distance_matrix([gb.Place(*places[0]), [0, 1, 2]])
    np.testing.assert_allclose(of_set, [single.min(axis=0), mesh.distances(3)], rtol=1e-12)
    np.testing.assert_array_equal(mixed, [single[0], mesh.distances([0, 1, 2])])
    np.testing.assert_array_equal(mesh.distance_matrix([[0, 1, 2], [7, 8, 9]])[1], mesh.distances([7, 8, 9]))


INTERRUPTED = """
import os, signal, sys, threading, time
sys.path[:0] = {paths!r}
import numpy as np, geodesic_bench as gb
from python_package import rough_ground

mesh = gb.Mesh(*rough_ground(150))
out = np.zeros((2000, 22500))
alone = len(os.listdir("/proc/self/task"))

def interrupt():
    while not out.any(): time.sleep(0.001)
    os.kill(os.getpid(), signal.SIGINT)

threading.Thread(target=interrupt).start()
try:
    mesh.distance_matrix(range(2000), threads=3, out=out)
except KeyboardInterrupt:
    rows = out.any(axis=1).sum()
while len(os.listdir("/proc/self/task")) > alone: time.sleep(0.01)
print(0 < rows < 2000, out.any(axis=1).sum() == rows)
"""


def test_nothing_is_written_to_an_array_after_ctrl_c() -> None:
    script = INTERRUPTED.format(paths=[str(BUILD / "python"), str(HERE)])
    ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=300)
    assert (ended.stdout, ended.stderr) == ("True True\n", "")


def test_an_approximate_matrix_is_that_of_the_solver_that_is_logged(
    mesh: Any, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level(logging.INFO, logger="geodesic_bench")
    few = mesh.distance_matrix(range(4), approximate=True)
    many = mesh.distance_matrix(range(5), approximate=True)
    assert caplog.messages == [
        "distance_matrix of 4 rows: solver edge-based",
        "distance_matrix of 5 rows: solver straight-graph",
    ]
    np.testing.assert_array_equal(few, mesh.distance_matrix(range(4)))
    np.testing.assert_array_equal(many, mesh.distance_matrix(range(5), solver="straight-graph"))


def test_an_approximate_matrix_across_non_manifold_edges_is_exact(ground: Arrays) -> None:
    mesh = gb.Mesh(*ground, cross_non_manifold=True)
    np.testing.assert_array_equal(
        mesh.distance_matrix(range(9), approximate=True), mesh.distance_matrix(range(9))
    )
