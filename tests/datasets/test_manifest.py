"""The manifest: the committed one is sound, and a wrong one is refused with the place."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import jsonschema
import pytest
from fetch_world import TRIANGLE, World, derived, downloaded, generated, packaged
from fetching.cache import CHECKOUT
from fetching.manifest import SCHEMA, Manifest, ManifestError

COMMITTED = Manifest()
NPM = {"manager": "npm", "name": "shapes", "version": "1.2.3", "file": "p.obj"}

Damage = Callable[[dict[str, Any]], None]


def test_the_schema_is_a_schema() -> None:
    jsonschema.Draft202012Validator.check_schema(json.loads(SCHEMA.read_text()))


def test_the_quick_corpus_is_generated_from_nothing() -> None:
    quick = COMMITTED.select(["quick"], [])
    assert len(quick) == 10
    assert all(mesh["kind"] == "generated" and "inputs" not in mesh for mesh in quick)


def test_the_paper_corpus_has_every_model_of_the_thesis_in_its_order() -> None:
    rows = [
        (mesh["thesis_model"], mesh["stand_in"])
        for mesh in COMMITTED.select(["paper"], [])
        if "thesis_model" in mesh
    ]
    assert rows == [
        ("knot", False),
        ("horse", False),
        ("bunny", True),
        ("hand", True),
        ("rocker arm", True),
        ("lucy", True),
        ("asian dragon", True),
        ("cervino terrain", True),
    ]


@pytest.mark.parametrize(
    ("name", "vertices", "faces"),
    [
        ("knot", 28_800, 57_600),
        ("horse", 48_485, 96_966),
        ("bunny-72k", 72_020, None),
        ("rocker-arm-482k", 241_056, 482_112),
        ("jacksboro-terrain", None, 3_145_728),
        ("knot-460k", 460_800, 921_600),
    ],
)
def test_stand_ins_have_the_counts_that_they_are_made_for(
    name: str, vertices: int | None, faces: int | None
) -> None:
    mesh = COMMITTED.entry(name)
    assert vertices in (None, mesh["vertices"]) and faces in (None, mesh["faces"])


def test_the_large_corpus_begins_at_400_000_vertices() -> None:
    assert min(mesh["vertices"] for mesh in COMMITTED.select(["large"], [])) >= 400_000


def test_every_entry_is_in_a_corpus_or_what_one_is_made_from() -> None:
    used = {name for members in COMMITTED.corpora.values() for name in members}
    used |= {name for mesh in COMMITTED.meshes for name in mesh.get("inputs", {}).values()}
    assert used == {entry["name"] for entry in COMMITTED.meshes + COMMITTED.elevation_grids}


def test_a_derived_mesh_has_the_licence_and_credit_of_its_input() -> None:
    for mesh in COMMITTED.meshes:
        for name in mesh.get("inputs", {}).values():
            source = COMMITTED.entry(name)
            for key in ("licence", "credit"):
                assert source.get(key, mesh[key]) == mesh[key], mesh["name"]


def test_the_sources_are_fixed_to_a_commit() -> None:
    for source in COMMITTED.sources.values():
        assert source["base"].endswith(f"/{source['revision']}/")


def test_no_file_of_the_cache_is_tracked() -> None:
    assert "/datasets/cache/" in (CHECKOUT / ".gitignore").read_text().splitlines()


def set_in(place: str, *values: Any) -> Damage:
    """Sets one key, 'meshes/0/file', to a value; without one, removes it."""

    def damage(data: Any) -> None:
        *path, key = place.split("/")
        for step in path:
            data = data[int(step) if step.isdecimal() else step]
        if values:
            data[key] = values[0]
        else:
            del data[key]

    return damage


# Meshes 0 to 3 are a (downloaded), p (in a package), g (generated), d (generated from a).
@pytest.mark.parametrize(
    ("damage", "place", "message"),
    [
        (set_in("extra", 1), "the top level", "'extra' was unexpected"),
        (set_in("elevation_grids"), "the top level", "'elevation_grids' is a required property"),
        (set_in("meshes/0/lisence", "x"), "mesh a", "'lisence' was unexpected"),
        (set_in("meshes/2/path", "site/a.obj"), "mesh g", "'path' was unexpected"),
        (set_in("meshes/0/kind", "found"), "mesh a: kind", "'found' is not one of"),
        (set_in("meshes/0/kind"), "mesh a", "'kind' is a required property"),
        (set_in("meshes/0/licence"), "mesh a", "'licence' is a required property"),
        (set_in("meshes/0/genus"), "mesh a", "'genus' is a required property"),
        (set_in("meshes/0/genus", -1), "mesh a: genus", "less than the minimum"),
        (set_in("meshes/0/sha256", "12"), "mesh a: sha256", "does not match"),
        (set_in("meshes/0/path", "site/../../etc/passwd"), "mesh a: path", "does not match"),
        (set_in("meshes/0/file", "../a.obj"), "mesh a: file", "does not match"),
        (set_in("meshes/0/file", "a.npy"), "mesh a: file", "does not match"),
        (set_in("meshes/0/path", "elsewhere/a.obj"), "mesh a: path", "no source 'elsewhere'"),
        (set_in("meshes/0/thesis_model", "horse"), "mesh a", "'stand_in' is a dependency"),
        (set_in("meshes/1/package/version"), "mesh p: package", "'version' is a required"),
        (set_in("meshes/1/package/manager", "pip"), "mesh p: package: manager", "not one of"),
        (set_in("meshes/1/package/name", "-g"), "mesh p: package: name", "does not match"),
        (set_in("meshes/1/package/x", 1), "mesh p: package", "'x' was unexpected"),
        (set_in("meshes/2/parameters", [4]), "mesh g: parameters", "not of type 'object'"),
        (set_in("meshes/3/credit"), "mesh d", "'credit' is a dependency of 'inputs'"),
        (set_in("meshes/3/inputs", {}), "mesh d: inputs", "does not have enough properties"),
        (set_in("meshes/3/inputs/input", "x"), "mesh d: inputs/input", "there is no mesh 'x'"),
        (set_in("meshes/3/parameters/input", "x"), "mesh d: inputs/input", "among the parameters"),
        (set_in("corpora/all", ["ghost"]), "corpora/all", "there is no mesh 'ghost'"),
        (set_in("corpora/all", ["heights"]), "corpora/all", "there is no mesh 'heights'"),
        (set_in("meshes/1/name", "a"), "meshes", "name 'a' is used 2 times"),
        (set_in("meshes/1/file", "a.obj"), "meshes", "file 'a.obj' is used 2 times"),
        (set_in("elevation_grids/0/vertices", 1), "mesh heights", "'vertices' was unexpected"),
        (set_in("elevation_grids/0/file", "h.obj"), "mesh heights: file", "does not match"),
        (set_in("elevation_grids/0/kind", "found"), "mesh heights: kind", "is not one of"),
    ],
)
def test_a_wrong_manifest_is_refused_with_the_place(
    world: World, damage: Damage, place: str, message: str
) -> None:
    world.meshes = [
        downloaded("a", "site/a.obj", TRIANGLE),
        packaged("p", TRIANGLE, TRIANGLE, NPM),
        generated("g"),
        derived("d", "a", TRIANGLE),
    ]
    world.add_grid("heights", TRIANGLE)
    world.write()
    Manifest(world.manifest)
    data = json.loads(world.manifest.read_text())
    damage(data)
    world.manifest.write_text(json.dumps(data))
    with pytest.raises(ManifestError) as caught:
        Manifest(world.manifest)
    assert str(caught.value).startswith(f"{world.manifest}: at {place}: ")
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


def test_meshes_made_from_each_other_are_refused(world: World) -> None:
    world.meshes = [derived("a", "c", b""), derived("b", "a", b""), derived("c", "b", b"")]
    world.write()
    with pytest.raises(ManifestError) as caught:
        Manifest(world.manifest)
    loop = "a from c from b from a"
    assert str(caught.value).endswith(f"at mesh a: inputs: it is made from itself: {loop}")


@pytest.mark.parametrize("text", ["", "{", "[1]"])
def test_what_is_no_manifest_is_refused(world: World, text: str) -> None:
    world.manifest.write_text(text)
    with pytest.raises(ManifestError):
        Manifest(world.manifest)
