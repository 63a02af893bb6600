"""Manifests, as fetch.py and geodesic-bench read them."""

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
GENERATED: dict[str, Any] = {
    **{key: MESH[key] for key in MESH if key not in ("path", "upstream_sha256")},
    "kind": "generated", "generator": "clean", "parameters": {},
}  # fmt: skip
GOOD: dict[str, Any] = {
    "schema_version": 1,
    "sources": {"site": {"base": "https://nowhere.invalid/", "homepage": "-", "revision": "-"}},
    "corpora": {"all": ["hill"]},
    "meshes": [MESH],
    "elevation_grids": [],
}
DEEP = 100_000 * "["


def fetched(what: str, change: Callable[[dict[str, Any]], object], *says: str) -> Case:
    manifest = copy.deepcopy(GOOD)
    change(manifest)
    return Case(f"fetch.py: {what}", "fetch.py hill --manifest manifest.json",
                ["fetch.py: manifest.json: at ", *says],
                files={"manifest.json": json.dumps(manifest)})  # fmt: skip


def mesh(what: str, entry: dict[str, Any], *says: str) -> Case:
    return fetched(what, lambda manifest: manifest.update(meshes=[entry]), "mesh", *says)


def listed(what: str, text: str, *says: str) -> Case:
    return Case(f"geodesic-bench: {what}", "geodesic-bench list --manifest manifest.json",
                ["manifest.json: ", *says], files={"manifest.json": text})  # fmt: skip


def entry(what: str, says: str, **values: object) -> Case:
    named: dict[str, object] = {"name": "hill", "file": "hill.obj", "kind": "generated"} | values
    return listed(what, json.dumps({"meshes": [named], "corpora": {}}), "meshes[0]: ", says)


CASES = [
    Case("fetch.py: nothing there", "fetch.py hill --manifest nowhere.json",
         ["nowhere.json: No such file", "--manifest names a list of meshes such as"]),
    Case("fetch.py: no JSON", "fetch.py hill --manifest manifest.json",
         ["manifest.json: not JSON", "line 1 column 2"], files={"manifest.json": "{"}),
    Case("fetch.py: no text", "fetch.py hill --manifest manifest.json",
         ["manifest.json: not JSON", "position 0"], files={"manifest.json": b"\xff\xfe"}),
    Case("fetch.py: nested 100,000 deep", "fetch.py hill --manifest manifest.json",
         ["manifest.json: nested far deeper than a manifest is"], files={"manifest.json": DEEP}),
    fetched("an unknown key", lambda manifest: manifest.update(mashes=[]), "'mashes'"),
    mesh("a missing sha256", {k: v for k, v in MESH.items() if k != "sha256"},
         "'sha256' is a required property"),
    mesh("a sha256 that is none", {**MESH, "sha256": "abc"}, "sha256", "'abc' does not match"),
    mesh("an unknown key of a mesh", {**MESH, "colour": "red"}, "hill", "colour"),
    mesh("a file outside of the cache", {**MESH, "file": "../hill.obj"}, "file", "../hill.obj"),
    mesh("an absolute file", {**MESH, "file": "/tmp/hill.obj"}, "file", "/tmp/hill.obj"),
    mesh("a path outside of the mirror", {**MESH, "path": "site/../../hill.obj"}, "path"),
    mesh("an unknown source", {**MESH, "path": "elsewhere/hill.obj"},
         "path: there is no source 'elsewhere'"),
    mesh("a mesh made from itself",
         {**GENERATED, "inputs": {"input": "hill"}}, "made from itself: hill from hill"),
    mesh("an unknown input", {**GENERATED, "inputs": {"input": "dale"}}, "there is no mesh 'dale'"),
    mesh("a name that goes on in the next line", {**MESH, "name": "hill\n"}, "control character"),
    fetched("an unknown mesh in a corpus",
            lambda manifest: manifest["corpora"].update(all=["dale"]), "there is no mesh 'dale'"),
    fetched("a name used twice",
            lambda manifest: manifest.update(meshes=[MESH, {**MESH, "file": "b.obj"}]),
            "name 'hill' is used 2 times"),
    fetched("a site without encryption",
            lambda manifest: manifest["sources"]["site"].update(base="http://nowhere.invalid/"),
            "base", "http://nowhere.invalid/"),
    # geodesic-bench reads fewer keys
    Case("geodesic-bench: nothing there", "geodesic-bench list --manifest nowhere.json",
         ["cannot read 'nowhere.json': No such file", "name a manifest, such as"]),
    Case("geodesic-bench: a folder", "geodesic-bench list --manifest .",
         ["cannot read '.': it is a folder; name a manifest, such as"]),
    listed("no JSON", "{", "not valid JSON", "line 1, column 2", "get a whole copy"),
    listed("no meshes", "{}", "not a manifest of meshes: key 'meshes' not found"),
    listed("an unknown mesh in a corpus", '{"meshes": [], "corpora": {"a": ["b"]}}',
           "corpora/a: no mesh named 'b'; there are: none"),
    listed("a name used twice",
           json.dumps({"meshes": [MESH, MESH], "corpora": {}}), "two meshes are named 'hill'"),
    entry("a name with folders", "no mesh can be named '../../evil': names are of letters",
          name="../../evil"),
    entry("a name that would clear the screen", r"no mesh can be named '\x1b[2J': names are of letters",
          name="\x1b[2J"),
    entry("a file outside of the cache", "no mesh file can be named '/etc/passwd'",
          file="/etc/passwd"),
    entry("a number for a name", "type must be string, but is number", name=5),
]  # fmt: skip
