"""Small manifests, mirrors and a stand-in for geodesic-bench, in a temporary folder of each test."""

from __future__ import annotations

import hashlib
import io
import json
import os
import subprocess
import sys
import tarfile
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import fetch
from fetching.cache import WORK
from fetching.program import DEFAULT_BENCH, ROOT


TRIANGLE = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"

BENCH = Path(os.environ.get("GEODESIC_BENCH") or DEFAULT_BENCH).absolute()

COMMITTED: dict[str, Any] = json.loads((ROOT / "datasets" / "manifest.json").read_text("utf-8"))
"""The manifest of the checkout."""

Missing = Callable[..., str]
"""The fixture `missing` of conftest.py."""

# The stand-in for geodesic-bench. It forwards `list`, which reads the manifest, to the real program.
LISTING = """#!/bin/sh
[ "$1" = list ] && exec "${0%/*}/program" "$@"
for last; do :; done
echo called >> "$(dirname "$0")/calls"
"""

# Writes its arguments, with the contents of the input file before them, as the mesh. Tests read them there.
FAKE_BENCH = LISTING + """
[ "$2" = broken ] && { echo "geodesic-bench: no such thing" >&2; exit 1; }
case $3 in
  --input=*) { cat "${3#--input=}"; echo "$2 $4"; } > "$last" ;;
  *) echo "$2 $3" > "$last" ;;
esac
"""


def committed(name: str) -> dict[str, Any]:
    """A mesh or elevation grid of the checkout's manifest."""
    entries: list[dict[str, Any]] = COMMITTED["meshes"] + COMMITTED["elevation_grids"]
    return next(entry for entry in entries if entry["name"] == name)


def sha256(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def entry(name: str, kind: str, sha: str, **more: Any) -> dict[str, Any]:
    return {
        "name": name,
        "kind": kind,
        "file": f"{name}.obj",
        "sha256": sha,
        "vertices": 3,
        "faces": 1,
        "genus": 0,
        "boundary_loops": 1,
        "components": 1,
        "licence": "none",
        "credit": "nobody",
        "tags": [],
        "why": "test",
        **more,
    }


def downloaded(name: str, path: str, upstream: bytes, **more: Any) -> dict[str, Any]:
    return entry(
        name, "downloaded", sha256(upstream), path=path, upstream_sha256=sha256(upstream), **more
    )


def packaged(name: str, upstream: bytes, mesh: bytes, package: dict[str, str]) -> dict[str, Any]:
    more = {"package": package, "upstream_sha256": sha256(upstream)}
    return entry(name, "package", sha256(mesh), **more)


def generated(
    name: str, generator: str = "grid", size: int = 4, contents: bytes = b"", **more: Any
) -> dict[str, Any]:
    """Returns the manifest entry of a mesh that the stand-in makes.

    @param contents contents of the input file"""
    return entry(
        name,
        "generated",
        sha256(contents + f"{generator} --size={size}\n".encode()),
        generator=generator,
        parameters={"size": size},
        file=f"{name}.ply",
        **more,
    )


def derived(name: str, source: str, contents: bytes) -> dict[str, Any]:
    """Returns the manifest entry of a mesh that the stand-in makes from `source`, a file with these contents."""
    return generated(name, "cut", contents=contents, inputs={"input": source})


def tgz_of(members: Mapping[str, bytes], kind: bytes = tarfile.REGTYPE) -> bytes:
    """@param kind type of the members; links point to /etc/passwd"""
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w:gz") as opened:
        for name, data in members.items():
            info = tarfile.TarInfo(name)
            info.type, info.size, info.linkname = kind, len(data), "/etc/passwd"
            opened.addfile(info, io.BytesIO(data))
    return packed.getvalue()


def wait_for(happened: Callable[[], bool], what: str) -> None:
    for _ in range(2000):
        if happened():
            return
        time.sleep(0.01)
    raise AssertionError(f"{what}: not within 20 s")


def executable(file: Path, text: str) -> Path:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    file.chmod(0o755)
    return file


class World:
    """A manifest, a mirror, a program and a cache."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.manifest = folder / "manifest.json"
        self.mirror = folder / "mirror"
        self.cache = folder / "a cache"
        self.bench = executable(folder / "geodesic-bench", FAKE_BENCH)
        (folder / "program").symlink_to(BENCH)
        self.meshes: list[dict[str, Any]] = []
        self.elevation_grids: list[dict[str, Any]] = []

    def put(self, path: str, data: bytes) -> Path:
        """Writes a file of the mirror."""
        file = self.mirror / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(data)
        return file

    def put_mesh(self, name: str, data: bytes = TRIANGLE) -> Path:
        """Adds a mesh to the manifest and its file to the mirror."""
        self.meshes.append(downloaded(name, f"site/{name}.obj", data))
        return self.put(f"site/{name}.obj", data)

    def add_grid(self, name: str, data: bytes) -> None:
        """Adds an elevation grid to the manifest and its file to the mirror."""
        grid = downloaded(name, f"site/{name}.npy", data, file=f"{name}.npy")
        for key in ["vertices", "faces", "genus", "boundary_loops", "components", "tags"]:
            del grid[key]
        self.elevation_grids.append(grid)
        self.put(f"site/{name}.npy", data)

    def data(self) -> dict[str, Any]:
        return {
            "schema_version": 1,
            "sources": {
                "site": {"base": "https://example.org/x/", "homepage": "h", "revision": "1"}
            },
            "corpora": {"all": [mesh["name"] for mesh in self.meshes]},
            "meshes": self.meshes,
            "elevation_grids": self.elevation_grids,
        }

    def write(self) -> None:
        self.manifest.write_text(json.dumps(self.data()))

    def words(self, *words: str) -> list[str]:
        """Writes the manifest; returns the arguments of fetch.py. Without `words` they have --corpus all."""
        self.write()
        return [
            *(words or ("--corpus", "all")),
            *("--manifest", str(self.manifest)),
            *("--cache", str(self.cache), "--bench", str(self.bench)),
        ]

    def fetch(self, *words: str, mirror: str | None = "") -> int:
        """Runs datasets/fetch.py in this process. An empty `mirror` means the mirror of this world, None
        means no mirror."""
        os.environ.pop("GEODESIC_DATASETS_MIRROR", None)
        if mirror is not None:
            os.environ["GEODESIC_DATASETS_MIRROR"] = mirror or str(self.mirror)
        return fetch.main(self.words(*words))

    def start(self, mirror: str = "") -> subprocess.Popen[str]:
        """Starts datasets/fetch.py --corpus all as a separate process."""
        command = [sys.executable, str(ROOT / "datasets" / "fetch.py"), *self.words()]
        environment = dict(os.environ, GEODESIC_DATASETS_MIRROR=mirror)
        pipe = subprocess.PIPE
        return subprocess.Popen(command, env=environment, stdout=pipe, stderr=pipe, text=True)

    def cached(self) -> list[str]:
        """Names of the files in the cache, sorted."""
        if not self.cache.exists():
            return []
        return sorted(path.name for path in self.cache.iterdir() if path.name != WORK)

    def leftovers(self) -> list[str]:
        """Unfinished files in the cache, by name; locks are empty and stay."""
        files = (self.cache / WORK).glob("**/*")
        return sorted(file.name for file in files if file.is_file() and file.suffix != ".lock")

    def calls_of_bench(self) -> int:
        calls = self.bench.with_name("calls")
        return len(calls.read_text().splitlines()) if calls.exists() else 0
