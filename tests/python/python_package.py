"""Finds the Python package in the build folder, and makes a mesh for its tests."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BENCH = Path(os.environ.get("GEODESIC_BENCH") or ROOT / "build" / "release" / "geodesic-bench")
BUILD = BENCH.resolve().parent

Arrays = tuple[NDArray[np.float64], NDArray[np.int64]]


def find_package() -> None:
    """Makes the package importable if it is a Release build. An interpreter without sanitizers cannot load
    a module with sanitizers: the process ends."""
    cache = BUILD / "CMakeCache.txt"
    if cache.exists() and "CMAKE_BUILD_TYPE:STRING=Release" in cache.read_text():
        sys.path.insert(0, str(BUILD / "python"))


def write_obj(file: Path, vertices: ArrayLike, faces: ArrayLike) -> None:
    """Writes a mesh. Its coordinates are read back as the same bits."""
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in np.asarray(vertices).tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (np.asarray(faces) + 1).tolist()]
    file.write_text("\n".join(lines) + "\n")


def solve(*words: object) -> str:
    """Runs `geodesic-bench solve`, and returns what it prints."""
    command = [str(BENCH), "solve", *map(str, words)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def rough_ground(side: int) -> Arrays:
    """Returns a square of side x side vertices at random heights. It has many saddle vertices."""
    x, y = np.divmod(np.arange(side * side), side)
    height = np.random.default_rng(side).uniform(0, 2, side * side)
    corner = np.arange(side * side).reshape(side, side)[:-1, :-1].reshape(-1, 1)
    lower, upper = corner + [0, side, side + 1], corner + [0, side + 1, 1]
    return np.stack([x, y, height], axis=1), np.concatenate([lower, upper])


def make_source_distribution(folder: Path) -> Path:
    """Makes the source distribution in the folder, from a copy of the sources, because this writes beside them."""
    source = folder / "source"
    unwanted = shutil.ignore_patterns("__pycache__", "runs", "ranks", "baseline", "*.egg-info")
    for name in ("cmake", "geodesic", "meshes", "python", "results", "solvers"):
        shutil.copytree(ROOT / name, source / name, ignore=unwanted)
    for name in ("CITATION.cff", "CMakeLists.txt", "LICENSE", "MANIFEST.in", "README.md",
                 "pyproject.toml", "setup.py"):  # fmt: skip
        shutil.copy(ROOT / name, source)
    make = "import sys; from setuptools.build_meta import build_sdist; build_sdist(sys.argv[1])"
    subprocess.run([sys.executable, "-c", make, folder], cwd=source, check=True, capture_output=True)
    (sdist,) = folder.glob("*.tar.gz")
    return sdist
