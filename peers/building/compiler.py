"""Compiles the plug-in of a peer with CMake, against an installed geodesic-bench."""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from fetching.reporting import FetchError, Unavailable

PEERS = Path(__file__).resolve().parents[1]
MIRROR_VARIABLE = "GEODESIC_PEERS_MIRROR"

# git neither asks for a password nor waits for a connection that stands still.
GIT = {
    "GIT_TERMINAL_PROMPT": "0",
    "GIT_HTTP_LOW_SPEED_LIMIT": "1",  # bytes/s
    "GIT_HTTP_LOW_SPEED_TIME": "30",  # seconds
}


def install_package(build: Path, prefix: Path) -> None:
    """Installs a build folder as a package for plug-ins. Raises FetchError."""
    done = _cmake("--install", build, "--prefix", prefix)
    if done.returncode != 0:
        raise FetchError(f"cannot install {build}: {_first_error(done)}")


@dataclass(frozen=True)
class Compiler:
    package: Path
    """Prefix of the installed geodesic-bench."""
    settings: Sequence[str]
    """NAME=VALUE of CMake, for all peers."""

    def compile(self, peer: Path, folder: Path, **settings: str) -> Path:
        """Returns the plug-in of a peer in its build folder, which is created or updated.

        `settings`: of peer.cmake; those of earlier calls stay. Raises Unavailable with the first error:
        of git, of a missing package, or of the compiler.
        """
        mirror = os.environ.get(MIRROR_VARIABLE)
        if mirror:
            settings["PEER_ORIGIN"] = mirror if "://" in mirror else str(Path(mirror).resolve())
        settings |= {
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_PREFIX_PATH": str(self.package),
            "CMAKE_MODULE_PATH": str(PEERS),
            "FETCHCONTENT_BASE_DIR": str(folder.parent / "sources"),
        }
        given = [f"{name}={value}" for name, value in settings.items()]
        words = [f"-D{each}" for each in (*given, *self.settings)]
        done = _cmake("-S", peer, "-B", folder, "-G", "Ninja", *words)
        configured = done.returncode == 0
        if configured:
            done = _cmake("--build", folder, "--parallel", str(os.cpu_count() or 1))
        log = folder / "build.log"
        log.write_text(done.stdout + done.stderr, "utf-8")
        if done.returncode != 0:
            what = f"does not compile with {flags_of(folder)}: " if configured else ""
            raise Unavailable(f"{what}{_first_error(done)} ({log})")
        return folder / f"lib{peer.name}.so"


def flags_of(folder: Path) -> str:
    """Returns the compiler flags of a configured build folder."""
    cache = (folder / "CMakeCache.txt").read_text("utf-8")
    return "".join(re.findall("^PEER_FLAGS:STRING=(.*)", cache, re.MULTILINE))


def _cmake(*words: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["cmake", *map(str, words)],
        env={**GIT, **os.environ},
        capture_output=True,
        text=True,
        check=False,
    )


def _first_error(done: subprocess.CompletedProcess[str]) -> str:
    lines = [line.strip() for line in (done.stderr + done.stdout).splitlines() if line.strip()]
    for line in lines:
        if line.startswith("fatal: "):  # of git
            return f"cannot fetch its sources: {line[7:]}: check the network or the mirror ({MIRROR_VARIABLE})"
    first = next((at for at, line in enumerate(lines) if "error" in line.lower()), 0)
    if lines and lines[first].endswith(":"):
        first += 1  # CMake prints the message on the next line.
    return "".join(lines[first : first + 1]) or f"exit code {done.returncode}"
