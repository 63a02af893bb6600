"""The available meshes of the committed manifest agree with it.

Meshes that are generated without inputs are always available. The others need GEODESIC_DATASETS_MIRROR
in the environment. They are then really fetched, from the folder and over HTTP.
"""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import fetch
import pytest
from fetch_world import BENCH, COMMITTED, World, committed
from http_site import serving

FACTS = ["vertices", "faces", "genus", "boundary_loops", "components"]
MANY_VERTICES = 200_000  # a test with sanitizers takes too long on larger meshes

pytestmark = pytest.mark.skipif(not BENCH.exists(), reason=f"no program at {BENCH}")


def origins(mesh: dict[str, Any]) -> set[str]:
    """Returns the kinds of a mesh and of its inputs, direct and indirect."""
    inputs = mesh.get("inputs", {}).values()
    return {mesh["kind"]}.union(*(origins(committed(name)) for name in inputs))


def names_of(kinds: set[str]) -> list[str]:
    return [
        mesh["name"]
        for mesh in COMMITTED["meshes"]
        if origins(mesh) <= kinds and mesh["vertices"] <= MANY_VERTICES
    ]


GENERATED = names_of({"generated"})
MIRRORED = [name for name in names_of({"generated", "downloaded"}) if name not in GENERATED]


def fetch_into(cache: Path, names: list[str]) -> int:
    return fetch.main([*names, "--cache", str(cache), "--bench", str(BENCH)])


def wrong_facts(cache: Path, names: list[str]) -> dict[str, dict[str, tuple[int, int]]]:
    """Returns the differing facts, by mesh, as (in the manifest, found by geodesic-bench mesh)."""
    wrong = {}
    for name in names:
        mesh = committed(name)
        command = [BENCH, "mesh", "--json", cache / mesh["file"]]
        found = json.loads(subprocess.run(command, capture_output=True, text=True).stdout)
        if differing := {k: (mesh[k], found[k]) for k in FACTS if mesh[k] != found[k]}:
            wrong[name] = differing
    return wrong


def test_generated_meshes_have_the_committed_bytes_and_facts(world: World) -> None:
    assert fetch_into(world.cache, GENERATED) == 0
    assert wrong_facts(world.cache, GENERATED) == {}


def test_real_files_and_what_is_made_of_them_have_the_committed_bytes_and_facts(
    real_mirror: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("GEODESIC_DATASETS_MIRROR", str(real_mirror))
    assert fetch_into(tmp_path, MIRRORED) == 0
    assert wrong_facts(tmp_path, MIRRORED) == {}


def test_real_files_come_over_http_as_from_the_folder(
    real_mirror: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = [mesh["name"] for mesh in COMMITTED["meshes"] if mesh["kind"] == "downloaded"]
    with serving(real_mirror) as site:
        monkeypatch.setenv("GEODESIC_DATASETS_MIRROR", site.url)
        assert fetch_into(tmp_path, names) == 0
        assert site.asked == [f"/{committed(name)['path']}" for name in names]


def test_the_elevation_grid_comes_out_of_the_installed_package(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    assert fetch_into(tmp_path, ["jacksboro"]) == 0
    assert wrong_facts(tmp_path, ["jacksboro"]) == {}
