"""Small manifests, mirrors and a stand-in for geodesic-bench, in a folder of the test's own."""

from __future__ import annotations

import hashlib
import json
import os
import stat
import zipfile
from pathlib import Path
from typing import Any

import fetch

TRIANGLE = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"

# Writes its parameters as the mesh, so that tests see what it was asked for.
FAKE_BENCH = """#!/bin/sh
for last; do :; done
echo called >> "$(dirname "$0")/calls"
[ "$2" = broken ] && { echo "geodesic-bench: no such thing" >&2; exit 1; }
echo "$2 $3" > "$last"
"""


def sha256(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def downloaded(name: str, path: str, data: bytes, **more: Any) -> dict[str, Any]:
    return {
        "name": name,
        "kind": "downloaded",
        "path": path,
        "sha256": sha256(data),
        "file": f"{name}.obj",
        "vertices": 3,
        "faces": 1,
        "licence": "none",
        "credit": "nobody",
        "tags": [],
        "why": "test",
        **more,
    }


def generated(name: str, generator: str = "grid", size: int = 4) -> dict[str, Any]:
    return {
        "name": name,
        "kind": "generated",
        "generator": generator,
        "parameters": {"size": size},
        "file": f"{name}.ply",
        "sha256": sha256(f"{generator} --size={size}\n".encode()),
        "vertices": 3,
        "faces": 1,
        "tags": [],
        "why": "test",
    }


class World:
    """A manifest, a mirror, a program and a cache."""

    def __init__(self, folder: Path) -> None:
        self.manifest = folder / "manifest.json"
        self.mirror = folder / "mirror"
        self.cache = folder / "a cache"
        self.bench = folder / "geodesic-bench"
        self.bench.write_text(FAKE_BENCH)
        self.bench.chmod(self.bench.stat().st_mode | stat.S_IXUSR)
        self.meshes: list[dict[str, Any]] = []

    def put(self, path: str, data: bytes) -> Path:
        """A file of the mirror."""
        file = self.mirror / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(data)
        return file

    def zip_of(self, members: dict[str, bytes]) -> bytes:
        archive = self.cache.with_name("archive.zip")
        with zipfile.ZipFile(archive, "w") as opened:
            for name, data in members.items():
                opened.writestr(name, data)
        return archive.read_bytes()

    def data(self) -> dict[str, Any]:
        return {
            "schema_version": 1,
            "sources": {
                "site": {"base": "https://example.org/x/", "homepage": "h", "revision": "1"}
            },
            "corpora": {"all": [mesh["name"] for mesh in self.meshes]},
            "meshes": self.meshes,
        }

    def write(self) -> None:
        self.manifest.write_text(json.dumps(self.data()))

    def fetch(self, *words: str, mirror: bool = True, bench: Path | None = None) -> int:
        """Runs datasets/fetch.py in this process; --corpus all when no words are given."""
        self.write()
        os.environ.pop("GEODESIC_DATASETS_MIRROR", None)
        if mirror:
            os.environ["GEODESIC_DATASETS_MIRROR"] = str(self.mirror)
        return fetch.main(
            [*(words or ("--corpus", "all")), "--manifest", str(self.manifest)]
            + ["--cache", str(self.cache), "--bench", str(bench or self.bench)]
        )

    def cached(self) -> list[str]:
        """Names in the cache, sorted; leftovers of temporary files included."""
        return sorted(path.name for path in self.cache.iterdir()) if self.cache.exists() else []

    def calls_of_bench(self) -> int:
        calls = self.bench.with_name("calls")
        return len(calls.read_text().splitlines()) if calls.exists() else 0
