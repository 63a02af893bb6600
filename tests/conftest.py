"""Fixtures of all tests; also resets a signal handler that tests must not inherit from the shell."""

from __future__ import annotations

import json
import os
import signal
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from results.reader import Run

GOLDEN = Path(__file__).resolve().parent / "plots" / "golden"

# Commands that a shell starts with `&` ignore Ctrl-C, and their child processes inherit this.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def bench() -> Path:
    """The program under test."""
    program = os.environ.get("GEODESIC_BENCH")
    if program is None:
        pytest.skip("GEODESIC_BENCH names no program; ./run_tests.sh sets it")
    return Path(program).resolve()


@pytest.fixture
def golden_folder() -> Path:
    return GOLDEN / "run"


@pytest.fixture
def golden_run(golden_folder: Path) -> Run:
    from results.reader import read_run  # here, since tests of other folders need no numpy

    return read_run(golden_folder)


@pytest.fixture
def changed(golden_folder: Path, tmp_path: Path) -> Callable[[Callable[[dict[str, Any]], object]], Path]:
    """changed(f) calls f on a copy of the golden run and returns the folder of the copy."""

    def make(change: Callable[[dict[str, Any]], object]) -> Path:
        data = json.loads((golden_folder / "run.json").read_text())
        change(data)
        (tmp_path / "run.json").write_text(json.dumps(data))
        return tmp_path

    return make


@pytest.fixture
def stored(golden_folder: Path, tmp_path: Path) -> Path:
    """The golden run with its rows as columns. The names of its rows are those of geodesic-bench."""
    from results import merge
    from results.columns import Columns

    data = json.loads((golden_folder / "run.json").read_text())
    return merge.write(data["context"], Columns.of(data["benchmarks"]), tmp_path, 0).parent


@pytest.fixture(scope="session")
def real_run(bench: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run of the built program on one small generated mesh."""
    folder = tmp_path_factory.mktemp("real run")
    mesh = folder / "square.off"

    def call(*arguments: str | Path) -> None:
        subprocess.run([bench, *arguments], check=True, capture_output=True, timeout=300)

    call("generate", "grid", "--columns", "7", "--rows", "7", "-o", mesh)
    call(
        "run", "--meshes", mesh, "--repetitions", "2", "--sources", "1", "--min-time", "0.001",
        "--recordings", "all", "--out", folder / "run",
    )  # fmt: skip
    return folder / "run"
