"""datasets/fetch.py with a folder as mirror and a program made by the test. tests/bad_inputs has the bad
command lines and environments."""

from __future__ import annotations

import os
import resource
import signal
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import fetch
import pytest
from fetch_world import LISTING, TRIANGLE, World, derived, generated, wait_for


def test_meshes_are_copied_and_generated_once(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    upstream = world.put_mesh("a")
    world.meshes.append(generated("g"))
    assert world.fetch() == 0
    assert (world.cache / "a.obj").read_bytes() == TRIANGLE
    assert (world.cache / "g.ply").read_text() == "grid --size=4\n"
    assert world.cached() == ["a.obj", "g.ply", "g.ply.recipe.json"]
    before = {path: path.stat().st_mtime_ns for path in world.cache.iterdir()}
    upstream.unlink()
    capsys.readouterr()
    assert world.fetch(mirror=None) == 0
    assert {path: path.stat().st_mtime_ns for path in world.cache.iterdir()} == before
    assert world.calls_of_bench() == 1
    assert capsys.readouterr().out == "2 meshes: 2 there already, 0 fetched, 0 missing\n"


def test_only_what_is_named_is_fetched(world: World) -> None:
    world.meshes = [generated("g"), generated("h")]
    assert world.fetch("h") == 0
    assert world.cached() == ["h.ply", "h.ply.recipe.json"]


def test_changed_parameters_make_the_mesh_anew(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [generated("g", size=4)]
    world.fetch()
    world.meshes[0]["parameters"]["size"] = 5
    assert world.fetch() == 3, "the old file does not count, though its sha256 is still asked for"
    assert f"the manifest says {world.meshes[0]['sha256']}" in capsys.readouterr().err
    world.meshes = [generated("g", size=5)]
    assert world.fetch() == 0
    assert (world.cache / "g.ply").read_text() == "grid --size=5\n"


def test_a_damaged_file_in_the_cache_is_replaced(world: World) -> None:
    world.put_mesh("a")
    world.fetch()
    (world.cache / "a.obj").write_bytes(TRIANGLE[:-5])
    assert world.fetch() == 0
    assert (world.cache / "a.obj").read_bytes() == TRIANGLE


@pytest.mark.parametrize("host", ["", "localhost"])
def test_the_mirror_can_be_a_file_address(world: World, host: str) -> None:
    world.mirror = world.folder / "a mirror"
    world.put_mesh("a")
    assert world.fetch(mirror=f"file://{host}{world.folder}/a%20mirror") == 0
    assert (world.cache / "a.obj").read_bytes() == TRIANGLE


@pytest.mark.parametrize("address", ["ftp://host/x", "file://host/x", "s3://bucket"])
def test_an_address_that_is_no_mirror_is_an_error(
    world: World, address: str, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("a")
    assert world.fetch(mirror=address) == 1
    assert capsys.readouterr().err.startswith(
        f"fetch.py: GEODESIC_DATASETS_MIRROR is {address}: it must be a folder, or an address"
    )


def test_a_generator_that_fails_gives_its_line(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [generated("g", generator="broken"), generated("h")]
    assert world.fetch() == 3
    assert "g: missing: could not be generated: geodesic-bench: no such thing" in (
        capsys.readouterr().err
    )
    assert "h.ply" in world.cached()


@contextmanager
def without_root() -> Iterator[None]:
    """Runs the block as the user nobody if the user is root, because permissions do not restrict root."""
    user = os.geteuid()
    if user == 0:
        os.seteuid(65534)
    try:
        yield
    finally:
        os.seteuid(user)


@pytest.mark.usefixtures("world")
def test_a_read_only_cache_is_one_line_and_stays_usable(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o755)  # all users may read it
        world = World(folder)
        world.meshes = [generated("g")]
        assert world.fetch() == 0
        world.cache.chmod(0o555)
        words = world.words()
        with without_root():
            assert fetch.main(words) == 0, "what is there needs no writing"
        assert capsys.readouterr().err == ""
        world.meshes += [generated("h"), generated("i")]
        words = world.words()
        with without_root():
            assert fetch.main(words) == 1
        world.cache.chmod(0o755)
        err = capsys.readouterr().err
        assert err.startswith(
            f"fetch.py: cannot write to the dataset cache {world.cache} (Permission denied: "
        )
        assert len(err.splitlines()) == 1
        assert world.cached() == ["g.ply", "g.ply.recipe.json"]


def test_a_full_disk_costs_only_the_meshes_that_do_not_fit(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("large", TRIANGLE * 10_000)
    world.put_mesh("small")
    # A limit on the size of a file makes write() fail, as on a full disk.
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, limits[1]))
    try:
        assert world.fetch() == 3
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    err = capsys.readouterr().err
    assert err.startswith("large: missing: File too large") and len(err.splitlines()) == 1
    assert (world.cached(), world.leftovers()) == (["small.obj"], [])
    assert world.fetch() == 0


def test_a_mesh_is_made_after_its_input_which_need_not_be_asked_for(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("a")
    half = TRIANGLE + b"cut --size=4\n"
    world.meshes += [derived("b", "a", TRIANGLE), derived("c", "b", half)]
    assert world.fetch("c", "b") == 0
    assert (world.cache / "c.ply").read_bytes() == half + b"cut --size=4\n"
    lines = capsys.readouterr().out.splitlines()
    assert [line.split(":")[0] for line in lines[:3]] == ["a", "b", "c"]
    assert lines[3] == "2 meshes: 0 there already, 2 fetched, 0 missing"


def test_inputs_are_not_needed_any_more_when_the_mesh_is_there(world: World) -> None:
    upstream = world.put_mesh("a")
    world.meshes.append(derived("b", "a", TRIANGLE))
    world.fetch("b")
    upstream.unlink()
    (world.cache / "a.obj").unlink()
    assert world.fetch("b") == 0
    assert world.cached() == ["b.ply", "b.ply.recipe.json"]


def test_a_changed_input_makes_the_mesh_anew(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("a")
    world.meshes.append(derived("b", "a", TRIANGLE))
    world.fetch()
    changed = TRIANGLE + b"# more\n"
    stale = world.meshes[1]
    world.meshes = []
    world.put_mesh("a", changed)
    world.meshes.append(stale)
    assert world.fetch() == 3, "the old file does not count, though its sha256 is still asked for"
    assert f"the manifest says {stale['sha256']}: not used" in capsys.readouterr().err
    world.meshes[1] = derived("b", "a", changed)
    assert world.fetch() == 0
    assert (world.cache / "b.ply").read_bytes() == changed + b"cut --size=4\n"


def test_a_missing_input_is_named_with_its_reason(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("a").unlink()
    world.meshes.append(derived("b", "a", TRIANGLE))
    assert world.fetch() == 3
    reason = f"is not in the mirror: there is no {world.mirror}/site/a.obj"
    assert capsys.readouterr().err.splitlines() == [
        f"a: missing: {reason}",
        f"b: missing: needs a, which is missing: {reason}",
    ]
    assert (world.cached(), world.calls_of_bench()) == ([], 0)


def test_an_elevation_grid_is_an_input_like_a_mesh(world: World) -> None:
    world.add_grid("heights", b"\x93NUMPY")
    world.meshes = [derived("b", "heights", b"\x93NUMPY")]
    assert world.fetch() == 0
    assert world.cached() == ["b.ply", "b.ply.recipe.json", "heights.npy"]
    assert world.fetch("heights") == 0


# While it makes the mesh, it waits for the file "go" in its folder, for a limited time.
SLOW_BENCH = LISTING + """
here=$(dirname "$0")
echo half > "$last"
i=0
until [ -e "$here/go" ] || [ $((i += 1)) -gt 2000 ]; do sleep 0.01; done
echo "$2 $3" > "$last"
"""


def generating(world: World) -> subprocess.Popen[str]:
    """Starts a fetch that makes the mesh g. It ends when the file "go" exists."""
    world.meshes = [generated("g")]
    world.bench.write_text(SLOW_BENCH)
    process = world.start()
    wait_for((world.folder / "calls").exists, "generating")
    return process


def test_of_two_fetches_at_once_the_second_waits_and_finds_the_mesh(world: World) -> None:
    first = generating(world)
    second = world.start()
    assert second.stdout is not None
    assert second.stdout.readline() == "g: waiting for another fetch that is at it\n"
    (world.folder / "go").touch()
    out = [process.communicate(timeout=60) for process in (first, second)]
    assert (first.returncode, second.returncode) == (0, 0), out
    assert "1 fetched" in out[0][0] and "1 there already" in out[1][0]
    assert world.calls_of_bench() == 1
    assert (world.cache / "g.ply").read_text() == "grid --size=4\n"


def test_control_c_is_one_line_and_leaves_nothing_unfinished(world: World) -> None:
    process = generating(world)
    process.send_signal(signal.SIGINT)
    (world.folder / "go").touch()
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert err == "fetch.py: interrupted; what is in the cache is whole, and the next fetch continues\n"
    assert (world.cached(), world.leftovers()) == ([], [])
    assert world.fetch() == 0


def test_what_a_killed_fetch_left_is_not_taken_for_the_mesh(world: World) -> None:
    process = generating(world)
    process.kill()
    process.communicate(timeout=60)
    (world.folder / "go").touch()
    assert world.cached() == []
    assert world.fetch() == 0
    assert (world.cached(), world.leftovers()) == (["g.ply", "g.ply.recipe.json"], [])
