"""The flags for a peer: the flags of its authors or ours, whichever make it solve faster."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

from fetching.program import last_line
from fetching.reporting import Unavailable

ROUNDS = 5
SOLVE_SECONDS = 60


@dataclass(frozen=True)
class Bench:
    """The program geodesic-bench, and a mesh for timing peers."""

    program: Path
    mesh: Path

    def beside_peers(self, oracles: bool) -> list[str]:
        """Returns the solvers of the program that run always and, if asked for, its independent oracles,
        which others wrote as well. Raises Unavailable."""
        return [
            each["name"]
            for each in self._listed()
            if not each["by_name_only"] or (oracles and each["independent_oracle"])
        ]

    def solvers_of(self, *plugins: Path) -> list[str]:
        """Returns the names of the solvers of plug-ins. Raises Unavailable."""
        own = [each["name"] for each in self._listed()]
        return [each["name"] for each in self._listed(*plugins) if each["name"] not in own]

    def _listed(self, *plugins: Path) -> list[dict[str, Any]]:
        listed = json.loads(self._run("list", "--json", *loading(plugins)).stdout)
        return cast(list[dict[str, Any]], listed["solvers"])

    def make_mesh(self) -> None:
        """Generates a torus of 2,048 vertices, a closed mesh because some codes fail on boundaries.

        Raises Unavailable.
        """
        self._run("generate", "torus", "-o", str(self.mesh))

    def seconds(self, plugin: Path, solver: str) -> float:
        """Returns the CPU time of the first solve of a process. Raises Unavailable if it fails."""
        words = ["solve", str(self.mesh), "--solver", solver, "--source", "0", "--output", "-"]
        said = self._run(*words, *loading([plugin])).stderr
        # The distances are on standard output. A peer may print text before the JSON object.
        result = json.loads(said[said.rindex('{\n  "solver"') :])
        return float(result["cpu_time_s"])

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
            raise Unavailable(f"fails on a small mesh: {last_line(done)}")
        return done


def loading(plugins: Iterable[Path]) -> list[str]:
    """Returns the command-line arguments that load plug-ins."""
    return [word for plugin in plugins for word in ("--plugin", str(plugin))]


def faster(bench: Bench, plugins: Mapping[Path, str], solver: str) -> tuple[Path, str]:
    """Returns the plug-in that solves faster, and a sentence about both sets of flags.

    `plugins`: two plug-ins and whose flags they have; the first is returned if the times cannot be
    measured. Solves alternate, and the least time counts, because a loaded machine adds time that does
    not depend on the flags.
    """
    seconds = dict.fromkeys(plugins, float("inf"))
    try:
        for _ in range(ROUNDS):
            for plugin in plugins:
                seconds[plugin] = min(seconds[plugin], bench.seconds(plugin, solver))
    except Unavailable as error:
        first, *_ = plugins
        return first, f"{plugins[first]} (speed not compared: {error})"
    best, other = sorted(seconds, key=lambda plugin: seconds[plugin])
    gain = seconds[other] / seconds[best] - 1
    return best, f"{plugins[best]} ({gain:.0%} faster than with {plugins[other]})"
