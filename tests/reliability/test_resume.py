"""Runs that stop early keep their cells and print how to resume them. They can be resumed."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import time
from pathlib import Path
from typing import Any

import pytest

TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
Ended = subprocess.CompletedProcess[str]


class World:
    """A mesh, a program, and a folder to run in."""

    def __init__(self, bench: Path, folder: Path) -> None:
        self.bench, self.folder = bench, folder
        self.out = folder / "out"
        self.mesh = folder / "tetrahedron.obj"
        self.mesh.write_text(TETRAHEDRON, "utf-8")

    def words(self, *more: str, repetitions: int = 2) -> list[str]:
        return [str(self.bench), "run", "--meshes", str(self.mesh), "--solvers",
                "dijkstra,edge-based,ich", "--sources", "2", "--repetitions", str(repetitions),
                "--min-time", "0.0001", "--out", str(self.out), *more]  # fmt: skip

    def run(self, *more: str) -> Ended:
        return subprocess.run(self.words(*more), cwd=self.folder, capture_output=True, text=True)

    def resume(self, *more: str) -> Ended:
        return subprocess.run(
            [str(self.bench), "run", "--resume", str(self.out), *more],
            cwd="/", capture_output=True, text=True,
        )  # fmt: skip

    def unfinished(self) -> None:
        """Makes a run that lacks its last cell."""
        assert self.run().returncode == 0
        (self.out / "run.json").unlink()
        (self.out / "cells" / "ich__tetrahedron__src3.json").unlink(missing_ok=True)

    def rows(self) -> list[dict[str, Any]]:
        rows: list[dict[str, Any]] = json.loads((self.out / "run.json").read_text())["benchmarks"]
        return rows


@pytest.fixture
def world(bench: Path, tmp_path: Path) -> World:
    return World(bench, tmp_path)


def test_a_run_that_is_complete_is_not_measured_again(world: World) -> None:
    assert world.run().returncode == 0
    before = world.rows()
    ended = world.resume()
    assert ended.returncode == 0 and "6 of 6 cells are kept" in ended.stderr
    assert world.rows() == before


def test_what_is_missing_is_measured_and_what_is_there_is_not(world: World) -> None:
    assert world.run().returncode == 0
    before = {row["name"]: row["cpu_time"] for row in world.rows()}
    (world.out / "run.json").unlink()
    (world.out / "cells" / "ich__tetrahedron__src0.json").unlink()
    ended = world.resume()
    assert ended.returncode == 0 and "5 of 6 cells are kept" in ended.stderr
    after = {row["name"]: row["cpu_time"] for row in world.rows()}
    assert after.keys() == before.keys()
    changed = [name for name in before if before[name] != after[name]]
    assert changed == ["ich/tetrahedron/src:0"]


@pytest.mark.parametrize("damage", ["truncated", "edited", "of another cell", "empty"])
def test_a_damaged_cell_is_measured_again(world: World, damage: str) -> None:
    world.unfinished()
    cell = world.out / "cells" / "dijkstra__tetrahedron__src0.json"
    text = cell.read_text()
    cell.write_text({
        "truncated": text[: len(text) // 2],
        "edited": re.sub(r'"cpu_time": [^,]*', '"cpu_time": 1e-9', text),
        "of another cell": (cell.parent / "edge-based__tetrahedron__src0.json").read_text(),
        "empty": "",
    }[damage])  # fmt: skip
    ended = world.resume()
    assert ended.returncode == 0 and f"{cell} " in ended.stderr
    assert "measured again" in ended.stderr
    assert all(row["outcome"] == "ok" and row["cpu_time"] > 1e-8 for row in world.rows())


def test_parts_of_files_that_a_kill_left_are_removed(world: World) -> None:
    world.unfinished()
    part = world.out / "cells" / "x.json.123.part"
    part.write_text("half")
    assert world.resume().returncode == 0
    assert not part.exists()


@pytest.mark.parametrize(
    "change, words",
    [
        ("option", "options/suite/repetitions is 7 and was 2"),
        ("mesh", "meshes/tetrahedron/sha256 is"),
        ("program", "program/executable is"),
    ],
)
def test_another_option_mesh_or_program_is_refused_unless_told_otherwise(
    world: World, change: str, words: str
) -> None:
    world.unfinished()
    more = []
    if change == "option":
        more = ["--repetitions", "7"]
    elif change == "mesh":
        world.mesh.write_text(TETRAHEDRON.replace("v 1 0 0", "v 2 0 0"), "utf-8")
    else:
        request = world.out / "request.json"
        text = re.sub(r'"executable": "."', '"executable": "?', request.read_text())
        text = re.sub(r'("executable": ")[^"]*', r"\1another", text)
        request.write_text(text)
    refused = world.resume(*more)
    assert refused.returncode == 1 and words in refused.stderr
    assert "--accept-changes" in refused.stderr
    assert not (world.out / "run.json").exists()
    accepted = world.resume(*more, "--accept-changes")
    assert accepted.returncode == 0 and "accepted: " in accepted.stderr
    context = json.loads((world.out / "run.json").read_text())["context"]["geodesic_bench"]
    assert any(words in each for each in context["changes"])


def test_a_run_that_goes_on_in_another_environment_says_both(world: World) -> None:
    """A test can change the cores that a process may use."""
    world.unfinished()
    cores = sorted(os.sched_getaffinity(0))
    if len(cores) == 1:
        pytest.skip("a single core: there is no other environment")
    os.sched_setaffinity(0, cores[:1])
    try:
        resumed = world.resume()
    finally:
        os.sched_setaffinity(0, cores)
    assert resumed.returncode == 0, resumed.stderr
    before, after = json.loads((world.out / "run.json").read_text())["context"]["geodesic_bench"]["environments"]
    assert before["cores"] != after["cores"] == str(cores[0])
    assert before["libraries"] == after["libraries"] and "glibc" in before["libraries"]


def test_a_request_without_an_environment_is_refused(world: World) -> None:
    world.unfinished()
    request = world.out / "request.json"
    request.write_text(json.dumps(json.loads(request.read_text()) | {"environments": []}))
    refused = world.resume()
    assert refused.returncode == 1 and "it names no environment" in refused.stderr
    assert len(refused.stderr.splitlines()) == 1


def test_a_folder_without_a_run_is_refused(world: World) -> None:
    for folder in (world.folder, world.folder / "nowhere"):
        ended = subprocess.run(
            [str(world.bench), "run", "--resume", str(folder)], capture_output=True, text=True
        )
        assert ended.returncode == 1 and "holds no run to resume" in ended.stderr
        assert len(ended.stderr.splitlines()) == 1


def test_the_second_of_two_runs_in_one_folder_is_refused(world: World) -> None:
    with subprocess.Popen(
        world.words("--", "--benchmark_min_time=60"), stderr=subprocess.PIPE, text=True
    ) as first:
        request = world.out / "request.json"
        while not request.exists():
            time.sleep(0.01)
        for second in (world.run(), world.resume()):
            assert second.returncode == 1
            assert "another process is writing to" in second.stderr
        first.send_signal(signal.SIGINT)
        _, errors = first.communicate()
    assert first.returncode == 130
    assert "0 of 6 cells are saved in" in errors and str(world.out) in errors


def test_the_command_that_an_interrupted_run_prints_goes_on_with_it(world: World) -> None:
    slow = ["--reference", "edge-based", "--", "--benchmark_min_time=0.1"]
    with subprocess.Popen(world.words(*slow), stderr=subprocess.PIPE, text=True) as first:
        while not list(world.out.glob("cells/*.json")):
            time.sleep(0.01)
        first.send_signal(signal.SIGTERM)
        _, errors = first.communicate()
    assert first.returncode == 143
    command = errors.splitlines()[-2].strip()
    assert "--resume" in command, errors
    ended = subprocess.run(["/bin/sh", "-c", command], capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    assert len(world.rows()) == 12


def test_a_run_whose_folder_is_removed_ends_with_a_line(world: World) -> None:
    with subprocess.Popen(
        world.words("--", "--benchmark_min_time=0.3"), stderr=subprocess.PIPE, text=True
    ) as process:
        while not list(world.out.glob("cells/*.json")):
            time.sleep(0.01)
        shutil.rmtree(world.out)
        _, errors = process.communicate(timeout=60)
    assert process.returncode == 1
    # The next step of the run was to read the file of a cell's process, or to write a file.
    assert re.search(r"cannot (read|write) '", errors.splitlines()[-1])


FULL_DISK = """
mount -t tmpfs -o size=64k tmpfs "$1" || exit 99
"$2" run --meshes "$3" --solvers dijkstra,edge-based,ich --sources 4 --repetitions 2 \\
  --min-time 0.0001 --out "$1/out"
echo "full: $? $(ls "$1/out/cells" | wc -l)"
mount -o remount,size=16m tmpfs "$1"
"$2" run --resume "$1/out"
echo "then: $? $(ls "$1/out/cells" | wc -l)"
"""


def test_a_full_disk_ends_the_run_which_goes_on_when_there_is_room(world: World) -> None:
    if os.geteuid() != 0 or shutil.which("unshare") is None:
        pytest.skip("mounting a small file system takes root and unshare")
    disk = world.folder / "disk"
    disk.mkdir()
    ended = subprocess.run(
        ["unshare", "-m", "sh", "-c", FULL_DISK, "sh", disk, world.bench, world.mesh],
        capture_output=True, text=True,
    )  # fmt: skip
    if ended.returncode == 99 or "unshare failed" in ended.stderr:
        pytest.skip(f"no mounts here: {ended.stderr.strip()}")
    full = re.search(r"full: 1 (\d+)", ended.stdout)
    assert full and 0 < int(full[1]) < 12, ended.stdout + ended.stderr
    assert "No space left on device" in ended.stderr
    assert f"{full[1]} of 12 cells are saved in" in ended.stderr
    assert "then: 0 12" in ended.stdout
