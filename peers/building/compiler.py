"""Compiles the plug-in of a peer with CMake, against an installed geodesic-bench."""

from __future__ import annotations

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

from fetching.reporting import FetchError, Unavailable

from .description import PEERS, Peer


def install_package(build: Path, prefix: Path) -> None:
    """Installs a build folder as a package for plug-ins. Raises FetchError."""
    done = _cmake("--install", build, "--prefix", prefix)
    if done.returncode != 0:
        raise FetchError(f"cannot install {build}: {_first_error(done)}")


@dataclass(frozen=True)
class Compiler:
    package: Path
    """Prefix of the installed geodesic-bench."""

    def compile(
        self, peer: Peer, sources: Path, folder: Path, flags: str, remark: str = ""
    ) -> Path:
        """Returns the plug-in in its build folder, which is created or updated.

        `flags`: compiler flags of the optimised build; `remark`: text about them in the plug-in. Raises
        Unavailable with the first error of the compiler.
        """
        settings = {
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_PREFIX_PATH": self.package,
            "CMAKE_MODULE_PATH": PEERS,
            "PEER_SOURCES": sources,
            "PEER_FLAGS": flags,
            "PEER_REMARK": remark or flags,
        }
        words = [f"-D{name}={value}" for name, value in settings.items()]
        done = _cmake("-S", peer.folder, "-B", folder, "-G", "Ninja", *words)
        if done.returncode == 0:
            done = _cmake("--build", folder, "--parallel", str(os.cpu_count() or 1))
        log = folder / "build.log"
        log.write_text(done.stdout + done.stderr, "utf-8")
        if done.returncode != 0:
            raise Unavailable(f"does not compile with {flags}: {_first_error(done)} ({log})")
        return folder / f"lib{peer.name}.so"


def _cmake(*words: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["cmake", *map(str, words)], capture_output=True, text=True, check=False
    )


def _first_error(done: subprocess.CompletedProcess[str]) -> str:
    lines = [line.strip() for line in (done.stdout + done.stderr).splitlines() if line.strip()]
    first = next((at for at, line in enumerate(lines) if "error" in line.lower()), 0)
    # CMake prints the message on the next line.
    shown = 2 if lines and lines[first].endswith(":") else 1
    return " ".join(lines[first : first + shown]) or f"exit code {done.returncode}"
