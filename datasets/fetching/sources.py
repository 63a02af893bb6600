"""Where meshes come from: the generators of geodesic-bench, and a mirror of the upstream sites."""

from __future__ import annotations

import os
import shutil
import subprocess
import zipfile
from pathlib import Path
from typing import Any

from .cache import CHECKOUT, Cache, sha256_of
from .manifest import Mesh

MIRROR_VARIABLE = "GEODESIC_DATASETS_MIRROR"
DEFAULT_BENCH = CHECKOUT / "build" / "release" / "geodesic-bench"


class Unavailable(Exception):
    """This mesh could not be had; the message says why and what to do."""


def recipe_of(mesh: Mesh) -> dict[str, Any] | None:
    """What a generated mesh is made from; None for others."""
    if mesh["kind"] != "generated":
        return None
    return {"generator": mesh["generator"], "parameters": mesh["parameters"]}


def sha256_in_cache(mesh: Mesh) -> str:
    """Of the mesh's file in the cache, which for an archive is not that of the upstream file."""
    return str(mesh.get("member_sha256", mesh["sha256"]))


class Fetcher:
    """Fills a cache. `bench` is the geodesic-bench program, `mirror` None when none is set."""

    def __init__(self, cache: Cache, bench: Path, mirror: Path | None) -> None:
        self._cache = cache
        self._bench = bench
        self._mirror = mirror

    def fetch(self, mesh: Mesh) -> bool:
        """Makes sure that a mesh is in the cache; False when it was there already.

        Raises Unavailable when this mesh cannot be had, CacheError when none can.
        """
        recipe = recipe_of(mesh)
        if self._cache.holds(mesh["file"], sha256_in_cache(mesh), recipe):
            return False
        with self._cache.scratch() as scratch:
            try:
                whole = self._obtain(mesh, scratch)
                self._cache.adopt(whole, mesh["file"], recipe)
            except OSError as error:
                raise Unavailable(f"{error.strerror}: {error.filename}") from error
        return True

    def _obtain(self, mesh: Mesh, scratch: Path) -> Path:
        """The checked file, in the scratch folder."""
        if mesh["kind"] == "generated":
            whole = self._generate(mesh, scratch)
            _check(whole, mesh["sha256"], f"what {self._bench.name} generated")
            return whole
        upstream = self._copy_from_mirror(mesh, scratch)
        _check(upstream, mesh["sha256"], str(self._upstream_path(mesh)))
        if "archive_member" not in mesh:
            return upstream
        whole = scratch / str(mesh["file"])
        _extract(upstream, mesh["archive_member"], whole)
        _check(whole, mesh["member_sha256"], f"{mesh['archive_member']} in {upstream.name}")
        return whole

    def _generate(self, mesh: Mesh, scratch: Path) -> Path:
        if not os.access(self._bench, os.X_OK):
            raise Unavailable(
                f"is made by geodesic-bench, which is not at {self._bench}: "
                "build it (./run_all.sh build) or name it with --bench"
            )
        whole = scratch / str(mesh["file"])
        parameters = [f"--{name}={value}" for name, value in mesh["parameters"].items()]
        command = [str(self._bench), "generate", mesh["generator"], *parameters, "-o", str(whole)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            lines = done.stderr.strip().splitlines() or [f"exit code {done.returncode}"]
            raise Unavailable(f"could not be generated: {lines[-1]}")
        return whole

    def _upstream_path(self, mesh: Mesh) -> Path:
        if self._mirror is None:
            raise Unavailable(
                f"is a downloaded mesh: set {MIRROR_VARIABLE} to a folder that holds {mesh['path']}"
            )
        return self._mirror / str(mesh["path"])

    def _copy_from_mirror(self, mesh: Mesh, scratch: Path) -> Path:
        path = self._upstream_path(mesh)
        if not path.is_file():
            raise Unavailable(f"is not in the mirror: there is no {path}")
        copy = scratch / f"upstream-{path.name}"
        shutil.copyfile(path, copy)
        return copy


def mirror_from_environment() -> Path | None:
    value = os.environ.get(MIRROR_VARIABLE)
    return Path(value) if value else None


def _check(path: Path, expected: str, what: str) -> None:
    found = sha256_of(path)
    if found != expected:
        raise Unavailable(f"{what} has sha256 {found}, the manifest says {expected}: not used")


def _extract(archive: Path, member: str, target: Path) -> None:
    """Writes one named member to `target`; no path in the archive decides where anything goes."""
    try:
        with zipfile.ZipFile(archive) as opened, opened.open(member) as source:
            with target.open("wb") as file:
                shutil.copyfileobj(source, file)
    except KeyError:
        raise Unavailable(f"the archive holds no {member}") from None
    except zipfile.BadZipFile as error:
        raise Unavailable(f"the archive cannot be read: {error}") from error
