"""Builds the programs of both revisions, each from its own git work tree.

The tree of a base is kept under build/gate/trees/<hash>. The build folder has the same relative path
in every tree, so that a compiler cache finds equal commands.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from gate.findings import GateError

BUILD = Path("build") / "gate" / "build"
OPTIONS = ["-DGEODESIC_TESTS=OFF", "-DGEODESIC_BENCHMARKS=OFF", "-DGEODESIC_UNITY=ON"]
KEPT = 3
"""Number of trees of revisions that are kept, the newest first."""


@dataclass(frozen=True)
class Tree:
    """The files of a revision."""

    name: str
    """Name of the side: "base" or "head"."""
    label: str
    """The revision as given, and its hash."""
    folder: Path
    done: Path | None
    """File with the CMake options of the finished build; None for a tree that may change."""

    @property
    def program(self) -> Path:
        return self.folder / BUILD / "geodesic-bench"


def tree_of(root: Path, name: str, revision: str | None) -> Tree:
    """Returns the tree of a revision, checked out if necessary. None stands for the checkout itself."""
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
    """Returns the output of a git command, or None if it fails."""
    ended = subprocess.run(["git", "-C", str(root), *words], capture_output=True, text=True)
    return ended.stdout.strip() if ended.returncode == 0 else None


def _make_room(root: Path, trees: Path) -> None:
    kept = sorted(trees.glob("*"), key=lambda tree: tree.stat().st_mtime, reverse=True)
    for tree in kept[KEPT - 1 :]:
        shutil.rmtree(tree, ignore_errors=True)
    _git(root, "worktree", "prune")


def build(trees: list[Tree], named: Sequence[str], logs: Path) -> None:
    """Builds the trees with the solvers that are judged, one after the other. The second build finds
    the objects that both trees share in the compiler cache.

    @raises GateError when a revision does not build"""
    for tree in {tree.folder: tree for tree in trees}.values():
        _build(tree, options_for(tree.folder, named), logs / f"{tree.name}-build.log")


def options_for(tree: Path, named: Sequence[str]) -> list[str]:
    """Returns the options of CMake. A folder under solvers/variants/ is built only if `named` has its
    solver, which is the name of the folder with hyphens."""
    folders = [file.parent.name for file in tree.glob("solvers/*/CMakeLists.txt")]
    variants = [file.parent.name for file in tree.glob("solvers/variants/*/CMakeLists.txt")]
    folders += [folder for folder in variants if folder.replace("_", "-") in named]
    return [*OPTIONS, f"-DGEODESIC_SOLVERS={';'.join(sorted(folders))}"]


def _build(tree: Tree, options: list[str], log: Path) -> None:
    built_with = "\n".join(options)
    if tree.done is not None and tree.done.exists() and tree.program.exists():
        if tree.done.read_text(encoding="utf-8") == built_with:
            return
    log.parent.mkdir(parents=True, exist_ok=True)
    configure = ["cmake", "--preset", "release", "-B", str(BUILD), *options]
    if shutil.which("ccache"):
        configure.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    jobs = str(os.cpu_count() or 1)
    compile_and_link = ["cmake", "--build", str(BUILD), "--parallel", jobs, "-t", "geodesic-bench"]
    environment = dict(os.environ, CCACHE_BASEDIR=str(tree.folder), CCACHE_NOHASHDIR="1")
    with log.open("wb") as out:
        def done(words: list[str]) -> bool:
            ended = subprocess.run(words, cwd=tree.folder, stdout=out, stderr=out, env=environment)
            return ended.returncode == 0

        built = done(configure) and done(compile_and_link)
    if not built or not tree.program.exists():
        lines = log.read_text(errors="replace").strip().splitlines()
        errors = [line for line in lines if "error" in line.lower()] or lines or ["no output"]
        raise GateError(
            f"the {tree.name}, {tree.label}, does not build: {errors[0].strip()} (all of it: {log})"
        )
    if tree.done is not None:
        tree.done.write_text(built_with, encoding="utf-8")
