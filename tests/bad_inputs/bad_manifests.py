"""Bad manifests. geodesic-bench reads them, for itself and for fetch.py. tests/datasets/test_manifest.py has the bad entries."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from typing import Any

from case import Case

MESH: dict[str, Any] = {
    "name": "hill", "kind": "downloaded", "file": "hill.obj", "sha256": 64 * "0",
    "path": "site/hill.obj", "upstream_sha256": 64 * "0", "licence": "free", "credit": "us",
    "vertices": 4, "faces": 4, "genus": 0, "boundary_loops": 0, "components": 1, "tags": [],
    "why": "a test",
}  # fmt: skip
GOOD: dict[str, Any] = {
    "schema_version": 1,
    "sources": {"site": {"base": "https://nowhere.invalid/", "homepage": "-", "revision": "-"}},
    "corpora": {"all": ["hill"]},
    "meshes": [MESH],
    "elevation_grids": [],
}
DEEP = 100_000 * "["


def of(command: str, what: str, change: Callable[[dict[str, Any]], object], *says: str) -> Case:
    manifest = copy.deepcopy(GOOD)
    change(manifest)
    program = command.split()[0]
    return Case(f"{program}: {what}", f"{command} --manifest manifest.json",
                [f"{program}: manifest.json: ", *says],
                files={"manifest.json": json.dumps(manifest)})  # fmt: skip


def listed(what: str, change: Callable[[dict[str, Any]], object], *says: str) -> Case:
    return of("geodesic-bench list", what, change, *says)


def listed_mesh(what: str, entry: dict[str, Any], *says: str) -> Case:
    return listed(what, lambda manifest: manifest.update(meshes=[entry]), "meshes: ", *says)


def listed_text(what: str, text: str | bytes, *says: str) -> Case:
    return Case(f"geodesic-bench: {what}", "geodesic-bench list --manifest manifest.json",
                ["manifest.json: ", *says], files={"manifest.json": text})  # fmt: skip


def run_on(what: str, entry: dict[str, Any], *says: str) -> Case:
    """Returns a case in which a command needs the mesh."""
    return of("geodesic-bench solve hill --solver mmp --source 0", what,
              lambda manifest: manifest.update(meshes=[entry]), *says)  # fmt: skip


CASES = [
    # Errors of fetch.py
    Case("fetch.py: nothing there", "fetch.py hill --manifest nowhere.json",
         ["fetch.py: cannot read 'nowhere.json': No such file", "name a manifest, such as"]),
    Case("fetch.py: no program", "fetch.py hill --bench nowhere",
         ["fetch.py: geodesic-bench reads the list of meshes and is not at nowhere",
          "build it (./run_all.sh build) or name it with --bench"]),
    Case("fetch.py: no JSON", "fetch.py hill --manifest manifest.json",
         ["fetch.py: manifest.json: not valid JSON", "line 1, column 2"],
         files={"manifest.json": "{"}),
    # Errors of geodesic-bench
    Case("geodesic-bench: nothing there", "geodesic-bench list --manifest nowhere.json",
         ["cannot read 'nowhere.json': No such file", "name a manifest, such as"]),
    Case("geodesic-bench: a folder", "geodesic-bench list --manifest .",
         ["cannot read '.': it is a folder; name a manifest, such as"]),
    listed_text("no JSON", "{", "not valid JSON", "line 1, column 2", "get a whole copy"),
    listed_text("no text", b"\xff", "not valid JSON"),
    listed_text("UTF-16", "[]".encode("utf-16"), "manifest.json: the text is UTF-16; save it as UTF-8"),
    listed_text("nested 100,000 deep", DEEP, "nested more than 50 deep"),
    listed_text("a list", "[]", "must be an object, not an array"),
    listed_text("no meshes", "{}", "key 'schema_version' is missing"),
    listed("an unknown mesh in a corpus", lambda manifest: manifest["corpora"].update(all=["hil"]),
           "corpora: all: no mesh named 'hil' (did you mean 'hill'?)"),
    listed_mesh("a name that would clear the screen", {**MESH, "name": "\x1b[2J"},
                r"\x1b[2J: name: must be text without control characters"),
    listed_mesh("a number for a name", {**MESH, "name": 5}, "0: name: must be a name of at most 100 letters", "not 5"),
    run_on("a fraction of a vertex", {**MESH, "vertices": 4.5},
           "meshes: hill: vertices: must be an integer of at least 0, not 4.5"),
]  # fmt: skip
