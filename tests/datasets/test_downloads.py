"""Fetching over HTTP from a server on this machine, with or without faults."""

from __future__ import annotations

import random
import signal
import socket
from pathlib import Path

import pytest
from fetch_world import TRIANGLE, Missing, World, generated, sha256, wait_for
from fetching import download
from http_site import Site

LARGE = random.Random(1).randbytes(5 << 20)  # more than one piece of a download


def part_of(world: World, data: bytes) -> Path:
    return world.cache / ".fetch" / "parts" / f"{sha256(data)}.part"


def test_a_folder_and_a_site_fill_the_cache_alike(world: World, site: Site) -> None:
    world.put_mesh("a")
    world.put_mesh("large", LARGE)
    assert world.fetch() == 0
    from_folder = {name: (world.cache / name).read_bytes() for name in world.cached()}
    world.cache = world.folder / "another cache"
    assert world.fetch(mirror=f"{site.url}/") == 0
    assert {name: (world.cache / name).read_bytes() for name in world.cached()} == from_folder
    assert world.leftovers() == []
    assert site.asked == ["/site/a.obj", "/site/large.obj"]


def test_without_a_mirror_the_upstream_address_is_asked(
    world: World, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("a")
    world.put_mesh("b")
    world.meshes.append(generated("g"))
    looked_up = []

    def no_network(host: str, *_: object, **__: object) -> None:
        looked_up.append(host)
        raise socket.gaierror(socket.EAI_NONAME, "Name or service not known")

    monkeypatch.setattr(socket, "getaddrinfo", no_network)
    for variable in ["HTTPS_PROXY", "https_proxy", "ALL_PROXY", "all_proxy"]:
        monkeypatch.delenv(variable, raising=False)
    assert world.fetch(mirror=None) == 3
    line = (
        "missing: cannot reach example.org (Name or service not known): check the network, "
        "or set GEODESIC_DATASETS_MIRROR to a mirror"
    )
    assert capsys.readouterr().err.splitlines() == [f"a: {line}", f"b: {line}"]
    assert looked_up == ["example.org"], "a host that cannot be reached is asked once"
    assert world.cached() == ["g.ply", "g.ply.recipe.json"]


def test_a_truncated_download_does_not_count_and_goes_on(
    world: World, site: Site, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("large", LARGE)
    site.cut_after = 3_000_000
    assert world.fetch(mirror=site.url) == 3
    err = capsys.readouterr().err
    assert f"broke off after 3000000 of {len(LARGE)} bytes" in err and len(err.splitlines()) == 1
    assert world.cached() == []
    assert part_of(world, LARGE).read_bytes() == LARGE[:3_000_000]
    site.cut_after = None
    assert world.fetch(mirror=site.url) == 0
    assert (world.cache / "large.obj").read_bytes() == LARGE
    assert world.leftovers() == []
    assert site.asked == ["/site/large.obj", "/site/large.obj bytes=3000000-"]


def test_a_truncated_download_without_a_length_does_not_count(
    world: World, site: Site, missing: Missing
) -> None:
    world.put_mesh("large", LARGE)
    site.cut_after, site.with_length = 3_000_000, False
    assert "has sha256" in missing(site.url)


@pytest.mark.parametrize(
    ("left", "behaviour", "asked"),
    [
        (LARGE, {}, []),
        (LARGE[:1000], {"ranges": False}, [" bytes=1000-"]),
        (LARGE[:1000], {"shifted": True}, [" bytes=1000-", ""]),
        (b"of another file", {}, [" bytes=15-", ""]),
        (LARGE + b"longer", {}, [f" bytes={len(LARGE) + 6}-", ""]),
        (b"x" * len(LARGE), {}, [f" bytes={len(LARGE)}-", ""]),
    ],
    ids=["whole", "without ranges", "another range", "wrong", "longer", "as long and wrong"],
)
def test_what_an_earlier_download_left_is_used_or_thrown_away(
    world: World, site: Site, left: bytes, behaviour: dict[str, bool], asked: list[str]
) -> None:
    world.put_mesh("large", LARGE)
    part_of(world, LARGE).parent.mkdir(parents=True)
    part_of(world, LARGE).write_bytes(left)
    vars(site).update(behaviour)
    assert world.fetch(mirror=site.url) == 0
    assert (world.cache / "large.obj").read_bytes() == LARGE
    assert site.asked == [f"/site/large.obj{range_}" for range_ in asked]
    assert world.leftovers() == []


@pytest.mark.parametrize("over_http", [False, True])
def test_a_tampered_file_is_not_used_and_the_rest_goes_on(
    world: World, site: Site, over_http: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    tampered = TRIANGLE + b"# more\n"
    world.put_mesh("a").write_bytes(tampered)
    world.meshes.append(generated("g"))
    mirror = site.url if over_http else str(world.mirror)
    assert world.fetch(mirror=mirror) == 3
    assert capsys.readouterr().err == (
        f"a: missing: {mirror}/site/a.obj has sha256 {sha256(tampered)}, "
        f"the manifest says {sha256(TRIANGLE)}: not used\n"
    )
    assert (world.cached(), world.leftovers()) == (["g.ply", "g.ply.recipe.json"], [])


@pytest.mark.parametrize(
    ("status", "message"),
    [(404, "is no longer at {} (404 Not Found)"), (503, "{} answers 503 Service Unavailable")],
)
def test_an_address_without_the_file_is_one_line(
    world: World, site: Site, status: int, message: str, missing: Missing
) -> None:
    world.put_mesh("a")
    site.status = status
    assert missing(site.url).startswith(message.format(f"{site.url}/site/a.obj"))


def test_a_silent_site_is_given_up(
    world: World,
    site: Site,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    world.put_mesh("large", LARGE)
    monkeypatch.setattr(download, "TIMEOUTS", (0.5, 0.5))
    site.cut_after, site.stalls = 3 << 20, True
    assert world.fetch(mirror=site.url) == 3
    assert "broke off after " in capsys.readouterr().err
    begun = part_of(world, LARGE).read_bytes()
    assert begun == LARGE[: len(begun)] and begun


def test_an_interrupted_download_goes_on_in_the_next_fetch(world: World, site: Site) -> None:
    world.put_mesh("large", LARGE)
    site.cut_after, site.stalls = 3 << 20, True
    process = world.start(site.url)
    part = part_of(world, LARGE)
    wait_for(lambda: part.exists() and part.stat().st_size >= 1 << 20, "downloading")
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert (process.returncode, len(err.splitlines())) == (130, 1), err
    begun = part.stat().st_size
    site.cut_after, site.stalls = None, False
    assert world.fetch(mirror=site.url) == 0
    assert (world.cache / "large.obj").read_bytes() == LARGE
    assert site.asked[1:] == [f"/site/large.obj bytes={begun}-"]


def test_a_site_that_sends_without_end_is_given_up(
    world: World, site: Site, monkeypatch: pytest.MonkeyPatch, missing: Missing
) -> None:
    world.put_mesh("large", LARGE)
    monkeypatch.setattr(download, "MAX_BYTES", 2 << 20)
    assert missing(site.url).endswith("has more than 2097152 bytes: not used")
