"""datasets/fetch.py against a folder as mirror and a program made by the test."""

from __future__ import annotations

import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from fetch_world import (
    BENCH,
    LISTING,
    TRIANGLE,
    World,
    derived,
    downloaded,
    executable,
    generated,
    sha256,
    wait_for,
)
from fetching.program import ROOT


def test_meshes_are_copied_and_generated(world: World) -> None:
    world.put_mesh("a")
    world.meshes.append(generated("g"))
    assert world.fetch() == 0
    assert (world.cache / "a.obj").read_bytes() == TRIANGLE
    assert (world.cache / "g.ply").read_text() == "grid --size=4\n"
    assert world.cached() == ["a.obj", "g.ply", "g.ply.recipe.json"]


def test_a_second_fetch_does_nothing(world: World, capsys: pytest.CaptureFixture[str]) -> None:
    upstream = world.put_mesh("a")
    world.meshes.append(generated("g"))
    world.fetch()
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
    world.put_mesh("a")
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


def test_a_program_that_is_not_there_is_named(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [generated("g")]
    assert world.fetch(bench=world.bench.with_name("no bench")) == 1
    err = capsys.readouterr().err
    assert err.startswith("fetch.py: geodesic-bench reads the list of meshes and is not at ")
    assert "./run_all.sh build" in err and len(err.splitlines()) == 1


def test_unknown_names_are_errors_that_list_the_known(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [generated("g")]
    assert world.fetch("x") == 1
    assert capsys.readouterr().err == "fetch.py: no mesh named 'x'; there are: g\n"
    assert world.fetch("--corpus", "x") == 1
    assert capsys.readouterr().err == "fetch.py: no corpus named 'x'; there are: all\n"


def test_a_cache_that_cannot_be_made_is_one_line(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.meshes = [generated("g"), generated("h")]
    world.cache.write_text("a file where the folder should be")
    assert world.fetch() == 1
    err = capsys.readouterr().err
    assert err.startswith(f"fetch.py: cannot write to the dataset cache {world.cache}")
    assert len(err.splitlines()) == 1


def run_fetch(world: World, folder: Path, user: int | None) -> subprocess.CompletedProcess[str]:
    """Runs fetch.py, of which `folder` has a copy, as a user (None: as oneself)."""
    command = [sys.executable, str(folder / "datasets" / "fetch.py"), *world.words()]
    return subprocess.run(command, user=user, capture_output=True, text=True, timeout=60)


def list_for_all(world: World) -> None:
    """Puts an answer in place of the program, which others may not be allowed to run."""
    world.write()
    command = [BENCH, "list", "--json", "--manifest", world.manifest]
    (world.folder / "listed").write_bytes(subprocess.check_output(command))
    (world.folder / "program").unlink()
    executable(world.folder / "program", '#!/bin/sh\ncat "$(dirname "$0")/listed"\n')


def test_a_read_only_cache_is_one_line_and_stays_usable() -> None:
    # Permissions do not bind root, so that root runs it as nobody, from a folder all may read.
    user = 65534 if os.geteuid() == 0 else None
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o755)
        shutil.copytree(ROOT / "datasets" / "fetching", folder / "datasets" / "fetching")
        (folder / "results").mkdir()
        for file in ("datasets/fetch.py", "results/console.py"):
            shutil.copy(ROOT / file, folder / file)
        world = World(folder)
        world.meshes = [generated("g")]
        assert world.fetch() == 0
        world.cache.chmod(0o555)
        list_for_all(world)
        again = run_fetch(world, folder, user)
        assert (again.returncode, again.stderr) == (0, ""), "what is there needs no writing"
        world.meshes += [generated("h"), generated("i")]
        list_for_all(world)
        refused = run_fetch(world, folder, user)
        world.cache.chmod(0o755)
        assert refused.returncode == 1
        assert refused.stderr.startswith(
            f"fetch.py: cannot write to the dataset cache {world.cache} (Permission denied: "
        )
        assert len(refused.stderr.splitlines()) == 1
        assert world.cached() == ["g.ply", "g.ply.recipe.json"]


def test_a_full_disk_costs_only_the_meshes_that_do_not_fit(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    world.put_mesh("large", TRIANGLE * 10_000)
    world.put_mesh("small")
    # A limit on the size of a file makes write() fail as a full disk does.
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


# While it makes the mesh, it waits for the file "go" beside it, though not for ever.
SLOW_BENCH = LISTING + """
here=$(dirname "$0")
echo half > "$last"
i=0
until [ -e "$here/go" ] || [ $((i += 1)) -gt 2000 ]; do sleep 0.01; done
echo "$2 $3" > "$last"
"""


def test_of_two_fetches_at_once_the_second_waits_and_finds_the_mesh(world: World) -> None:
    world.meshes = [generated("g")]
    world.bench.write_text(SLOW_BENCH)
    first = world.start()
    wait_for((world.folder / "calls").exists, "generating")
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
    world.meshes = [generated("g")]
    world.bench.write_text(SLOW_BENCH)
    process = world.start()
    wait_for((world.folder / "calls").exists, "generating")
    process.send_signal(signal.SIGINT)
    (world.folder / "go").touch()
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert err == "fetch.py: interrupted; what is in the cache is whole, and the next fetch continues\n"
    assert (world.cached(), world.leftovers()) == ([], [])
    assert world.fetch() == 0


def test_what_a_killed_fetch_left_is_not_taken_for_the_mesh(world: World) -> None:
    world.meshes = [generated("g")]
    world.bench.write_text(SLOW_BENCH)
    process = world.start()
    wait_for((world.folder / "calls").exists, "generating")
    process.kill()
    process.communicate(timeout=60)
    (world.folder / "go").touch()
    assert world.cached() == []
    assert world.fetch() == 0
    assert (world.cached(), world.leftovers()) == (["g.ply", "g.ply.recipe.json"], [])


def test_what_a_killed_fetch_left_of_a_download_is_not_in_the_way(world: World) -> None:
    world.put_mesh("a")
    left = world.cache / ".fetch" / "scratch" / "a.obj" / "upstream"
    left.mkdir(parents=True)
    (left / "a.obj").write_text("half")
    assert world.fetch() == 0
    assert (world.cached(), world.leftovers()) == (["a.obj"], [])
