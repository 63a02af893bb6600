"""Both revisions as programs, each built from a work tree of its own.

A base that was built once is kept under build/gate/trees/<hash>. The build folder lies at the same
place in every tree, so that a compiler cache sees equal commands.
"""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from .errors import GateError

BUILD = Path("build") / "gate" / "build"
OPTIONS = ["-DGEODESIC_TESTS=OFF", "-DGEODESIC_BENCHMARKS=OFF"]
KEPT = 3
"""Trees of earlier revisions that stay."""


@dataclass(frozen=True)
class Tree:
    """A revision's files."""

    name: str
    """Of the side: "base" or "head"."""
    label: str
    """What was asked for, and its hash."""
    folder: Path
    done: Path | None
    """A file that says that this revision is built already; none for a tree that may change."""

    @property
    def program(self) -> Path:
        return self.folder / BUILD / "geodesic-bench"


def tree_of(root: Path, name: str, revision: str | None) -> Tree:
    """The tree of a revision, checked out if need be; of the checkout itself for None."""
    if revision is None:
        return Tree(name, "working tree", root, None)
    commit = _git(root, "rev-parse", "--verify", "--quiet", "--end-of-options",
                  f"{revision}^{{commit}}")  # fmt: skip
    if commit is None:
        raise GateError(
            f"no revision '{revision}' in this repository: fetch it first"
            " (a shallow clone has no base: git fetch --unshallow)"
        )
    trees = root / "build" / "gate" / "trees"
    folder = trees / commit
    if not (folder / "CMakeLists.txt").exists():
        _make_room(root, trees)
        shutil.rmtree(folder, ignore_errors=True)
        if _git(root, "worktree", "add", "--force", "--detach", str(folder), commit) is None:
            raise GateError(f"git cannot make a work tree of {revision} in {folder}")
    os.utime(folder)  # the newest are kept
    return Tree(name, f"{revision} ({commit[:10]})", folder, folder / BUILD / "built")


def _git(root: Path, *words: str) -> str | None:
    """What it prints; None when it fails."""
    ended = subprocess.run(["git", "-C", str(root), *words], capture_output=True, text=True)
    return ended.stdout.strip() if ended.returncode == 0 else None


def _make_room(root: Path, trees: Path) -> None:
    kept = sorted(trees.glob("*"), key=lambda tree: tree.stat().st_mtime, reverse=True)
    for tree in kept[KEPT - 1 :]:
        shutil.rmtree(tree, ignore_errors=True)
    _git(root, "worktree", "prune")


class Building:
    """A build that goes on in the background."""

    def __init__(self, tree: Tree, jobs: int, log: Path) -> None:
        self._tree, self._log = tree, log
        self._process: subprocess.Popen[bytes] | None = None
        if tree.done is not None and tree.done.exists() and tree.program.exists():
            return
        log.parent.mkdir(parents=True, exist_ok=True)
        configure = ["cmake", "--preset", "release", "-B", str(BUILD), *OPTIONS]
        if shutil.which("ccache"):
            configure.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
        build = ["cmake", "--build", str(BUILD), "--parallel", str(jobs), "-t", "geodesic-bench"]
        environment = dict(os.environ, CCACHE_BASEDIR=str(tree.folder), CCACHE_NOHASHDIR="1")
        with log.open("wb") as out:
            self._process = subprocess.Popen(
                ["sh", "-c", f"{shlex.join(configure)} && exec {shlex.join(build)}"],
                cwd=tree.folder, stdout=out, stderr=out, env=environment,
            )  # fmt: skip

    def wait(self) -> None:
        """@raises GateError when the revision does not build"""
        if self._process is None:
            return
        if self._process.wait() != 0 or not self._tree.program.exists():
            lines = self._log.read_text(errors="replace").strip().splitlines()
            errors = [line for line in lines if "error" in line.lower()] or lines or ["no output"]
            raise GateError(
                f"the {self._tree.name}, {self._tree.label}, does not build: {errors[0].strip()}"
                f" (all of it: {self._log})"
            )
        if self._tree.done is not None:
            self._tree.done.touch()


def build(trees: list[Tree], logs: Path) -> None:
    """Builds all at once; the processors are shared between them."""
    different = list({tree.folder: tree for tree in trees}.values())
    jobs = max(1, (os.cpu_count() or 1) // len(different))
    buildings = [Building(tree, jobs, logs / f"{tree.name}-build.log") for tree in different]
    for building in buildings:
        building.wait()
