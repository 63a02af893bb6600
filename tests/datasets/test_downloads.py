"""Fetching over HTTP, from a site on this machine that behaves well or badly."""

from __future__ import annotations

import random
import signal
import socket
from pathlib import Path

import pytest
from fetch_world import TRIANGLE, World, generated, sha256, wait_for
from fetching import download
from http_site import Site

LARGE = random.Random(1).randbytes(5 << 20)  # more than one piece of a download


def part_of(world: World, data: bytes) -> Path:
    return world.cache / ".fetch" / "parts" / f"{sha256(data)}.part"


def put_part(world: World, data: bytes, contents: bytes) -> None:
    part_of(world, data).parent.mkdir(parents=True)
    part_of(world, data).write_bytes(contents)


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
    world: World, site: Site, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("large", LARGE)
    site.cut_after, site.with_length = 3_000_000, False
    assert world.fetch(mirror=site.url) == 3
    assert "has sha256" in capsys.readouterr().err
    assert (world.cached(), world.leftovers()) == ([], [])


def test_a_site_that_cannot_go_on_sends_all_again(world: World, site: Site) -> None:
    world.put_mesh("large", LARGE)
    put_part(world, LARGE, LARGE[:1000])
    site.ranges = False
    assert world.fetch(mirror=site.url) == 0
    assert (world.cache / "large.obj").read_bytes() == LARGE
    assert site.asked == ["/site/large.obj bytes=1000-"]


@pytest.mark.parametrize(
    "beginning", [b"of another file", LARGE + b"longer", b"x" * len(LARGE)], ids=len
)
def test_a_wrong_beginning_is_thrown_away(world: World, site: Site, beginning: bytes) -> None:
    world.put_mesh("large", LARGE)
    put_part(world, LARGE, beginning)
    assert world.fetch(mirror=site.url) == 0
    assert (world.cache / "large.obj").read_bytes() == LARGE
    assert site.asked == [f"/site/large.obj bytes={len(beginning)}-", "/site/large.obj"]


def test_another_range_than_the_wanted_is_not_used(world: World, site: Site) -> None:
    world.put_mesh("large", LARGE)
    put_part(world, LARGE, LARGE[:1000])
    site.shifted = True
    assert world.fetch(mirror=site.url) == 0
    assert (world.cache / "large.obj").read_bytes() == LARGE


def test_a_whole_download_that_was_not_used_yet_is_not_asked_for_again(
    world: World, site: Site
) -> None:
    world.put_mesh("a")
    put_part(world, TRIANGLE, TRIANGLE)
    assert world.fetch(mirror=site.url) == 0
    assert (site.asked, world.leftovers()) == ([], [])


def test_a_tampered_download_is_removed(
    world: World, site: Site, capsys: pytest.CaptureFixture[str]
) -> None:
    tampered = TRIANGLE + b"# more\n"
    world.put_mesh("a").write_bytes(tampered)
    world.meshes.append(generated("g"))
    assert world.fetch(mirror=site.url) == 3
    assert capsys.readouterr().err == (
        f"a: missing: {site.url}/site/a.obj has sha256 {sha256(tampered)}, "
        f"the manifest says {sha256(TRIANGLE)}: not used\n"
    )
    assert (world.cached(), world.leftovers()) == (["g.ply", "g.ply.recipe.json"], [])


@pytest.mark.parametrize(
    ("status", "message"),
    [(404, "is no longer at {} (404 Not Found)"), (503, "{} answers 503 Service Unavailable")],
)
def test_an_address_without_the_file_is_one_line(
    world: World, site: Site, status: int, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("a")
    site.status = status
    assert world.fetch(mirror=site.url) == 3
    err = capsys.readouterr().err
    assert err.startswith(f"a: missing: {message.format(f'{site.url}/site/a.obj')}")
    assert len(err.splitlines()) == 1
    assert (world.cached(), world.leftovers()) == ([], [])


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
    world: World, site: Site, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("large", LARGE)
    monkeypatch.setattr(download, "MAX_BYTES", 2 << 20)
    assert world.fetch(mirror=site.url) == 3
    assert "has more than 2097152 bytes: not used" in capsys.readouterr().err
    assert (world.cached(), world.leftovers()) == ([], [])


def test_no_site_at_the_address_is_one_line_a_mesh(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("a")
    world.put_mesh("b")
    with socket.create_server(("127.0.0.1", 0)) as unused:
        address = f"127.0.0.1:{unused.getsockname()[1]}"
    assert world.fetch(mirror=f"http://{address}") == 3
    lines = capsys.readouterr().err.splitlines()
    assert [line.split(" (")[0] for line in lines] == [
        f"{name}: missing: cannot reach {address}" for name in "ab"
    ]
    assert "Connection refused" in lines[0]
