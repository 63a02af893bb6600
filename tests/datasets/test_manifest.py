"""The committed manifest is valid. A wrong manifest is refused with the place of the error."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from typing import Any

import fetch
import jsonschema
import pytest
from fetch_world import (
    BENCH,
    COMMITTED,
    TRIANGLE,
    World,
    committed,
    derived,
    downloaded,
    generated,
    packaged,
)
from fetching.program import ROOT

SCHEMA = jsonschema.Draft202012Validator(
    json.loads((ROOT / "datasets" / "manifest.schema.json").read_text("utf-8"))
)
NPM = {"manager": "npm", "name": "shapes", "version": "1.2.3", "file": "p.obj"}

Damage = Callable[[dict[str, Any]], None]


def members(corpus: str) -> list[dict[str, Any]]:
    return [committed(name) for name in COMMITTED["corpora"][corpus]]


def test_the_schema_is_one_and_holds_for_the_committed_manifest() -> None:
    SCHEMA.check_schema(SCHEMA.schema)
    SCHEMA.validate(COMMITTED)


def test_the_quick_corpus_is_generated_from_nothing() -> None:
    quick = members("quick")
    assert len(quick) == 10
    assert all(mesh["kind"] == "generated" and "inputs" not in mesh for mesh in quick)


def test_the_paper_corpus_has_every_model_of_the_thesis_in_its_order() -> None:
    rows = [
        (mesh["thesis_model"], mesh["stand_in"])
        for mesh in members("paper")
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
    mesh = committed(name)
    assert vertices in (None, mesh["vertices"]) and faces in (None, mesh["faces"])


def test_the_large_corpus_begins_at_400_000_vertices() -> None:
    assert min(mesh["vertices"] for mesh in members("large")) >= 400_000


def test_every_case_of_the_robustness_corpus_names_its_sources_and_has_an_oracle() -> None:
    for mesh in members("robustness"):
        closed_form = mesh["generator"] in ("box", "capped-grid", "grid", "cone", "square-with-hole")
        assert mesh["sources"] and (closed_form or mesh["faces"] <= 400), mesh["name"]


def test_every_entry_is_in_a_corpus_or_what_one_is_made_from() -> None:
    used = {name for members in COMMITTED["corpora"].values() for name in members}
    used |= {name for mesh in COMMITTED["meshes"] for name in mesh.get("inputs", {}).values()}
    assert used == {entry["name"] for entry in COMMITTED["meshes"] + COMMITTED["elevation_grids"]}


def test_a_derived_mesh_has_the_licence_and_credit_of_its_input() -> None:
    for mesh in COMMITTED["meshes"]:
        for name in mesh.get("inputs", {}).values():
            source = committed(name)
            for key in ("licence", "credit"):
                assert source.get(key, mesh[key]) == mesh[key], mesh["name"]


def test_the_sources_are_fixed_to_a_commit() -> None:
    for source in COMMITTED["sources"].values():
        assert source["base"].endswith(f"/{source['revision']}/")


def test_no_file_of_the_cache_is_tracked() -> None:
    assert "/datasets/cache/" in (ROOT / ".gitignore").read_text().splitlines()


def set_in(place: str, *values: Any) -> Damage:
    """Sets a key, such as 'meshes/0/file', to a value. Without a value, removes it."""

    def damage(data: Any) -> None:
        *path, key = [int(step) if step.isdecimal() else step for step in place.split("/")]
        for step in path:
            data = data[step]
        if values:
            data[key] = values[0]
        else:
            del data[key]

    return damage


# Meshes 0 to 3 are a (downloaded), p (in a package), g (generated), d (generated from a).
# The last column: whether the schema refuses the manifest, too.
@pytest.mark.parametrize(
    ("damage", "message", "in_schema"),
    [
        (set_in("extra", 1), "no key named 'extra'", True),
        (set_in("elevation_grids"), "key 'elevation_grids' is missing", True),
        (set_in("schema_version", 2), "schema_version: must be 1, not 2", True),
        (set_in("meshes", {}), "meshes: must be a list, not an object", True),
        (set_in("meshes/0", 5), "meshes: 0: must be an object, not 5", True),
        (set_in("meshes/0/lisence", "x"), "a: no key named 'lisence' (did you mean 'lic", True),
        (set_in("meshes/2/path", "site/a.obj"), "meshes: g: no key named 'path'", True),
        (set_in("meshes/0/kind", "found"), "meshes: a: kind: must be one of generated, ", True),
        (set_in("meshes/0/kind"), "meshes: a: key 'kind' is missing", True),
        (set_in("meshes/0/name"), "meshes: 0: key 'name' is missing", True),
        (set_in("meshes/0/name", "../a"), "meshes: ../a: name: must be a name of at most 100", True),
        (set_in("meshes/0/name", "a" * 101), "name: must be a name of at most 100 letters", True),
        (set_in("meshes/0/why", "a\nb"), "meshes: a: why: must be text without control", True),
        (set_in("meshes/0/why", ""), 'meshes: a: why: must be text, not ""', True),
        (set_in("meshes/0/licence"), "meshes: a: key 'licence' is missing", True),
        (set_in("meshes/0/genus"), "meshes: a: key 'genus' is missing", True),
        (set_in("meshes/0/genus", -1), "genus: must be an integer of at least 0, or nu", True),
        (set_in("meshes/0/faces", 0.5), "faces: must be an integer of at least 0, not 0.5", True),
        (set_in("meshes/0/sha256", "12"), 'sha256: must be 64 hexadecimal digits in lower', True),
        (set_in("meshes/0/tags", ["x", "x"]), 'tags: "x" is listed twice', True),
        (set_in("meshes/0/sources", []), "a: sources: must not be empty", True),
        (set_in("meshes/0/sources", [-1]), "sources: 0: must be an integer of at least 0", True),
        (set_in("meshes/0/sources", [99]), "sources: must be vertices of the mesh, not 99", False),
        (set_in("meshes/0/reports", ["x"]), "reports: 0: must be an https:// address", True),
        (set_in("meshes/0/path", "site/../../x"), "path: must be a path that begins with", True),
        (set_in("meshes/0/path", "/site/x"), "path: must be a path that begins with", True),
        (set_in("meshes/0/path", "a.obj"), "path: must be a path that begins with", True),
        (set_in("meshes/0/path", "elsewhere/a"), "path: there is no source 'elsewhere'", False),
        (set_in("meshes/0/file", "../a.obj"), "file: must be the name of a file, without", True),
        (set_in("meshes/0/file", "a.npy"), "ends in .obj, .off, .ply or .stl", True),
        (set_in("meshes/0/thesis_model", "horse"), "a: key 'stand_in' is missing", True),
        (set_in("meshes/0/stand_in", True), "a: key 'thesis_model' is missing", True),
        (set_in("meshes/1/package/version"), "p: package: key 'version' is missing", True),
        (set_in("meshes/1/package/version", "latest"), "must be a version such as", True),
        (set_in("meshes/1/package/manager", "pip"), "manager: must be one of npm, python", True),
        (set_in("meshes/1/package/manager", "python"), "p: package: version: must be left out", True),
        (set_in("meshes/1/package/name", "-g"), "must be 'name' or '@scope/name'", True),
        (set_in("meshes/1/package/name", "a/b"), "must be 'name' or '@scope/name'", True),
        (set_in("meshes/1/package/x", 1), "p: package: no key named 'x'", True),
        (set_in("meshes/2/parameters", [4]), "parameters: must be an object, not an array", True),
        (set_in("meshes/2/parameters/x", None), "x: must be a number or text, not null", True),
        (set_in("meshes/3/credit"), "meshes: d: key 'credit' is missing", True),
        (set_in("meshes/3/inputs", {}), "meshes: d: inputs: must not be empty", True),
        (set_in("meshes/3/inputs/input", "x"), "input: there is no mesh 'x' before this", False),
        (set_in("meshes/3/inputs/input", "d"), "input: there is no mesh 'd' before this", False),
        (set_in("meshes/2/inputs", {"x": "d"}), "x: there is no mesh 'd' before this one", False),
        (set_in("meshes/3/parameters/input", "x"), "input: is one of the parameters", False),
        (set_in("corpora/all", []), "corpora: all: must not be empty", True),
        (set_in("corpora/all", ["a", "a"]), 'corpora: all: "a" is listed twice', True),
        (set_in("corpora/all", ["ghost"]), "corpora: all: no mesh named 'ghost'", False),
        (set_in("corpora/all", ["heights"]), "corpora: all: no mesh named 'heights'", False),
        (set_in("corpora/a b", ["a"]), "corpora: a b: must be a name of at most 100", True),
        (set_in("sources/site/base", "http://x/"), "base: must be an https:// address", True),
        (set_in("meshes/1/name", "a"), "meshes: a: the name is used twice", False),
        (set_in("meshes/1/file", "a.obj"), "meshes: p: the file is used twice", False),
        (set_in("elevation_grids/0/vertices", 1), "heights: no key named 'vertices'", True),
        (set_in("elevation_grids/0/file", "h.obj"), "heights: file: must be the name of a", True),
        (set_in("elevation_grids/0/kind", "generated"), "heights: kind: must be one of dow", True),
    ],
)
def test_a_wrong_manifest_is_refused_with_the_place(
    world: World,
    damage: Damage,
    message: str,
    in_schema: bool,
    capsys: pytest.CaptureFixture[str],
) -> None:
    world.meshes = [
        downloaded("a", "site/a.obj", TRIANGLE),
        packaged("p", TRIANGLE, TRIANGLE, NPM),
        generated("g"),
        derived("d", "a", TRIANGLE),
    ]
    world.add_grid("heights", TRIANGLE)
    data = json.loads(json.dumps(world.data()))
    SCHEMA.validate(data)
    damage(data)
    assert SCHEMA.is_valid(data) != in_schema
    world.manifest.write_text(json.dumps(data))
    assert fetch.main(["a", "--manifest", str(world.manifest), "--bench", str(BENCH)]) == 1
    said = capsys.readouterr().err
    assert said.startswith(f"fetch.py: {world.manifest}: ") and message in said
    assert len(said.splitlines()) == 1


def listed(*words: str) -> str:
    """Returns the output of `list` for the committed manifest."""
    command = [str(BENCH), "list", *words, "--manifest", str(ROOT / "datasets" / "manifest.json")]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def test_list_has_all_that_the_manifest_says() -> None:
    said = json.loads(listed("--json"))
    for key in ["sources", "corpora", "elevation_grids"]:
        assert said[key] == COMMITTED[key]
    for mesh, known in zip(said["meshes"], COMMITTED["meshes"], strict=True):
        assert {key: mesh[key] for key in known} == known


def test_list_shows_vertices_and_faces_of_every_mesh() -> None:
    lines = map(str.split, listed().splitlines())
    rows = {words[0]: words[1:3] for words in lines if len(words) > 3}
    for mesh in COMMITTED["meshes"]:
        assert rows[mesh["name"]] == [str(mesh["vertices"]), str(mesh["faces"])]
