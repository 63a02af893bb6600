"""A matrix of distances: where it is written, and the solver that is chosen for it."""

from __future__ import annotations

import logging
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import BUILD, HERE, Arrays

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
