"""Builds the plug-in of a peer, unless it is up to date."""

from __future__ import annotations

import hashlib
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from fetching.reporting import Unavailable

from .compiler import Compiler
from .description import PEERS, Peer
from .flags import Bench, faster
from .sources import Sources


@dataclass(frozen=True)
class Builder:
    folder: Path
    """Folder of all builds, with one subfolder per peer."""
    sources: Sources
    compiler: Compiler
    bench: Bench

    def plugin(self, peer: Peer) -> Path:
        return self.folder / peer.name / f"lib{peer.name}.so"

    def build(self, peer: Peer) -> str | None:
        """Builds a plug-in. Returns a sentence about its flags, or None if it is up to date. Raises Unavailable."""
        stamp = self._stamp(peer)
        noted = self.plugin(peer).with_suffix(".stamp")
        if self.plugin(peer).is_file() and noted.is_file() and noted.read_text() == stamp:
            return None
        noted.unlink(missing_ok=True)
        self.plugin(peer).unlink(missing_ok=True)
        check_packages(peer.packages)
        authors = self.folder / peer.name / "sources"
        self.sources.prepare(peer, authors)
        said = self._compile(peer, authors)
        noted.write_text(stamp)
        return said

    def _compile(self, peer: Peer, authors: Path) -> str:
        folder = self.folder / peer.name
        names = {peer.authors_flags: "authors", peer.our_flags: "ours"}
        compiled = {
            flags: self.compiler.compile(peer, authors, folder / name, flags)
            for flags, name in names.items()
        }
        solver = self.bench.solvers_of(compiled[peer.our_flags])[0]
        best, said = faster(self.bench, compiled, solver, peer.authors_flags)
        chosen = self.compiler.compile(peer, authors, compiled[best].parent, best, said)
        chosen.replace(self.plugin(peer))
        return said

    def _stamp(self, peer: Peer) -> str:
        """Returns a hash of everything that the plug-in depends on."""
        contract = self.compiler.package / "include" / "geodesic-bench" / "solvers" / "core"
        shared = [*PEERS.glob("*.h"), PEERS / "peer.cmake"]
        files = [*peer.folder.rglob("*"), *shared, *contract.glob("*.h")]
        compiler = subprocess.run(["c++", "--version"], capture_output=True, check=False).stdout
        sums = hashlib.sha256(compiler)
        for file in sorted(file for file in files if file.is_file()):
            sums.update(str(file).encode() + file.read_bytes())
        return sums.hexdigest()


def check_packages(packages: Iterable[str]) -> None:
    """Raises Unavailable if a Debian package is missing. On other systems CMake reports it."""
    missing = [package for package in packages if not _is_installed(package)]
    if missing:
        words = " ".join(missing)
        raise Unavailable(f"needs {words}: apt-get install --no-install-recommends {words}")


def _is_installed(package: str) -> bool:
    query = ["dpkg-query", "-W", "-f", "${db:Status-Status}", package]
    try:
        done = subprocess.run(query, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return True
    return done.stdout == "installed"
