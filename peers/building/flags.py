"""Which flags a peer is built with: its authors' or ours, the ones that it solves faster with."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from fetching.reporting import Unavailable

ROUNDS = 5
SOLVE_SECONDS = 60


@dataclass(frozen=True)
class Solver:
    name: str
    by_name_only: bool


@dataclass(frozen=True)
class Bench:
    """The program geodesic-bench, and a mesh to time peers on."""

    program: Path
    mesh: Path

    def solvers(self, *plugins: Path) -> list[Solver]:
        """Of the program, and of plug-ins. Raises Unavailable."""
        done = self._run("list", "--json", *loading(plugins))
        listed = json.loads(done.stdout)["solvers"]
        return [Solver(each["name"], each["by_name_only"]) for each in listed]

    def solvers_of(self, *plugins: Path) -> list[str]:
        """Names of those that plug-ins bring. Raises Unavailable."""
        own = self.solvers()
        return [solver.name for solver in self.solvers(*plugins) if solver not in own]

    def make_mesh(self) -> None:
        """A terrain of 3,249 vertices. Raises Unavailable."""
        self._run("generate", "terrain", "-o", str(self.mesh))

    def seconds(self, plugin: Path, solver: str) -> float:
        """Of one solve, the first of a process. Raises Unavailable when it fails."""
        words = ["solve", str(self.mesh), "--solver", solver, "--source", "0", "--output", "-"]
        said = self._run(*words, *loading([plugin])).stderr
        # With the distances on standard output. A peer may print before the object.
        result = json.loads(said[said.rindex('{\n  "solver"') :])
        return float(result["real_time_s"])

    def _run(self, *words: str) -> subprocess.CompletedProcess[str]:
        try:
            done = subprocess.run(
                [str(self.program), *words],
                capture_output=True,
                text=True,
                errors="replace",
                timeout=SOLVE_SECONDS,
                check=False,
            )
        except subprocess.TimeoutExpired:
            raise Unavailable(f"takes over {SOLVE_SECONDS} s for a small mesh") from None
        if done.returncode != 0:
            last = (done.stderr.strip().splitlines() or [f"exit code {done.returncode}"])[-1]
            raise Unavailable(f"fails on a small mesh: {last}")
        return done


def loading(plugins: Iterable[Path]) -> list[str]:
    """Words of a command line."""
    return [word for plugin in plugins for word in ("--plugin", str(plugin))]


def median_seconds(bench: Bench, plugins: Mapping[str, Path], solver: str) -> dict[str, float]:
    """By flags, the median of solves that alternate between the plug-ins built with them."""
    seconds: dict[str, list[float]] = {flags: [] for flags in plugins}
    for _ in range(ROUNDS):
        for flags, plugin in plugins.items():
            seconds[flags].append(bench.seconds(plugin, solver))
    return {flags: median(times) for flags, times in seconds.items()}


def remark(seconds: Mapping[str, float], authors: str) -> tuple[str, str]:
    """The faster flags, and a sentence about them and the others."""
    best, other = sorted(seconds, key=lambda flags: seconds[flags])
    gain = seconds[other] / seconds[best] - 1
    whose = "its authors'" if best == authors else "ours"
    others = "ours" if best == authors else "its authors'"
    return best, f"{whose}, {best} ({gain:.0%} faster than with {others}, {other})"
