"""Runs on a real Slurm cluster. After each fault of their jobs, the merged run equals the whole run."""

from __future__ import annotations

import hashlib
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from cluster import HIGH, Cluster
from shards import Sharded, differences

from results.reader import read_run

ROOT = Path(__file__).resolve().parents[2]
SHARDS = 3
SECONDS = 90
"""Time limit of a run. Most of the time passes between a fault and Slurm's next step."""


class World:
    """Small meshes, a whole run on them, and a cluster."""

    def __init__(self, cluster: Cluster, bench: Path, folder: Path) -> None:
        self.cluster, self.folder = cluster, folder
        self.sharded = Sharded(bench, folder)
        self.words = self.sharded.words("--recordings", "none", min_time="0.05")
        ended = self.sharded.bench_says("run", *self.words, "--out", "whole")
        assert ended.returncode == 0, ended.stderr
        self.whole = folder / "whole"
        self.environment = cluster.environment

    def submit(self, out: str, *options: str, words: list[str] | None = None) -> Following:
        run = ["submit", "--out", str(self.folder / out), "--bench", str(self.sharded.bench),
               f"--shards={SHARDS}", "--mem=500M", *options, "--"]  # fmt: skip
        return Following(self, self.folder / out, [*run, *(words or self.words)])

    def follow(self, out: Path) -> Following:
        return Following(self, out, ["follow", str(out)])


class Following:
    """A process of tools/slurm.py."""

    def __init__(self, world: World, out: Path, words: list[str]) -> None:
        self.world, self.out = world, out
        self.process = subprocess.Popen(
            [sys.executable, str(ROOT / "tools" / "slurm.py"), *words], text=True,
            cwd=world.folder, env=world.environment, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )  # fmt: skip

    def wait(self) -> tuple[int, str]:
        """Returns the exit code and the output. Meanwhile starts jobs that were queued again at once, which
        Slurm would delay by two minutes."""
        deadline = time.monotonic() + SECONDS
        while self.process.poll() is None:
            self.world.cluster.start_delayed()
            if time.monotonic() > deadline:
                self.process.kill()
                raise AssertionError(f"does not end: {self.process.communicate()[0]}")
            time.sleep(0.5)
        assert self.process.stdout is not None
        return self.process.returncode, self.process.stdout.read()

    def cells(self) -> dict[Path, str]:
        return {
            file: hashlib.sha256(file.read_bytes()).hexdigest()
            for file in self.out.glob("shards/*/cells/*.json")
        }

    def wait_for_cells(self, count: int) -> dict[Path, str]:
        deadline = time.monotonic() + SECONDS
        while len(found := self.cells()) < count:
            assert self.process.poll() is None and time.monotonic() < deadline
            time.sleep(0.05)
        return found


@pytest.fixture(scope="module")
def world(cluster: Cluster, bench: Path, tmp_path_factory: pytest.TempPathFactory) -> World:
    return World(cluster, bench, tmp_path_factory.mktemp("slurm"))


def test_one_command_submits_follows_merges_checks_and_draws(world: World) -> None:
    meshes = world.folder / "meshes"
    meshes.mkdir()
    for file in world.folder.glob("*.ply"):
        os.link(file, meshes / file.name)
    (meshes / "unfit.obj").write_text("v 0 0 0\n")
    options = ["--folder", str(meshes), "--solvers", "edge-based,ich,dijkstra", "--sources", "3",
               "--repetitions", "2"]  # fmt: skip
    preset = world.sharded.bench.parent.name
    ended = subprocess.run(
        [ROOT / "run_all.sh", "run", "check", "plot", "--no-install", "--preset", preset, "--slurm",
         "--mem", "500M", "--exclusive", "--array-limit", "2", "--out", "one", *options],
        cwd=world.folder, env=world.environment, capture_output=True, text=True,
    )  # fmt: skip
    assert ended.returncode == 0, ended.stdout + ended.stderr
    out = world.folder / "one"
    for said in ("submitted as geodesic-one", "9 of 9 shards done", "NOT MEASURED: unfit",
                 "18 verified, 0 failed", "report.html"):  # fmt: skip
        assert said in ended.stdout
    assert (out / "report.html").is_file()
    words = ["run", *options, "--out", "one-whole"]
    assert world.sharded.bench_says(*words).returncode == 0
    assert differences(world.folder / "one-whole", out) == []
    script = (out / "slurm.sh").read_text()
    for line in ("--mem=500M", "--exclusive", "--array=1-9%2", "--requeue"):
        assert f"#SBATCH {line}\n" in script


def node_fails(world: World, following: Following) -> None:
    node = int(world.cluster.running_on(following.out.name)[0].removeprefix("n"))
    world.cluster.stop_node(node)
    world.cluster.call("scontrol", "update", f"NodeName=n{node}", "State=DOWN", "Reason=power")
    time.sleep(1)
    world.cluster.start_node(node)
    world.cluster.call("scontrol", "update", f"NodeName=n{node}", "State=RESUME", check=False)


def processes_are_killed(world: World, following: Following) -> None:
    for entry in Path("/proc").iterdir():
        try:
            words = (entry / "cmdline").read_bytes()
        except OSError:
            continue
        if entry.name.isdigit() and f"{following.out}/shards".encode() in words:
            os.kill(int(entry.name), signal.SIGKILL)
            return


def task_is_cancelled(world: World, following: Following) -> None:
    """Cancels a task as another user would. Slurm does not queue it again."""
    jobs = world.cluster.call("squeue", "-h", "-r", "-t", "RUNNING", "-o", "%i")
    world.cluster.call("scancel", jobs.split()[0])


def jobs_of_others_come_first(world: World, following: Following) -> None:
    script = world.folder / "other.sh"
    script.write_text("#!/bin/sh\nsleep 1\n")
    world.cluster.call("sbatch", f"--partition={HIGH}", "--array=1-3", "--mem=400M",
                       "--output=/dev/null", script)  # fmt: skip


@pytest.mark.parametrize(
    ("fault", "said"),
    [
        (node_fails, ""),
        (processes_are_killed, "ended early after"),
        (task_is_cancelled, "ended early after"),
        (jobs_of_others_come_first, ""),
    ],
)
def test_nothing_is_lost_when(
    world: World, fault: Callable[[World, Following], None], said: str
) -> None:
    following = world.submit(fault.__name__)
    before = following.wait_for_cells(4)
    fault(world, following)
    code, words = following.wait()
    assert code == 0 and said in words, words
    after = following.cells()
    assert before.items() <= after.items(), "what was finished is neither lost nor measured again"
    assert differences(world.whole, following.out) == []
    logs = "".join(log.read_text() for log in following.out.glob("logs/*.log"))
    assert " cells are kept from " in logs, f"no shard was resumed: {words}"


def test_ctrl_c_leaves_the_jobs_to_themselves_and_cancelled_ones_are_gone_on_with(world: World) -> None:
    slow = world.sharded.words("--recordings", "none", min_time="0.4")
    following = world.submit("interrupted", words=slow)
    before = following.wait_for_cells(2)
    following.process.send_signal(signal.SIGINT)
    assert following.process.wait(30) == 130
    assert following.process.stdout is not None
    said = following.process.stdout.read()
    assert f"./run_all.sh --slurm-follow {following.out}" in said and "scancel --name=" in said
    assert "Traceback" not in said
    jobs = re.search(r"scancel --name=(\S+)", said)
    assert jobs is not None
    world.cluster.call("scancel", f"--name={jobs[1]}")
    deadline = time.monotonic() + 30
    while world.cluster.running_on(following.out.name):
        assert time.monotonic() < deadline, "the jobs are cancelled"
        time.sleep(0.2)
    kept = following.cells()
    assert before.items() <= kept.items()
    code, said = world.follow(following.out).wait()
    assert code == 0, said
    assert kept.items() <= following.cells().items()
    assert differences(world.whole, following.out) == []


def test_a_script_that_was_submitted_by_hand_is_followed(world: World) -> None:
    code, said = world.submit("by-hand", "--write-only").wait()
    out = world.folder / "by-hand"
    assert code == 0 and not (out / "shards").exists()
    world.cluster.call("sbatch", out / "slurm.sh")
    code, said = world.follow(out).wait()
    assert code == 0 and "submitted again" not in said, said
    assert differences(world.whole, out) == []


def test_a_shard_that_never_gets_on_is_given_up_and_goes_on_with_more_memory(world: World) -> None:
    """Slurm checks memory once a second, and kills the whole job of a cell that takes more."""
    slow = world.sharded.words("--recordings", "none", "--memory-limit", "4G", min_time="0.4")
    following = world.submit("greedy", "--mem=5M", words=slow)
    code, said = following.wait()
    assert code == 1, said
    assert re.search(r"shard \d: given up: submitted 3 times without a further cell", said), said
    assert re.search(r"its log ends: slurmstepd.*xceeded .*memory limit", said), said
    run = read_run(following.out) if (following.out / "run.json").exists() else None
    assert run is None or run.ours["missing_shards"]
    script = following.out / "slurm.sh"
    script.write_text(script.read_text().replace("--mem=5M", "--mem=500M"))
    code, said = world.follow(following.out).wait()
    assert code == 0, said
    assert not [line for line in differences(world.whole, following.out) if line != "memory_limit"]
