"""Matrices in files: larger than memory, and continued after an interruption."""

from __future__ import annotations

import fcntl
import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import BUILD, HERE, rough_ground

gb = pytest.importorskip("geodesic_bench")

SLOW = """
import sys
sys.path[:0] = {paths!r}
import geodesic_bench as gb
from python_package import rough_ground

mesh = gb.Mesh(*rough_ground(40))
mesh.distance_matrix(range({rows}), solver="mmp", threads=1, out="m.npy", dtype="float32")
"""
ROWS = 400
"""Some blocks of rows, so that a signal comes between the first and the last: about 2 s."""


@pytest.mark.parametrize("dtype", ["float64", "float32"])
def test_a_file_has_the_numbers_of_the_matrix(mesh: Any, dtype: str, tmp_path: Path) -> None:
    rows, columns = [5, 0, (3, (0.2, 0.3, 0.5))], [9, (4, (0.5, 0.5, 0))]
    for threads in (1, 3):
        got = mesh.distance_matrix(rows, columns, out=tmp_path / "m.npy", dtype=dtype, threads=threads)
        assert isinstance(got, np.memmap) and got.dtype == dtype and not got.flags.writeable
        expected = mesh.distance_matrix(rows, columns, dtype=dtype)
        np.testing.assert_array_equal(got, expected)
        np.testing.assert_array_equal(np.load(tmp_path / "m.npy"), expected)
    assert os.listdir(tmp_path) == ["m.npy"]


def test_rows_are_all_vertices_by_default(mesh: Any, tmp_path: Path) -> None:
    got = mesh.prepare().distance_matrix(out=str(tmp_path / "m.npy"))
    expected = mesh.prepare().distance_matrix()
    assert got.shape == (144, 144)
    np.testing.assert_array_equal(got, expected)


def begun(folder: Path, stop: signal.Signals) -> None:
    """Ends a matrix by a signal after its first rows."""
    script = SLOW.format(paths=[str(BUILD / "python"), str(HERE)], rows=ROWS)
    running = subprocess.Popen([sys.executable, "-c", script], cwd=folder, stderr=subprocess.DEVNULL)
    part = folder / "m.npy.unfinished"
    while running.poll() is None and not (part.exists() and finished_rows(part) > 0):
        time.sleep(0.01)
    assert running.poll() is None
    running.send_signal(stop)
    running.wait(timeout=60)


def finished_rows(part: Path) -> int:
    record = part.read_bytes()[-20:]
    return int(record) if record.isdigit() else 0  # not before the disk space is reserved


@pytest.fixture(scope="module")
def whole() -> Any:
    """The matrix of SLOW, made in one piece."""
    return gb.Mesh(*rough_ground(40)).distance_matrix(range(ROWS), solver="mmp", dtype="float32")


@pytest.mark.parametrize("stop", [signal.SIGINT, signal.SIGKILL])
def test_an_interrupted_file_is_continued_by_the_same_call(stop: signal.Signals, whole: Any, tmp_path: Path) -> None:
    begun(tmp_path, stop)
    part = tmp_path / "m.npy.unfinished"
    assert not (tmp_path / "m.npy").exists() and 0 < finished_rows(part) < ROWS
    mesh = gb.Mesh(*rough_ground(40))
    asked: dict[str, Any] = {"rows": range(ROWS), "solver": "mmp", "dtype": "float32"}
    before = part.read_bytes()
    for other in ({**asked, "rows": [0, 1]}, {**asked, "solver": "edge-based"}, {**asked, "dtype": "float64"}):
        with pytest.raises(ValueError, match="has the rows of another matrix: remove it, or give another name"):
            mesh.distance_matrix(out=tmp_path / "m.npy", **other)
    assert part.read_bytes() == before
    marked = np.load(part, mmap_mode="r+")
    marked[0] = -1  # shows that finished rows are kept
    del marked
    got = mesh.distance_matrix(out=tmp_path / "m.npy", threads=2, **asked)
    assert (got[0] == -1).all()
    np.testing.assert_array_equal(got[1:], whole[1:])
    assert os.listdir(tmp_path) == ["m.npy"]


def test_files_that_cannot_be_written_are_refused(mesh: Any, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"m\.csv: a matrix is written as \.npy"):
        mesh.distance_matrix([0], out=tmp_path / "m.csv")
    with pytest.raises(FileNotFoundError):
        mesh.distance_matrix([0], out=tmp_path / "nowhere" / "m.npy")
    with pytest.raises(ValueError, match="leave out either out or limit"):
        mesh.distance_matrix([0], out=tmp_path / "m.npy", limit=1)
    (tmp_path / "m.npy.unfinished").write_bytes(b"something")
    with pytest.raises(ValueError, match="has the rows of another matrix"):
        mesh.distance_matrix([0], out=tmp_path / "m.npy")
    with open(tmp_path / "m.npy.unfinished", "rb") as other:
        fcntl.flock(other, fcntl.LOCK_EX)
        with pytest.raises(ValueError, match="is in use by another process"):
            mesh.distance_matrix([0], out=tmp_path / "m.npy")
    assert (tmp_path / "m.npy.unfinished").read_bytes() == b"something"


def test_a_file_without_room_is_refused_and_leaves_nothing(mesh: Any, tmp_path: Path) -> None:
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (10_000, limits[1]))
    try:
        with pytest.raises(OSError, match="no room for a matrix of 144 rows and 144 columns in float64"):
            mesh.distance_matrix(out=tmp_path / "m.npy")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert os.listdir(tmp_path) == []
