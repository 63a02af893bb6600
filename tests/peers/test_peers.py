"""Peers: the messages for peers that cannot be built, and peers with faults."""

from __future__ import annotations

import fcntl
import json
import re
import subprocess
import zlib
from pathlib import Path

import pytest
from peer_world import HEADER, PeerWorld

from results.console import ROOT


@pytest.fixture
def world(tmp_path: Path, bench: Path) -> PeerWorld:
    return PeerWorld(tmp_path, bench)


MISSING: dict[str, tuple[dict[str, str], str]] = {
    "no-commit": ({"commit": "f" * 40}, f"upload-pack: not our ref {'f' * 40}: check the network"),
    "no-package": (
        {"packages": "lib-of-nobody-dev"},
        "needs lib-of-nobody-dev: apt-get install --no-install-recommends lib-of-nobody-dev (",
    ),
    "broken": ({"adapter": '#include "missing.h"\n'}, "does not compile with -O1: "),
}
"""Faults of a peer, and the reason in the output, by the name of the peer."""


def test_a_peer_that_cannot_be_had_is_one_line_with_the_reason(world: PeerWorld) -> None:
    for name, (wrong, _) in MISSING.items():
        world.add(name, **wrong)
    ended = world.build(*MISSING)
    assert (ended.returncode, ended.stderr) == (3, ""), ended.stdout
    *lines, count = ended.stdout.splitlines()
    assert count == f"{len(MISSING)} peers: 0 built, {len(MISSING)} missing"
    for line, (name, (_, reason)) in zip(lines, MISSING.items(), strict=True):
        assert line.startswith(f"{name}: missing: ") and reason in line
        assert not (world.built / name / f"lib{name}.so").exists()


def test_a_file_that_differs_from_the_commit_is_refused(world: PeerWorld) -> None:
    git = ["git", "-C", str(world.mirror / "somebody" / "codes")]
    pinned = subprocess.check_output([*git, "rev-parse", f"HEAD:{HEADER}"], text=True).strip()
    stored = world.mirror / "somebody/codes/.git/objects" / pinned[:2] / pinned[2:]
    stored.chmod(0o644)
    stored.write_bytes(zlib.compress(b"blob 5\0other"))
    ended = world.build("fake")
    assert ended.returncode == 3
    line, _ = ended.stdout.splitlines()
    assert line.startswith("fake: missing: cannot fetch its sources: ") and pinned in line


@pytest.mark.parametrize("mirror", ["http://127.0.0.1:9", "/no/such/folder"])
def test_without_a_network_a_peer_is_one_line_and_fails_nothing_if_all_are_asked_for(
    world: PeerWorld, mirror: str
) -> None:
    ended = world.build(mirror=mirror)
    assert ended.returncode == 0
    line, _ = ended.stdout.splitlines()
    assert line.startswith("fake: missing: cannot fetch its sources: ")
    assert f"{mirror}/somebody/codes" in line
    assert ": check the network or the mirror (GEODESIC_PEERS_MIRROR) (" in line


def test_a_folder_in_place_of_the_repository_is_compiled_as_it_is(world: PeerWorld) -> None:
    own = world.peers / "own"
    own.mkdir()
    (own / HEADER).write_text("#error of one's own\n")
    line, _ = world.build("fake", "-D", f"FETCHCONTENT_SOURCE_DIR_CODES={own}").stdout.splitlines()
    assert line.startswith("fake: missing: does not compile with -O1: ") and "of one's own" in line


def test_only_one_process_at_a_time_builds_in_a_folder(world: PeerWorld) -> None:
    world.built.mkdir(exist_ok=True)
    with (world.built / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        ended = world.build("fake")
    assert ended.returncode == 1
    wait = f"another process builds peers in {world.built}: wait for its end"
    assert ended.stderr == f"peers/build.py: {wait}\n"


def test_an_unknown_name_is_an_error(world: PeerWorld) -> None:
    ended = world.build("nobody")
    assert ended.returncode == 1
    assert ended.stderr == "peers/build.py: no peer named 'nobody'; there are: fake\n"


def test_a_peer_that_misbehaves_is_a_row_and_costs_no_other_cell(world: PeerWorld) -> None:
    assert world.build("fake").returncode == 0
    assert world.build("fake").stdout.splitlines()[0] == "fake: there already"

    mesh = world.peers / "triangle.obj"
    mesh.write_text("v 0 0 0\nv 3 0 0\nv 0 4 0\nf 1 2 3\n")
    out = world.built / "run"
    solvers = "talks,crashes,hangs,eats,leaves"
    ended = world.run(
        "run", "--meshes", str(mesh), "--solvers", solvers, "--sources", "1", "--repetitions", "1",
        "--time-limit", "3", "--memory-limit", "300M", "--out", str(out),
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
    assert listed["remarks"] == (
        "a test's; compiled with its authors' flags, -O1 "
        "(speed not compared: fails on a small mesh: exit code -11)"
    )


def test_words_run_the_peers_beside_other_solvers(world: PeerWorld) -> None:
    ended = world.build("--words", "mmp", "fake")
    assert ended.returncode == 1 and "build it (./run_all.sh peers)" in ended.stderr
    world.plugin.parent.mkdir(parents=True)
    world.plugin.touch()
    ended = world.build("--words", "mmp", "fake")
    assert ended.returncode == 1 and "plug-in" in ended.stderr


def test_the_scripts_install_every_package_that_a_peer_needs() -> None:
    listed = {line.split()[0] for line in (ROOT / "tools" / "packages.txt").read_text().splitlines()}
    files = [ROOT / "peers" / "peer.cmake", *(ROOT / "peers").glob("*/CMakeLists.txt")]
    needs = [re.findall(r"^ *peer_needs\((.+)\)", file.read_text(), re.MULTILINE) for file in files]
    needed = {package for found in needs for words in found for package in words.split()}
    assert "git" in needed and needed <= listed
