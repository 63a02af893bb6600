"""The manifest: the committed one is sound, and a wrong one is refused with the place."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from fetch_world import TRIANGLE, World, downloaded, generated
from fetching.cache import CHECKOUT, Cache
from fetching.manifest import SCHEMA, Manifest, ManifestError
from fetching.sources import DEFAULT_BENCH, Fetcher

BENCH = Path(os.environ.get("GEODESIC_BENCH") or DEFAULT_BENCH)
COMMITTED = Manifest()
GENERATED = [mesh for mesh in COMMITTED.meshes if mesh["kind"] == "generated"]


def test_the_schema_is_a_schema() -> None:
    jsonschema.Draft202012Validator.check_schema(json.loads(SCHEMA.read_text()))


def test_the_quick_corpus_is_generated_only() -> None:
    quick = COMMITTED.select(["quick"], [])
    assert len(quick) == 10
    assert {mesh["kind"] for mesh in quick} == {"generated"}


def test_the_thesis_models_that_are_not_the_same_are_stand_ins() -> None:
    rows = {m["thesis_model"]: m["stand_in"] for m in COMMITTED.meshes if "thesis_model" in m}
    assert rows == {"knot": False, "horse": False, "bunny": True, "rocker arm": True}


def test_the_knot_has_the_counts_of_the_thesis() -> None:
    (knot,) = COMMITTED.select([], ["knot"])
    assert (knot["vertices"], knot["faces"]) == (28800, 57600)


def test_every_mesh_is_in_a_corpus() -> None:
    listed = {name for members in COMMITTED.corpora.values() for name in members}
    assert listed == {mesh["name"] for mesh in COMMITTED.meshes}


@pytest.mark.skipif(not BENCH.exists(), reason=f"no program at {BENCH}")
@pytest.mark.parametrize("mesh", GENERATED, ids=[mesh["name"] for mesh in GENERATED])
def test_the_generated_meshes_have_the_committed_bytes(
    mesh: dict[str, Any], tmp_path: Path
) -> None:
    Fetcher(Cache(tmp_path), BENCH, mirror=None).fetch(mesh)
    header = (tmp_path / mesh["file"]).read_bytes().split(b"end_header")[0].decode()
    assert f"element vertex {mesh['vertices']}\n" in header
    assert f"element face {mesh['faces']}\n" in header


def break_key(data: dict[str, Any]) -> None:
    data["meshes"][0]["lisence"] = "x"


def break_parameters(data: dict[str, Any]) -> None:
    data["meshes"][1]["parameters"] = [4]


def break_path(data: dict[str, Any]) -> None:
    data["meshes"][0]["path"] = "site/../../etc/passwd"


def break_file(data: dict[str, Any]) -> None:
    data["meshes"][0]["file"] = "../a.obj"


def break_source(data: dict[str, Any]) -> None:
    data["meshes"][0]["path"] = "elsewhere/a.obj"


def break_member(data: dict[str, Any]) -> None:
    data["meshes"][0]["archive_member"] = "a.obj"


def break_corpus(data: dict[str, Any]) -> None:
    data["corpora"]["all"].append("ghost")


def break_names(data: dict[str, Any]) -> None:
    data["meshes"][1]["name"] = "a"
    data["corpora"]["all"] = ["a"]


def break_top_level(data: dict[str, Any]) -> None:
    data["extra"] = 1


@pytest.mark.parametrize(
    ("damage", "place", "message"),
    [
        (break_key, "at mesh a:", "'lisence' was unexpected"),
        (break_parameters, "at mesh g: parameters:", "not of type 'object'"),
        (break_path, "at mesh a: path:", "does not match"),
        (break_file, "at mesh a: file:", "does not match"),
        (break_source, "at mesh a: path:", "there is no source 'elsewhere'"),
        (break_member, "at mesh a:", "'member_sha256' is a dependency"),
        (break_corpus, "at corpora/all:", "there is no mesh 'ghost'"),
        (break_names, "at meshes:", "name 'a' is used 2 times"),
        (break_top_level, "at the top level:", "'extra' was unexpected"),
    ],
)
def test_a_wrong_manifest_is_refused_with_the_place(
    world: World, damage: Callable[[dict[str, Any]], None], place: str, message: str
) -> None:
    world.meshes = [downloaded("a", "site/a.obj", TRIANGLE), generated("g")]
    data = world.data()
    damage(data)
    world.manifest.write_text(json.dumps(data))
    with pytest.raises(ManifestError) as caught:
        Manifest(world.manifest)
    assert str(caught.value).startswith(f"{world.manifest}: {place} ")
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("text", ["", "{", "[1]"])
def test_what_is_no_manifest_is_refused(world: World, text: str) -> None:
    world.manifest.write_text(text)
    with pytest.raises(ManifestError):
        Manifest(world.manifest)


def test_the_sources_are_fixed_to_a_commit() -> None:
    for source in COMMITTED.sources.values():
        assert source["base"].endswith(f"/{source['revision']}/")


def test_no_file_of_the_cache_is_tracked() -> None:
    assert "/datasets/cache/" in (CHECKOUT / ".gitignore").read_text().splitlines()
