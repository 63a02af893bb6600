"""Builds the plug-in of a peer, unless it is up to date."""

from __future__ import annotations

import hashlib
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from .compiler import PEERS, Compiler, flags_of
from .flags import Bench, faster

OURS = "-O3 -march=native -DNDEBUG"


@dataclass(frozen=True)
class Builder:
    folder: Path
    """Folder of all builds, with one subfolder per peer."""
    compiler: Compiler
    bench: Bench

    def plugin(self, peer: Path) -> Path:
        return self.folder / peer.name / f"lib{peer.name}.so"

    def build(self, peer: Path) -> str | None:
        """Builds a plug-in. Returns a sentence about its flags, or None if it is up to date. Raises Unavailable."""
        stamp = self._stamp(peer)
        noted = self.plugin(peer).with_suffix(".stamp")
        there = self.plugin(peer).is_file() and noted.is_file() and noted.read_text() == stamp
        if there and not self.compiler.settings:  # which may name a folder whose files change
            return None
        shutil.rmtree(self.folder / peer.name, ignore_errors=True)
        said = self._compile(peer)
        noted.write_text(stamp)
        return said

    def _compile(self, peer: Path) -> str:
        authors, ours = (self.folder / peer.name / whose for whose in ("authors", "ours"))
        compiled = {
            self.compiler.compile(peer, authors): f"its authors' flags, {flags_of(authors)}",
            self.compiler.compile(peer, ours, PEER_FLAGS=OURS): f"our flags, {OURS}",
        }
        solver = self.bench.solvers_of(ours / f"lib{peer.name}.so")[0]
        best, said = faster(self.bench, compiled, solver)
        self.compiler.compile(peer, best.parent, PEER_REMARK=said).replace(self.plugin(peer))
        return said

    def _stamp(self, peer: Path) -> str:
        """Returns a hash of everything that the plug-in depends on."""
        contract = self.compiler.package / "include" / "geodesic-bench" / "solvers" / "core"
        shared = [*PEERS.glob("*.h"), PEERS / "peer.cmake"]
        files = [*peer.rglob("*"), *shared, *contract.glob("*.h")]
        compiler = subprocess.run(["c++", "--version"], capture_output=True, check=False).stdout
        sums = hashlib.sha256(compiler + repr(self.compiler.settings).encode())
        for file in sorted(file for file in files if file.is_file()):
            sums.update(str(file).encode() + file.read_bytes())
        return sums.hexdigest()
