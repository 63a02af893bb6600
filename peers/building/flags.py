"""Which flags a peer is built with: its authors' or ours, the ones that it solves faster with."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from fetching.program import last_line
from fetching.reporting import Unavailable

ROUNDS = 5
SOLVE_SECONDS = 60


@dataclass(frozen=True)
class Bench:
    """The program geodesic-bench, and a mesh to time peers on."""

    program: Path
    mesh: Path

    def solvers(self, *plugins: Path) -> dict[str, bool]:
        """Those of the program, and of plug-ins: whether each runs by its name only. Raises
        Unavailable."""
        done = self._run("list", "--json", *loading(plugins))
        return {each["name"]: each["by_name_only"] for each in json.loads(done.stdout)["solvers"]}

    def solvers_of(self, *plugins: Path) -> list[str]:
        """Names of those that plug-ins bring. Raises Unavailable."""
        own = self.solvers()
        return [solver for solver in self.solvers(*plugins) if solver not in own]

    def make_mesh(self) -> None:
        """A torus of 2,048 vertices: closed, since some codes fail on boundaries.

        Raises Unavailable.
        """
        self._run("generate", "torus", "-o", str(self.mesh))

    def seconds(self, plugin: Path, solver: str) -> float:
        """Of processor time for the first solve of a process. Raises Unavailable when it fails."""
        words = ["solve", str(self.mesh), "--solver", solver, "--source", "0", "--output", "-"]
        said = self._run(*words, *loading([plugin])).stderr
        # With the distances on standard output. A peer may print before the object.
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
    """Words of a command line."""
    return [word for plugin in plugins for word in ("--plugin", str(plugin))]


def faster(
    bench: Bench, plugins: Mapping[str, Path], solver: str, authors: str
) -> tuple[str, str]:
    """The flags of the plug-in that solves faster, and a sentence about them and the others.

    `plugins`: by flags, two, or one where they are the same; `authors`: the flags to take where
    that cannot be measured. Solves alternate, and the least time counts: what a loaded machine adds
    is not the compiler's.
    """
    if len(plugins) == 1:
        return authors, f"its authors' flags, which are ours, {authors}"
    seconds = dict.fromkeys(plugins, float("inf"))
    try:
        for _ in range(ROUNDS):
            for flags, plugin in plugins.items():
                seconds[flags] = min(seconds[flags], bench.seconds(plugin, solver))
    except Unavailable as error:
        return authors, f"its authors' flags, {authors} (not compared with ours: {error})"
    best, other = sorted(seconds, key=lambda flags: seconds[flags])
    gain = seconds[other] / seconds[best] - 1
    whose, others = ("its authors' flags", "ours") if best == authors else ("our flags", "theirs")
    return best, f"{whose}, {best} ({gain:.0%} faster than with {others}, {other})"
