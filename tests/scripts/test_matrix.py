"""`solve --matrix`: its rows equal single solves, NumPy and SciPy read its files, and an interrupted matrix
is continued."""

from __future__ import annotations

import json
import os
import signal
import subprocess
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

BENCH = Path(os.environ.get("GEODESIC_BENCH", "build/release/geodesic-bench")).resolve()


@pytest.fixture(scope="module")
def hill(tmp_path_factory: pytest.TempPathFactory) -> Path:
    if not BENCH.exists():
        pytest.skip(f"no program at {BENCH}")
    file = tmp_path_factory.mktemp("hill") / "hill.obj"
    command: list[str | Path] = [BENCH, "generate", "terrain", "--columns=12", "--rows=9", "-o", file]
    subprocess.run(command, check=True, capture_output=True)
    return file


def solve(mesh: Path, *words: object) -> subprocess.CompletedProcess[str]:
    command = [str(w) for w in (BENCH, "solve", mesh, "--solver", "mmp", *words)]
    return subprocess.run(command, cwd=mesh.parent, capture_output=True, text=True, timeout=300)


def single(mesh: Path, source: str) -> NDArray[np.float64]:
    ended = solve(mesh, "--source", source, "--output", "d.txt")
    assert ended.returncode == 0, ended.stderr
    return np.loadtxt(mesh.parent / "d.txt")


def has_a_row(part: Path) -> bool:
    """Returns whether an unfinished file has a row. Its end is one flag per row and 64 characters of the problem."""
    return part.exists() and any(part.read_bytes()[-64 - 150 : -64])


def test_rows_are_the_bits_of_single_solves_in_any_number_of_threads(hill: Path) -> None:
    sources = ["3", "edge:0-1:0.25", "face:7:0.2,0.3,0.5+1.5"]
    expected = np.stack([single(hill, source) for source in sources])
    for threads in (1, 3):
        ended = solve(hill, "--source", ",".join(sources), "--matrix", "m.npy", "--threads", threads)
        assert ended.returncode == 0, ended.stderr
        assert json.loads(ended.stdout)["rows"] == 3
        np.testing.assert_array_equal(np.load(hill.parent / "m.npy"), expected)
        assert not (hill.parent / "m.npy.unfinished").exists()


def test_columns_are_targets_and_without_points_both_are_all_vertices(hill: Path) -> None:
    assert solve(hill, "--matrix", "all.npy", "--float32").returncode == 0
    every = np.load(hill.parent / "all.npy", mmap_mode="r")
    assert every.dtype == np.float32 and every.shape[0] == every.shape[1]
    np.testing.assert_allclose(every, every.T, rtol=1e-6)
    np.testing.assert_array_equal(every[5], single(hill, "5").astype(np.float32))
    some = ("--source", "5,8", "--target", "40,0,edge:0-1:0", "--matrix", "some.npy")
    assert solve(hill, *some).returncode == 0
    columns = np.load(hill.parent / "some.npy")
    np.testing.assert_array_equal(columns.astype(np.float32), every[[5, 8]][:, [40, 0, 0]])


@pytest.mark.parametrize("precision", [[], ["--float32"]])
def test_a_limit_leaves_infinity_beyond_it(hill: Path, precision: list[str]) -> None:
    words = ("--source", "7,60", "--matrix", "m.npy", "--limit", "0.4", *precision)
    assert solve(hill, *words).returncode == 0
    matrix = np.load(hill.parent / "m.npy")
    whole = np.stack([single(hill, "7"), single(hill, "60")])
    assert 2 < np.isfinite(matrix).sum() < whole.size
    expected = np.where(whole <= 0.4, whole, np.inf).astype(matrix.dtype)
    np.testing.assert_array_equal(matrix, expected)


@pytest.mark.parametrize("words", [["m.npy"], ["m.npy", "--limit", "0.2"]])
def test_an_interrupted_matrix_is_gone_on_with(words: list[str], tmp_path: Path) -> None:
    grid = tmp_path / "grid.obj"  # takes seconds, so that the signal comes before the end
    command: list[str | Path] = [BENCH, "generate", "terrain", "--columns=40", "--rows=40", "-o", grid]
    subprocess.run(command, check=True, capture_output=True)
    sources = ",".join(map(str, range(150)))
    asked = ("--source", sources, "--matrix", *words)
    part = tmp_path / f"{words[0]}.unfinished"
    running = subprocess.Popen([BENCH, "solve", grid, "--solver", "mmp", *asked], cwd=tmp_path,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)  # fmt: skip
    while running.poll() is None and not has_a_row(part):
        pass
    running.send_signal(signal.SIGINT)
    said = running.communicate(timeout=300)[1]
    assert running.returncode == 130 and "--resume goes on" in said
    assert not (tmp_path / words[0]).exists()

    refused = solve(grid, *asked)
    assert refused.returncode == 1 and "continue it with --resume" in refused.stderr
    other = solve(grid, "--source", "1,2", "--matrix", *words, "--resume")
    assert other.returncode == 1 and "is of another problem" in other.stderr
    assert solve(grid, *asked, "--resume").returncode == 0
    interrupted = (tmp_path / words[0]).read_bytes()
    assert solve(grid, *asked).returncode == 0
    assert (tmp_path / words[0]).read_bytes() == interrupted
