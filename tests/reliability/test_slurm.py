"""examples/slurm.sh: a run in two tasks, of which one is interrupted and started again, equals the whole run."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest
from shards import Sharded, differences

from results.reader import read_run

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "examples" / "slurm.sh"
LIMIT = 450 * 2**20
"""Nine tenths of the memory of a task, 500 MB."""


@pytest.fixture
def sharded(bench: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Sharded:
    monkeypatch.setenv("PATH", f"{bench.parent}:{os.environ['PATH']}")
    return Sharded(bench, tmp_path)


def words_of(sharded: Sharded, min_time: str = "0.0001") -> list[str]:
    """Returns the options of a run with an external solver."""
    words = sharded.words("--recordings", "none", min_time=min_time)
    words[words.index("--solvers") + 1] = "edge-based,mine"
    solve = f"{sharded.bench} solve {{mesh}} --source {{sources}} --output {{distances}}"
    return [*words, "--external", f"mine={solve}"]


def task(
    sharded: Sharded, number: int, *words: str, **variables: str | None
) -> subprocess.Popen[str]:
    """Starts a task of the batch script with the variables of Slurm. None removes one."""
    slurm = {"SLURM_ARRAY_TASK_ID": str(number), "SLURM_ARRAY_TASK_COUNT": "2", "SLURM_MEM_PER_NODE": "500"}
    every = os.environ | slurm | variables
    return subprocess.Popen(
        [SCRIPT, *words], cwd=sharded.folder, text=True, stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE, env={key: value for key, value in every.items() if value is not None},
    )  # fmt: skip


def check_merged(sharded: Sharded, words: list[str]) -> None:
    """Compares the merged shards with an undivided run."""
    assert sharded.bench_says("run", *words, "--out", "undivided").returncode == 0
    merged = sharded.merge("a run/shards", "--out", "a run/whole")
    assert merged.returncode == 0, merged.stderr
    assert differences(sharded.folder / "undivided", sharded.folder / "a run" / "whole") == []
    for number in "12":
        shard = read_run(sharded.folder / "a run" / "shards" / number)
        assert shard.ours["memory_limit"] == LIMIT


def test_a_task_that_was_interrupted_goes_on_and_the_merged_run_is_the_undivided_one(
    sharded: Sharded,
) -> None:
    words = words_of(sharded)
    first = task(sharded, 1, *words, "--out", "a run")
    deadline = time.monotonic() + 60
    while not list(sharded.folder.glob("a run/shards/1/cells/*.json")):
        assert first.poll() is None and time.monotonic() < deadline
        time.sleep(0.01)
    first.send_signal(signal.SIGTERM)
    assert first.wait() == 128 + signal.SIGTERM
    for number in (1, 2):
        said = task(sharded, number, "--out=a run", *words)
        assert (" cells are kept from " in said.communicate()[1]) == (number == 1)
        assert said.returncode == 0
    check_merged(sharded, words)
    other = task(sharded, 1, "--out", "a run", *words, SLURM_ARRAY_TASK_COUNT="3")
    assert "options/shard/of is 3 and was 2" in other.communicate()[1] and other.returncode == 1


@pytest.mark.parametrize(
    ("words", "variables", "says"),
    [
        (["--corpus", "tiny"], {}, "the folder is missing: --out DIR"),
        (["--out"], {}, "--out needs a folder"),
        (["--out", "x"], {"SLURM_ARRAY_TASK_ID": None}, "submit this with sbatch --array=1-N"),
        (["--out", "x"], {"SLURM_ARRAY_TASK_ID": "3"}, "--shard 3/2: not K/N with K from 1 to N"),
        (["--out", "x", "--memory-limit", "1M"], {}, "a cell needs at least 128 MiB"),
    ],
)
def test_what_is_no_task_is_refused_in_a_line(
    sharded: Sharded, words: list[str], variables: dict[str, str | None], says: str
) -> None:
    refused = task(sharded, 1, *words, **variables)
    said = refused.communicate()[1]
    assert refused.returncode == 1 and says in said and said.count("\n") == 1, said
    assert not (sharded.folder / "x").exists()


@pytest.mark.nightly
@pytest.mark.skipif(not shutil.which("slurmctld") or not shutil.which("slurmd") or os.geteuid() != 0,
                    reason="needs root, and the packages slurmctld and slurmd")  # fmt: skip
def test_a_task_that_slurm_queues_again_goes_on(sharded: Sharded) -> None:
    words = words_of(sharded, min_time="0.05")
    ended = subprocess.run(
        [Path(__file__).with_name("slurm.sh"), "--out", "a run", *words],
        cwd=sharded.folder, capture_output=True, text=True,
    )  # fmt: skip
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert ended.stdout.count(" cells are kept from ") == 1, ended.stdout
    assert ended.stdout.count("\n[1/") == 2, f"the log of the first start is kept: {ended.stdout}"
    check_merged(sharded, words)
