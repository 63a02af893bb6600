"""Measures a small run as a whole and in shards, and compares the rows of both."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

from killing import VARYING, two_meshes

from results.reader import Run, read_run

Ended = subprocess.CompletedProcess[str]
FOLLOW_FROM_TIMES = {*VARYING, "phase_seconds", "processor"}


class Sharded:
    def __init__(self, bench: Path, folder: Path) -> None:
        self.bench, self.folder = bench, folder
        self.meshes = two_meshes(bench, folder)

    def words(self, *more: str, min_time: str = "0.0001") -> list[str]:
        return ["--meshes", self.meshes, "--solvers", "edge-based,ich,dijkstra", "--sources", "3",
                "--source-sets", "random:4,boundary",  # a box has no boundary
                "--repetitions", "2", "--min-time", min_time, *more]  # fmt: skip

    def bench_says(self, *words: object) -> Ended:
        command = [str(self.bench), *map(str, words)]
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True)

    def run(self, *more: str) -> Ended:
        return self.bench_says("run", *self.words(*more))

    def shards(self, of: int, *more: str) -> Path:
        """Runs all shards. Returns the folder that contains them as "1", "2", ..."""
        for index in range(1, of + 1):
            ended = self.run("--shard", f"{index}/{of}", "--out", f"shards/{index}", *more)
            assert ended.returncode == 0, ended.stderr
        return self.folder / "shards"

    def merge(self, *words: object) -> Ended:
        return self.bench_says("merge", *words)


def without_times(run: Run) -> list[dict[str, Any]]:
    return [
        {key: value for key, value in row.data.items() if key not in FOLLOW_FROM_TIMES}
        for row in run.rows
    ]


def differences(whole: Path, merged: Path) -> list[str]:
    """Returns the differences of two run folders, in rows and context, without times."""
    first, second = read_run(whole), read_run(merged)
    found = [
        f"{a} / {b}"
        for a, b in zip(without_times(first), without_times(second), strict=True)
        if a != b
    ]
    of_run = {"started", "finished", "checksum", "command", "parts", "memory_limit", "processor",
              "environments"}  # fmt: skip
    keys = (first.ours.keys() | second.ours.keys()) - of_run
    return found + [key for key in keys if first.ours.get(key) != second.ours.get(key)]
