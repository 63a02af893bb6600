"""Installs the tree of these tests and builds projects against it."""

from __future__ import annotations

import os
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WARNINGS = "-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Werror"
"""Warning flags for projects outside the tree. The tree has the same ones."""


def cmake(*words: str | Path) -> None:
    ended = subprocess.run(
        ["cmake", *map(str, words)], capture_output=True, text=True, check=False
    )
    assert ended.returncode == 0, ended.stdout + ended.stderr


@dataclass(frozen=True)
class Installed:
    prefix: Path
    built: dict[str, str]
    """The CMake cache of the tree: its compiler, and its flags such as sanitizers."""

    @classmethod
    def from_build(cls, build: Path, prefix: Path) -> Installed:
        entries = r"^([A-Za-z_]+):\w+=(.*)$"
        return cls(prefix, dict(re.findall(entries, (build / "CMakeCache.txt").read_text(), re.M)))

    @property
    def include(self) -> Path:
        return self.prefix / "include" / "geodesic-bench"

    @property
    def program(self) -> Path:
        return self.prefix / "bin" / "geodesic-bench"

    def bench(self, folder: Path, *words: str | Path) -> subprocess.CompletedProcess[str]:
        """Runs the installed program in a folder, without variables of a checkout."""
        environment = {k: v for k, v in os.environ.items() if not k.startswith("GEODESIC_")}
        return subprocess.run(
            [self.program, *words], cwd=folder, env=environment, capture_output=True, text=True,
            check=False,
        )  # fmt: skip

    def build(self, source: Path, build: Path) -> Path:
        """Configures and builds a project that finds the package; returns the build folder."""
        kind = self.built["CMAKE_BUILD_TYPE"]
        flags = f"CMAKE_CXX_FLAGS_{kind.upper()}"
        settings = {
            "CMAKE_PREFIX_PATH": str(self.prefix),
            "CMAKE_BUILD_TYPE": kind,
            "CMAKE_CXX_COMPILER": self.built["CMAKE_CXX_COMPILER"],
            "CMAKE_CXX_COMPILER_LAUNCHER": self.built.get("CMAKE_CXX_COMPILER_LAUNCHER", ""),
            "CMAKE_CXX_FLAGS": f"{self.built['CMAKE_CXX_FLAGS']} {WARNINGS}",
            flags: f"{self.built[flags]} -O1",  # tests do not need a fast build
        }
        cmake("-S", source, "-B", build, "-G", "Ninja", *(f"-D{k}={v}" for k, v in settings.items()))
        cmake("--build", build)
        return build


def install(build: Path, prefix: Path) -> Installed:
    """Installs the build into another prefix and moves that to `prefix`."""
    made = prefix.with_name("made first")
    cmake("--install", build, "--prefix", made)
    made.rename(prefix)
    return Installed.from_build(build, prefix)
