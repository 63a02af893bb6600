"""External programs as solvers: their requests, their times and their failures."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
BENCH = Path(os.environ.get("GEODESIC_BENCH") or ROOT / "build" / "release" / "geodesic-bench")
pytestmark = pytest.mark.skipif(not BENCH.exists(), reason=f"no program at {BENCH}")

PLACES = "{mesh} {sources} {distances}"
ALONG_EDGES = """
import heapq, math, sys, time
mesh, sources, distances = sys.argv[1:4]
words = [line.split() for line in open(mesh)]
points = [tuple(map(float, w[1:4])) for w in words if w[0] == "v"]
faces = [[int(v) - 1 for v in w[1:4]] for w in words if w[0] == "f"]
if not sources:
    sys.exit(EMPTY)
start = time.process_time()
near = [set() for _ in points]
for face in faces:
    for v in face:
        near[v] |= set(face) - {v}
found = [math.inf] * len(points)
heap = [(0.0, int(s)) for s in sources.split(",")]
while heap:
    d, v = heapq.heappop(heap)
    if d < found[v]:
        found[v] = d
        for w in near[v]:
            heapq.heappush(heap, (d + math.dist(points[v], points[w]), w))
REPORT
open(distances, "w").write(" ".join(map(str, found)))
"""
REPORT = "print('prepare_time', 0.25); print('solve_time', 0.125)"


def program(folder: Path, report: str = "", empty: str = "", name: str = "mine.py") -> str:
    """Writes a program that follows edges. Returns its command."""
    file = folder / name
    file.write_text(ALONG_EDGES.replace("EMPTY", empty).replace("REPORT", report))
    return f"{shlex.quote(sys.executable)} {shlex.quote(str(file))} {PLACES}"


def bench(*words: object, **options: Any) -> subprocess.CompletedProcess[str]:
    """@param options options of subprocess.run"""
    return subprocess.run([BENCH, *map(str, words)], capture_output=True, text=True, **options)


def solving(folder: Path, external: object, *words: object) -> list[object]:
    """Returns the arguments that solve the squares with the external program as solver `mine`."""
    return ["solve", mesh_file(folder), "--external", external, "--solver", "mine", *words]


def is_running(command: str) -> bool:
    return subprocess.run(["pgrep", "-f", f"^{command}"], check=False).returncode == 0


def mesh_file(folder: Path) -> Path:
    """Writes a mesh of two squares that are not connected."""
    file = folder / "squares.obj"
    lines = [f"v {x} {y} {z}" for z in (0, 5) for x, y in [(0, 0), (1, 0), (1, 1), (0, 1)]]
    lines += ["f 1 2 3", "f 1 3 4", "f 5 6 7", "f 5 7 8"]
    file.write_text("\n".join(lines) + "\n")
    return file


def run(folder: Path, command: str, *words: object, **options: Any) -> list[dict[str, Any]]:
    """Returns the rows of a run with the program as solver `mine`."""
    ended = bench("run", "--external", f"mine={command}", "--solvers", "mine", "--repetitions", 2,
                  "--sources", 1, "--meshes", mesh_file(folder), "--out", folder / "out", *words, **options)  # fmt: skip
    assert (folder / "out" / "run.json").is_file(), ended.stderr
    data = json.loads((folder / "out" / "run.json").read_text())
    return list(data["benchmarks"])


def test_what_a_program_reports_is_its_time(tmp_path: Path) -> None:
    rows = run(tmp_path, program(tmp_path, REPORT))
    assert len(rows) == 2
    for row in rows:
        assert (row["outcome"], row["timed"], row["iterations"]) == ("ok", "reported", 1)
        assert (row["cpu_time"], row["real_time"], row["prepare_time"]) == (125, 125, 250)
        assert "window_propagations" not in row and "instruction_set" not in row


@pytest.mark.parametrize(("empty", "timed"), [("", "process less reading"), ("'no source'", "process")])
def test_otherwise_the_row_says_what_the_time_is_of(tmp_path: Path, empty: str, timed: str) -> None:
    slow = "end = time.process_time() + 0.2\nwhile time.process_time() < end: pass"
    for row in run(tmp_path, program(tmp_path, slow, empty)):
        assert (row["outcome"], row["timed"]) == ("ok", timed)
        assert row["cpu_time"] > 150, "the process worked for 200 ms"
        assert row["process_peak_bytes"] > 1 << 20


def test_distances_come_in_the_order_in_which_the_mesh_has_its_vertices(tmp_path: Path) -> None:
    mine = f"mine={program(tmp_path)}"
    ended = bench(*solving(tmp_path, mine, "--source", "4,6", "--output", "-"))
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.split() == ["inf"] * 4 + ["0", "1", "0", "1"]


@pytest.mark.parametrize(
    ("reads", "writes"),
    [
        ("{mesh}", "{distances}"),
        ("{mesh.off}", "{distances}"),
        ("{mesh.ply}", "{distances}"),
        ("{vertices.npy} {faces.npy}", "{distances.npy}"),
    ],
)
def test_meshes_and_distances_are_in_the_formats_that_the_command_names(
    tmp_path: Path, reads: str, writes: str
) -> None:
    copies = tmp_path / "copies"
    copies.mkdir()
    numpy = "import numpy, sys; numpy.save(sys.argv[1], numpy.array([0, 1, 2, 1] + 4 * [numpy.inf], 'f4'))"
    save = "printf '0 1 2\\n1 inf inf inf inf\\n' >" if "npy" not in writes else (
        f"/usr/bin/python3 -c {shlex.quote(numpy)}")  # fmt: skip
    command = f"cp {reads} {shlex.quote(str(copies))} && : {{sources}} && {save} {writes}"
    ended = bench(*solving(tmp_path, f"mine={command}", "--source", 0, "--output", "-"))
    assert ended.stdout.split() == ["0", "1", "2", "1", "inf", "inf", "inf", "inf"], ended.stderr
    assert len(list(copies.iterdir())) == len(reads.split())
    for file in copies.glob("mesh.*"):
        facts = bench("mesh", file).stdout
        assert "8" in facts and "2 components" in facts or '"components": 2' in facts, facts


def test_a_description_says_what_the_program_promises(tmp_path: Path) -> None:
    folder = tmp_path / "mine"
    folder.mkdir()
    program(folder)
    command = f"{shlex.quote(sys.executable)} {{folder}}/mine.py {PLACES}"

    def check(**promise: Any) -> subprocess.CompletedProcess[str]:
        about = {"name": "mine", "command": command, "remarks": "follows edges", **promise}
        (folder / "solver.json").write_text(json.dumps(about))
        # Along edges, the distance to the opposite corner of a square is 2.
        return bench(*solving(tmp_path, folder, "--source", 1, "--check"))

    assert check().returncode == check(promise="upper_bound").returncode == 0
    assert check(promise="bounded", error_bound=0.5).returncode == 0
    assert check(promise="bounded", error_bound=0.4).returncode == 2
    assert check(promise="exact").returncode == 2
    assert "  mine  " in bench("list", "--external", folder).stdout
    assert "error_bound belongs to the promise 'bounded'" in check(error_bound=1).stderr


@pytest.mark.parametrize(
    ("word", "reason"),
    [
        ("mine", "it is neither NAME=COMMAND nor a folder with a solver.json"),
        ("mine=true", "command: it needs {mesh}, {sources} and {distances}"),
        (f"Mine=true {PLACES}", "name: must be lower-case letters and digits, joined by '-'"),
        (f"mmp=true {PLACES}", "two solvers are registered as 'mmp'"),
        (".", "cannot read './solver.json'"),
    ],
)
def test_what_is_no_external_solver_is_refused_in_a_line(
    tmp_path: Path, word: str, reason: str
) -> None:
    ended = bench("list", "--external", word, cwd=tmp_path)
    assert ended.returncode == 1
    assert ended.stderr.startswith("geodesic-bench: external solver '")
    assert reason in ended.stderr and ended.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("command", "reason"),
    [
        ("echo why >&2; exit 3", "mine: exit code 3: why"),
        ("kill -SEGV $$", "mine: killed by signal 11"),
        ("true", "mine: it ended without writing the file of {distances}"),
        ("echo 1 2 > {distances}", "mine: it wrote 2 distances for 8 vertices"),
        ("echo far > {distances}", "mine's distances, line 1: the distance 'far' is not a number"),
        ("echo 0 nan 1 1 inf inf inf inf > {distances}", "wrong answer"),
    ],
)
def test_a_program_that_fails_is_a_row_with_the_reason(
    tmp_path: Path, command: str, reason: str
) -> None:
    (row,) = run(tmp_path, f"{command} # {PLACES}")
    assert reason in f"{row['outcome']}: {row['error_message']}"


def test_a_program_that_does_not_end_is_stopped_and_its_files_are_removed(tmp_path: Path) -> None:
    temporary = tmp_path / "tmp"
    temporary.mkdir()
    env = dict(os.environ, TMPDIR=str(temporary))
    sleep = f"sleep 1000.{os.getpid()}"
    start = time.monotonic()
    (row,) = run(tmp_path, f"{sleep}; true # {PLACES}", "--time-limit", 0.5, env=env)
    assert time.monotonic() - start < 100
    assert row["outcome"] == "time-out"
    assert not is_running(sleep)
    # The killed process could not remove its files. The next one removes them.
    solve = solving(tmp_path, f"mine={program(tmp_path)}", "--source", 0)
    assert bench(*solve, env=env).returncode == 0
    assert list(temporary.iterdir()) == []


def test_an_interrupted_program_is_ended(tmp_path: Path) -> None:
    sleep = f"sleep 1001.{os.getpid()}"
    words = solving(tmp_path, f"mine={sleep}; true # {PLACES}", "--source", 0)
    with subprocess.Popen([BENCH, *map(str, words)]) as process:
        while not is_running(sleep):
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        process.wait(timeout=60)
    while is_running(sleep):
        time.sleep(0.05)


def test_every_command_takes_external_solvers_and_refuses_a_wrong_one(tmp_path: Path) -> None:
    commands = re.findall(r"^  ([a-z-]+) ", bench("--help").stdout.split("Subcommands:")[1], re.MULTILINE)
    assert {"solve", "run", "check", "compare", "report", "view"} <= set(commands)
    for command in commands:
        ended = bench(command, "--external", "mine=true")
        assert ended.returncode == 1 and ended.stderr.count("\n") == 1, command
        assert "external solver 'mine=true': command: it needs {mesh}" in ended.stderr, command
    run(tmp_path, program(tmp_path))
    mine = f"mine={program(tmp_path)}"
    for words in (["check", "--external", mine], [f"--external={mine}", "check"]):
        ended = bench(*words, tmp_path / "out")
        assert ended.returncode == 0, ended.stderr


def test_a_run_is_resumed_with_its_programs_from_any_folder(tmp_path: Path) -> None:
    run(tmp_path, program(tmp_path))
    next((tmp_path / "out" / "cells").iterdir()).unlink()
    ended = bench("run", "--resume", tmp_path / "out", cwd="/")
    assert ended.returncode == 0, ended.stderr


def test_the_recorded_command_can_be_run_again(tmp_path: Path) -> None:
    folder = tmp_path / "it's mine twice"
    folder.mkdir()
    run(folder, program(folder))
    recorded = json.loads((folder / "out" / "run.json").read_text())["context"]["geodesic_bench"]["command"]
    assert shlex.split(recorded)[-2:] == ["--out", str(folder / "out")]
    shutil.rmtree(folder / "out")
    assert subprocess.run(recorded, shell=True, capture_output=True).returncode == 0


def test_a_run_is_not_resumed_with_another_script(tmp_path: Path) -> None:
    command = program(tmp_path)
    run(tmp_path, command)
    resume = ["run", "--resume", tmp_path / "out", "--external", f"mine={command}"]
    assert bench(*resume).returncode == 0
    program(tmp_path, REPORT)
    ended = bench(*resume)
    assert ended.returncode == 1 and "cannot resume" in ended.stderr, ended.stderr
