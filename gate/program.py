"""Calls a built geodesic-bench to list solvers, verify, count and measure.

Calls of a base use only commands that exist in every revision since the gate was added.
"""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from results.pairs import Pairs, interleaved
from results.reader import Cell, ResultError, Run, read_file

from gate.findings import GateError
from gate.measured import Measured, measured

MIN_SECONDS = 0.05
"""Least total duration in seconds of the solves that one time is taken from, in each process."""
SOLVE = "geodesic::Solver::solve(*"
"""The function in which callgrind counts: every solve of any solver."""


class NotCountableError(GateError):
    """Callgrind cannot run the program on this machine."""


@dataclass(frozen=True)
class Verified:
    """The results of a run that verifies and counts."""

    run: Run | None = None
    """None where there was nothing to run."""
    cells: dict[Cell, Measured] = field(default_factory=dict)

    @property
    def context(self) -> dict[str, Any]:
        """context.geodesic_bench of the result file; empty where there is none."""
        return self.run.ours if self.run else {}


@dataclass(frozen=True)
class Program:
    name: str
    """Name of the side: "base" or "head"."""
    label: str
    """Text that names the revision."""
    path: Path
    cache: Path
    """Folder of meshes."""
    manifest: Path

    def solvers(self, named: Collection[str] = ()) -> list[str]:
        """Returns the names of the solvers to judge. Independent oracles only verify and are left out.

        Variants, examples and solvers with parameters are included only when they are named.
        """
        listed = json.loads(self._call(["list", "--json"]))
        ours = {s["name"]: s for s in listed["solvers"] if not s["independent_oracle"]}
        return [
            name for name, s in ours.items() if name in named or not s.get("by_name_only", False)
        ] + [name for name in named if "?" in name and name.split("?")[0] in ours]

    def verify(self, chosen: Sequence[str], out: Path) -> Verified:
        """Runs, verifies and counts every cell once. The run is written into the folder `out`.

        @param chosen options of `run` that name the meshes and solvers"""
        run = self._run([*chosen, "--repetitions", "1", "--min-time", "0.000001"], out)
        return Verified(run, measured(run))

    def measure_pairs(
        self, base: Program, chosen: Sequence[str], cells: Sequence[Cell], pairs: int, out: Path
    ) -> dict[Cell, Pairs]:
        """Times this program and a base in pairs, by `run --program` of this program into the folder `out`.

        @param chosen options of `run` that name the meshes and solvers of the cells
        @raises GateError when one of the programs fails on a cell"""
        options = ["--repetitions", str(pairs), "--min-time", str(MIN_SECONDS)]
        options += ["--recordings", "none", "--cells", ",".join(map(str, cells))]
        options += ["--program", f"base={base.path}", "--program", f"head={self.path}"]
        run = self._run([*chosen, *options], out)
        old, new = (measured(run, program) for program in ("base", "head"))
        for side in (old, new):
            for one in side.values():
                if one.failure is not None:
                    program = one.failure.program
                    raise GateError(f"{one.cell}: the {program} failed when timed: {one.state}")
        return {cell: interleaved(old[cell].rows, new[cell].rows) for cell in cells}

    def instructions(self, cell: Cell) -> int:
        """Returns the number of instructions inside one solve. @raises NotCountableError, GateError"""
        words = ["solve", cell.mesh, "--solver", cell.solver, "--each", "--source"]
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "callgrind.out"
            callgrind = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}"]
            callgrind += [f"--toggle-collect={SOLVE}"]
            self._call([*words, str(cell.source)], before=callgrind)
            lines = out.read_text(encoding="utf-8").splitlines()
        counted = sum(int(line.split()[1]) for line in lines if line.startswith("totals:"))
        if counted == 0:
            raise GateError(f"callgrind counted nothing in {self.path}: is {SOLVE} still there?")
        return counted

    def _run(self, options: Sequence[str], out: Path) -> Run:
        words = ["run", *options, "--sources", "1", "--out", str(out)]
        # A run with wrong or failed cells has an exit code of its own and a complete run.json.
        self._call(words, may_fail=(out / "run.json").exists)
        try:
            return read_file(out / "run.json", of_any_revision=True)
        except ResultError as error:
            raise GateError(str(error)) from None

    def _call(
        self, words: list[str], before: Sequence[str] = (), may_fail: Callable[[], bool] = bool
    ) -> str:
        command = [*before, str(self.path), *words, "--manifest", str(self.manifest)]
        environment = dict(os.environ, GEODESIC_DATASETS=str(self.cache))
        try:
            ended = subprocess.run(command, capture_output=True, text=True, env=environment)
        except OSError as error:
            raise GateError(f"cannot start {command[0]}: {error.strerror}") from None
        if before and "Unrecognised instruction" in ended.stderr:
            raise NotCountableError("valgrind lacks an instruction that the program executes here")
        if ended.returncode != 0 and not may_fail():
            last = (ended.stderr.strip().splitlines() or ["it printed no error"])[-1]
            raise GateError(f"`{words[0]}` of the {self.name} failed: {last}")
        return ended.stdout
