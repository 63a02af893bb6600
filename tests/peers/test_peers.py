"""Peers: their descriptions, the messages for peers that cannot be built, and peers with faults."""

from __future__ import annotations

import json
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any

import jsonschema
import pytest
from peer_world import COMMIT, HEADER, ROOT, PeerWorld

SCHEMA = jsonschema.Draft202012Validator(
    json.loads((ROOT / "peers" / "peer.schema.json").read_text("utf-8"))
)
FOLDERS = sorted(file.parent for file in ROOT.glob("peers/*/peer.json"))


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *args: object) -> None:
        pass


@pytest.fixture
def world(tmp_path: Path, bench: Path) -> PeerWorld:
    return PeerWorld(tmp_path, bench)


@pytest.mark.parametrize("folder", FOLDERS, ids=[folder.name for folder in FOLDERS])
def test_the_description_keeps_its_schema_and_the_folder_has_an_adapter(folder: Path) -> None:
    SCHEMA.check_schema(SCHEMA.schema)
    SCHEMA.validate(json.loads((folder / "peer.json").read_text("utf-8")))
    assert (folder / "adapter.cpp").is_file()
    assert f"geodesic_add_peer({folder.name} " in (folder / "CMakeLists.txt").read_text("utf-8")


EDIT = {"file": HEADER, "pattern": r"no\w+here", "replacement": "", "why": "a test"}
MISSING: dict[str, tuple[dict[str, Any], str]] = {
    "another-sum": ({"files": {HEADER: "0" * 64}}, "authors.h of somebody/codes has sha256 "),
    "no-file": ({"files": {"no.h": "0" * 64}}, f"{COMMIT}.tar.gz holds no codes-{COMMIT}/no.h"),
    "edit": ({"edits": [EDIT]}, r"the edit 'no\\w+here' matches nothing in authors.h"),
    "no-archive": ({"commit": "f" * 40}, "is not in the mirror: there is no "),
    "no-package": (
        {"packages": ["lib-of-nobody-dev"]},
        "needs lib-of-nobody-dev: apt-get install --no-install-recommends lib-of-nobody-dev",
    ),
    "broken": ({"adapter": '#include "missing.h"\n'}, "does not compile with -O1: "),
}
"""Faults of a peer, and the beginning of the reason in the output, by the name of the peer."""


def test_a_peer_that_cannot_be_had_is_one_line_with_the_reason(world: PeerWorld) -> None:
    for name, (wrong, _) in MISSING.items():
        world.add(name, **wrong)
    ended = world.build(*MISSING)
    assert (ended.returncode, ended.stderr) == (3, ""), ended.stdout
    *lines, count = ended.stdout.splitlines()
    assert count == f"{len(MISSING)} peers: 0 built, {len(MISSING)} missing"
    for line, (name, (_, reason)) in zip(lines, MISSING.items(), strict=True):
        assert line.startswith(f"{name}: missing: {reason}")
        assert not (world.built / name / f"lib{name}.so").exists()


def test_an_archive_that_was_not_the_right_one_is_downloaded_again(
    world: PeerWorld, monkeypatch: pytest.MonkeyPatch
) -> None:
    world.add("fake", files={HEADER: 64 * "0"})  # so that nothing is compiled
    (archive,) = world.mirror.rglob("*.tar.gz")
    right = archive.read_bytes()
    archive.write_bytes(b"<html>please log in</html>")
    monkeypatch.setenv("NO_PROXY", "127.0.0.1")
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=world.mirror)) as site:
        Thread(target=site.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{site.server_port}"
        assert "cannot be unpacked" in world.build("fake", mirror=address).stdout
        archive.write_bytes(right)
        assert f"{HEADER} of somebody/codes" in world.build("fake", mirror=address).stdout
        site.shutdown()


def test_without_a_network_a_peer_is_one_line_and_fails_nothing_if_all_are_asked_for(
    world: PeerWorld,
) -> None:
    ended = world.build(mirror="http://127.0.0.1:9")
    assert ended.returncode == 0
    assert ended.stdout.startswith(
        "fake: missing: cannot reach 127.0.0.1:9 (Connection refused): check the network, "
        "or set GEODESIC_PEERS_MIRROR"
    )


def test_a_broken_description_and_an_unknown_name_are_errors(world: PeerWorld) -> None:
    ended = world.build("nobody")
    assert ended.returncode == 1
    assert ended.stderr == "peers/build.py: no peer named 'nobody'; there are: fake\n"
    world.add("fake", commit="main")
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
    assert listed["remarks"] == "a test's; compiled with its authors' flags, which are ours, -O1"


def test_words_run_the_peers_beside_other_solvers(world: PeerWorld) -> None:
    ended = world.build("--words", "mmp", "fake")
    assert ended.returncode == 1 and "build it (./run_all.sh peers)" in ended.stderr
    world.plugin.parent.mkdir(parents=True)
    world.plugin.touch()
    ended = world.build("--words", "mmp", "fake")
    assert ended.returncode == 1 and "plug-in" in ended.stderr
