"""A built geodesic-bench as the gate uses it: a process that solves, counts and is timed.

Only commands and options that every revision since the gate has are used, so that any base works.
"""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .errors import GateError

SOLVE = "geodesic::Solver::solve(*"
"""What callgrind counts inside of: every solve, whichever the solver."""


@dataclass(frozen=True, order=True)
class Cell:
    """A solver on a mesh from a source vertex."""

    solver: str
    mesh: str
    source: int

    def __str__(self) -> str:
        return f"{self.solver}/{self.mesh}/src:{self.source}"


@dataclass(frozen=True)
class Row:
    """What one run says of a cell."""

    cell: Cell
    outcome: str
    message: str
    numbers: dict[str, Any]

    @property
    def ok(self) -> bool:
        return self.outcome == "ok"


@dataclass(frozen=True)
class Run:
    context: dict[str, Any]
    """context.geodesic_bench of the result file"""
    rows: dict[Cell, Row]


@dataclass(frozen=True)
class Program:
    name: str
    """Which side it is: "base" or "head"."""
    label: str
    """The revision, as people know it."""
    path: Path
    cache: Path
    """Folder of meshes."""
    manifest: Path

    def solvers(self, asked_for: Collection[str] = ()) -> list[str]:
        """Names, without independent oracles: those verify, and are not ours to make faster.

        Variants and examples are among them only when they are asked for.
        """
        listed = json.loads(self._call(["list", "--json"], self._options()))
        return [
            s["name"] for s in listed["solvers"]
            if not s["independent_oracle"]
            and (s["name"] in asked_for or not s.get("by_name_only", False))
        ]  # fmt: skip

    def run(self, corpus: str, meshes: Sequence[str], solvers: Sequence[str], out: Path) -> Run:
        """Verifies and counts every cell of the corpus, or of the meshes, into a run folder."""
        chosen = ["--meshes", ",".join(meshes)] if meshes else []
        words = ["run", "--corpus", corpus, *chosen, "--solvers", ",".join(solvers), "--sources", "1"]
        words += ["--repetitions", "1", "--min-time", "0.000001", "--out", str(out)]
        # A run with wrong or failed cells ends with an exit code of its own and a whole run.json.
        self._call(words, self._options(), may_fail=(out / "run.json").exists)
        return read_run(out / "run.json")

    def solve_ms(self, cell: Cell, solves: int) -> list[float]:
        """CPU milliseconds of several solves in one process; the first touches fresh memory."""
        solved = json.loads(self._call(self._solve(cell, solves), self._options()))
        return [1e3 * solve["cpu_time_s"] for solve in solved["solves"]]

    def instructions(self, cell: Cell) -> int:
        """Instructions inside of one solve."""
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "callgrind.out"
            callgrind = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}"]
            callgrind += [f"--toggle-collect={SOLVE}"]
            self._call(self._solve(cell, 1), self._options(), before=callgrind)
            lines = out.read_text(encoding="utf-8").splitlines()
        counted = sum(int(line.split()[1]) for line in lines if line.startswith("totals:"))
        if counted == 0:
            raise GateError(
                f"callgrind counted nothing in {self.path}: is {SOLVE} still every solver's entry?"
            )
        return counted

    def _solve(self, cell: Cell, solves: int) -> list[str]:
        source = ["--source", str(cell.source)] * solves
        return ["solve", cell.mesh, "--solver", cell.solver, "--each", *source]

    def _options(self) -> list[str]:
        return ["--manifest", str(self.manifest)]

    def _call(
        self, words: list[str], options: list[str], before: Sequence[str] = (),
        may_fail: Callable[[], bool] = bool,
    ) -> str:
        command = [*before, str(self.path), *words, *options]
        environment = dict(os.environ, GEODESIC_DATASETS=str(self.cache))
        try:
            ended = subprocess.run(command, capture_output=True, text=True, env=environment)
        except OSError as error:
            raise GateError(f"cannot start {command[0]}: {error.strerror}") from None
        if ended.returncode != 0 and not may_fail():
            last = (ended.stderr.strip().splitlines() or ["it printed no error"])[-1]
            raise GateError(f"the {self.name}'s {' '.join(words[:1])} failed: {last}")
        return ended.stdout


def read_run(file: Path) -> Run:
    try:
        data = json.loads(file.read_text(encoding="utf-8"))
        rows = [_row(row) for row in data["benchmarks"] if row.get("repetition_index", 0) == 0]
        return Run(data["context"]["geodesic_bench"], {row.cell: row for row in rows})
    except (OSError, ValueError, KeyError) as error:
        raise GateError(f"{file}: no result file: {error}") from None


def _row(row: dict[str, Any]) -> Row:
    cell = Cell(row["solver"], row["mesh"], int(row["source"]))
    return Row(cell, row["outcome"], row.get("error_message", ""), row)
