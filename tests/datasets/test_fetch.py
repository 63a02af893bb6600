"""datasets/fetch.py against a mirror and a program made by the test."""

from __future__ import annotations

import os

import pytest
from fetch_world import TRIANGLE, World, downloaded, generated, sha256


def test_meshes_are_copied_and_generated(world: World) -> None:
    world.put("site/a.obj", TRIANGLE)
    world.meshes = [downloaded("a", "site/a.obj", TRIANGLE), generated("g")]
    assert world.fetch() == 0
    assert (world.cache / "a.obj").read_bytes() == TRIANGLE
    assert (world.cache / "g.ply").read_text() == "grid --size=4\n"
    assert world.cached() == ["a.obj", "g.ply", "g.ply.recipe.json"]


def test_a_second_fetch_does_nothing(world: World, capsys: pytest.CaptureFixture[str]) -> None:
    upstream = world.put("site/a.obj", TRIANGLE)
    world.meshes = [downloaded("a", "site/a.obj", TRIANGLE), generated("g")]
    world.fetch()
    before = {path: path.stat().st_mtime_ns for path in world.cache.iterdir()}
    upstream.unlink()
    capsys.readouterr()
    assert world.fetch(mirror=False) == 0
    assert {path: path.stat().st_mtime_ns for path in world.cache.iterdir()} == before
    assert world.calls_of_bench() == 1
    assert capsys.readouterr().out == "2 meshes: 2 there already, 0 fetched, 0 missing\n"


def test_only_what_is_named_is_fetched(world: World) -> None:
    world.meshes = [generated("g"), generated("h")]
    assert world.fetch("h") == 0
    assert world.cached() == ["h.ply", "h.ply.recipe.json"]


def test_changed_parameters_make_the_mesh_anew(world: World) -> None:
    world.meshes = [generated("g", size=4)]
    world.fetch()
    world.meshes = [generated("g", size=5)]
    assert world.fetch() == 0
    assert (world.cache / "g.ply").read_text() == "grid --size=5\n"


def test_changed_parameters_are_noticed_when_the_hash_was_not_updated(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [generated("g", size=4)]
    world.fetch()
    world.meshes[0]["parameters"]["size"] = 5
    assert world.fetch() == 3
    assert f"the manifest says {world.meshes[0]['sha256']}" in capsys.readouterr().err


def test_a_damaged_file_in_the_cache_is_replaced(world: World) -> None:
    world.put("site/a.obj", TRIANGLE)
    world.meshes = [downloaded("a", "site/a.obj", TRIANGLE)]
    world.fetch()
    (world.cache / "a.obj").write_bytes(TRIANGLE[:-5])
    assert world.fetch() == 0
    assert (world.cache / "a.obj").read_bytes() == TRIANGLE


def test_a_tampered_file_is_not_used_and_the_rest_goes_on(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put("site/a.obj", TRIANGLE + b"# more\n")
    world.meshes = [downloaded("a", "site/a.obj", TRIANGLE), generated("g")]
    assert world.fetch() == 3
    assert world.cached() == ["g.ply", "g.ply.recipe.json"]
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 1
    assert lines[0].startswith("a: missing: ")
    assert sha256(TRIANGLE) in lines[0] and sha256(TRIANGLE + b"# more\n") in lines[0]


def test_a_file_missing_from_the_mirror_has_one_line(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [downloaded("a", "site/a.obj", TRIANGLE)]
    assert world.fetch() == 3
    expected = f"a: missing: is not in the mirror: there is no {world.mirror}/site/a.obj\n"
    assert capsys.readouterr().err == expected
    assert world.cached() == []


def test_without_a_mirror_the_line_says_how_to_set_it(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [downloaded("a", "site/a.obj", TRIANGLE), generated("g")]
    assert world.fetch(mirror=False) == 3
    assert "set GEODESIC_DATASETS_MIRROR to a folder" in capsys.readouterr().err
    assert (world.cache / "g.ply").exists()


def zipped(world: World, members: dict[str, bytes], member: str = "a.obj") -> None:
    archive = world.zip_of(members)
    world.put("site/a.zip", archive)
    world.meshes = [
        downloaded(
            "a", "site/a.zip", archive, archive_member=member, member_sha256=sha256(TRIANGLE)
        )
    ]


def test_only_the_named_member_leaves_an_archive(world: World) -> None:
    absolute = str(world.cache.parent / "evil.obj")
    names = ["../evil.obj", "b/../../evil.obj", absolute]
    zipped(world, {**dict.fromkeys(names, b"x"), "a.obj": TRIANGLE})
    assert world.fetch() == 0
    assert world.cached() == ["a.obj"]
    assert not list(world.cache.parent.glob("**/evil.obj"))


def test_a_member_whose_name_points_outside_still_lands_in_the_cache(world: World) -> None:
    zipped(world, {"../../a.obj": TRIANGLE}, member="../../a.obj")
    assert world.fetch() == 0
    assert (world.cache / "a.obj").read_bytes() == TRIANGLE


@pytest.mark.parametrize(
    ("members", "message"),
    [
        ({"b.obj": TRIANGLE}, "the archive holds no a.obj"),
        ({"a.obj": TRIANGLE + b"#"}, "a.obj in upstream-a.zip has sha256"),
    ],
)
def test_an_archive_with_a_wrong_member_is_not_used(
    world: World, members: dict[str, bytes], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    zipped(world, members)
    assert world.fetch() == 3
    assert message in capsys.readouterr().err
    assert world.cached() == []


def test_what_is_no_archive_has_its_line(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put("site/a.zip", TRIANGLE)
    member = {"archive_member": "a.obj", "member_sha256": sha256(TRIANGLE)}
    world.meshes = [downloaded("a", "site/a.zip", TRIANGLE, **member)]
    assert world.fetch() == 3
    assert "the archive cannot be read" in capsys.readouterr().err


def test_a_generator_that_fails_gives_its_line(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [generated("g", generator="broken"), generated("h")]
    assert world.fetch() == 3
    assert "g: missing: could not be generated: geodesic-bench: no such thing" in (
        capsys.readouterr().err
    )
    assert "h.ply" in world.cached()


def test_a_program_that_is_not_there_is_named(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [generated("g")]
    assert world.fetch(bench=world.bench.with_name("no bench")) == 3
    assert "which is not at" in capsys.readouterr().err


def test_unknown_names_are_errors_that_list_the_known(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [generated("g")]
    assert world.fetch("x") == 1
    assert capsys.readouterr().err == "fetch.py: no mesh 'x'; there are: g\n"
    assert world.fetch("--corpus", "x") == 1
    assert capsys.readouterr().err == "fetch.py: no corpus 'x'; there are: all\n"


def test_a_cache_that_cannot_be_made_is_one_line(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [generated("g"), generated("h")]
    world.cache.write_text("a file where the folder should be")
    assert world.fetch() == 1
    err = capsys.readouterr().err
    assert err.startswith(f"fetch.py: cannot write to the dataset cache {world.cache}")
    assert len(err.splitlines()) == 1


@pytest.mark.skipif(os.geteuid() == 0, reason="permissions do not bind root")
def test_a_read_only_cache_is_one_line_and_stays_usable(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [generated("g")]
    world.fetch()
    world.cache.chmod(0o555)
    try:
        assert world.fetch() == 0
        world.meshes.append(generated("h"))
        capsys.readouterr()
        assert world.fetch() == 1
        assert "cannot write to the dataset cache" in capsys.readouterr().err
    finally:
        world.cache.chmod(0o755)
    assert world.cached() == ["g.ply", "g.ply.recipe.json"]
