"""Peers: their descriptions, what is said of one that cannot be had, and one that misbehaves."""

from __future__ import annotations

import json
import os
from pathlib import Path

import jsonschema
import pytest
from peer_world import ROOT, PeerWorld

SCHEMA = jsonschema.Draft202012Validator(
    json.loads((ROOT / "peers" / "peer.schema.json").read_text("utf-8"))
)
FOLDERS = sorted(file.parent for file in ROOT.glob("peers/*/peer.json"))


@pytest.fixture(scope="session")
def bench() -> Path:
    program = os.environ.get("GEODESIC_BENCH")
    if program is None:
        pytest.skip("GEODESIC_BENCH names no program; ./run_tests.sh sets it")
    return Path(program).resolve()


@pytest.fixture
def world(tmp_path: Path, bench: Path) -> PeerWorld:
    return PeerWorld(tmp_path, bench)


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_the_description_keeps_its_schema_and_the_folder_has_an_adapter(folder: Path) -> None:
    SCHEMA.check_schema(SCHEMA.schema)
    SCHEMA.validate(json.loads((folder / "peer.json").read_text("utf-8")))
    assert (folder / "adapter.cpp").is_file()
    assert f"geodesic_add_peer({folder.name} " in (folder / "CMakeLists.txt").read_text("utf-8")


def said_of_fake(world: PeerWorld, mirror: str | None = None) -> str:
    """The line about the peer, which is named and missing."""
    ended = world.build("fake", mirror=mirror)
    assert ended.returncode == 3, ended.stdout + ended.stderr
    line, count = ended.stdout.splitlines()
    assert count == "1 peers: 0 built, 1 missing" and ended.stderr == ""
    assert not world.plugin.exists()
    return line


def test_a_file_with_another_sum_is_not_compiled(world: PeerWorld) -> None:
    world.describe_repository(files={"authors.h": "0" * 64})
    assert said_of_fake(world).startswith("fake: missing: authors.h of somebody/codes has sha256 ")


def test_a_file_that_the_archive_lacks_is_named(world: PeerWorld) -> None:
    world.describe_repository(files={"other.h": "0" * 64})
    assert "holds no codes-0123456789" in said_of_fake(world)


def test_an_edit_that_matches_nothing_is_named(world: PeerWorld) -> None:
    edit = {"file": "authors.h", "pattern": r"no\w+here", "replacement": "", "why": "a test"}
    world.describe_repository(edits=[edit])
    assert said_of_fake(world).startswith(
        "fake: missing: the edit 'no\\\\w+here' matches nothing in authors.h"
    )


def test_a_peer_that_the_mirror_lacks_is_one_line(world: PeerWorld) -> None:
    world.archive.unlink()
    assert said_of_fake(world) == (
        f"fake: missing: is not in the mirror: there is no {world.archive}"
    )


def test_without_a_network_a_peer_is_one_line(world: PeerWorld) -> None:
    assert said_of_fake(world, mirror="http://127.0.0.1:9").startswith(
        "fake: missing: cannot reach 127.0.0.1:9 (Connection refused): check the network, "
        "or set GEODESIC_PEERS_MIRROR"
    )


def test_a_missing_package_is_named_with_the_line_that_installs_it(world: PeerWorld) -> None:
    world.describe(packages=["lib-of-nobody-dev"])
    assert said_of_fake(world) == (
        "fake: missing: needs lib-of-nobody-dev: apt-get install --no-install-recommends "
        "lib-of-nobody-dev"
    )


def test_a_peer_that_does_not_compile_is_one_line(world: PeerWorld) -> None:
    (world.fake / "adapter.cpp").write_text('#include "missing.h"\n')
    assert said_of_fake(world).startswith("fake: missing: does not compile with -O1: ")


def test_what_is_missing_fails_nothing_when_all_are_asked_for(world: PeerWorld) -> None:
    world.archive.unlink()
    assert world.build().returncode == 0


def test_a_broken_description_and_an_unknown_name_are_errors(world: PeerWorld) -> None:
    ended = world.build("nobody")
    assert ended.returncode == 1
    assert ended.stderr == "peers/build.py: no peer named 'nobody'; there are: fake\n"
    world.describe_repository(commit="main")
    ended = world.build("fake")
    assert ended.returncode == 1
    assert "peer.json: upstream/0/commit: 'main' does not match" in ended.stderr


def test_a_peer_that_misbehaves_is_a_row_and_costs_no_other_cell(world: PeerWorld) -> None:
    assert world.build("fake").returncode == 0
    assert world.build("fake").stdout.splitlines()[0] == "fake: there already"

    mesh = world.peers / "triangle.obj"
    mesh.write_text("v 0 0 0\nv 3 0 0\nv 0 4 0\nf 1 2 3\n")
    out = world.built / "run"
    solvers = "talks,crashes,hangs,eats,leaves"
    ended = world.run(
        "run", "--meshes", str(mesh), "--solvers", solvers, "--sources", "1", "--repetitions", "1",
        "--time-limit", "5", "--memory-limit", "1G", "--out", str(out),
    )  # fmt: skip
    rows = json.loads((out / "run.json").read_text())["benchmarks"]
    assert {row["solver"]: row["outcome"] for row in rows} == {
        "talks": "ok",
        "crashes": "crashed",
        "hangs": "time-out",
        "eats": "out of memory",
        "leaves": "error",
    }
    assert ended.returncode == 1
    assert "noise" not in ended.stdout

    (listed,) = [
        solver
        for solver in json.loads(world.run("list", "--json").stdout)["solvers"]
        if solver["name"] == "talks"
    ]
    assert listed["remarks"] == "a test's; compiled with its authors' flags, which are ours, -O1"


def test_words_run_the_peers_beside_other_solvers(world: PeerWorld) -> None:
    ended = world.build("--words", "mmp", "fake")
    assert ended.returncode == 1 and "build it (./run_all.sh peers)" in ended.stderr
    world.plugin.parent.mkdir(parents=True)
    world.plugin.touch()
    ended = world.build("--words", "mmp", "fake")
    assert ended.returncode == 1 and "plug-in" in ended.stderr
