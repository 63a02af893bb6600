"""A kill loses nothing, and a loss is found."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from killing import Killing, Lost, processes_of


def test_killed_runs_end_as_if_they_had_not_been_killed(bench: Path, tmp_path: Path) -> None:
    killing = Killing(bench, tmp_path, 1)
    killing.until_killed(8)
    assert killing.kills == 8


def test_a_loss_is_found(bench: Path, tmp_path: Path) -> None:
    killing = Killing(bench, tmp_path, 1)
    lost = next(name for name in killing.expected if name.endswith(".npy"))
    killing.expected[lost] += b"x"
    with pytest.raises(Lost, match="differs"):
        killing.until_killed(1)


def test_a_process_that_runs_on_is_found(tmp_path: Path) -> None:
    waits = "print('runs', flush=True); input()"
    with subprocess.Popen(
        [sys.executable, "-c", waits, tmp_path / "mesh"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
    ) as process:
        assert process.stdout is not None
        process.stdout.readline()  # a process that is still being set up shows no command line
        assert processes_of(tmp_path) == [process.pid]
        process.kill()
    assert processes_of(tmp_path) == []
