"""Measures a run on a cluster with Slurm: writes the batch script, submits it, waits for it, merges.

    tools/slurm.py submit --out DIR --bench PROGRAM [OPTION...] -- OPTION OF geodesic-bench run...
    tools/slurm.py follow DIR

./run_all.sh --slurm calls it. DIR/slurm.sh is an array job with one task per shard, and can be submitted
by hand. The shards' folders show which shards are finished, and squeue shows by the job's name which are
queued, so `follow` needs no state of an earlier process. Slurm waits (`sbatch --wait`), requeues jobs that
it ends itself (`--requeue`), and lets later submissions wait for earlier ones (`--dependency=afterany`).
"""

from __future__ import annotations

import argparse
import getpass
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

SHARDS = 32
"""Default of --shards. There are fewer if there are fewer pairs of mesh and source."""
FRUITLESS = 3
"""Number of successive submissions without a finished cell after which a shard is given up."""
SCRIPT = """#!/usr/bin/env bash
# A run of geodesic-bench in {shards} shards, a task of this array each. Submitted by ./run_all.sh --slurm,
# or by hand: sbatch {script}. A task that is started again goes on where it was.
#   follow, merge and draw: {follow}
#   cancel:                 scancel --name={name}
#SBATCH --job-name={name}
#SBATCH --array=1-{shards}{limit}
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output={log}
#SBATCH --chdir={folder}
#SBATCH --ntasks=1
{options}
set -euo pipefail
{exports}shard={out}/shards/$SLURM_ARRAY_TASK_ID
echo "shard $SLURM_ARRAY_TASK_ID on $(hostname), job $SLURM_JOB_ID, $(date -u +%Y-%m-%dT%H:%M:%SZ)"
{limits}
if [[ -f $shard/run.json ]]; then
  echo "finished before"
elif [[ -f $shard/request.json ]]; then
  {bench} run --resume "$shard" || [[ -f $shard/run.json ]]
else
  {bench} run {words} "${{limit[@]}}" \\
    --shard "$SLURM_ARRAY_TASK_ID/{shards}" --out "$shard" || [[ -f $shard/run.json ]]
fi
"""


LIMIT = """
# Below the job's own limit, so that a solver that needs more is a row of the results and not the
# end of the job. Without --mem, it is what the node has available.
limit=()
if [[ ${SLURM_MEM_PER_NODE:-0} -gt 0 ]]; then limit=(--memory-limit "$((SLURM_MEM_PER_NODE * 9 / 10))M"); fi
"""
OWN_LIMIT = """limit=()  # the run has one of its own
"""


ENDED = re.compile(r"^slurmstepd.*(memory limit|DUE TO|oom)", re.IGNORECASE)
"""Matches the reason why Slurm ended a job, in the log of the job."""


class SlurmError(RuntimeError):
    """An error whose message is one line."""


@dataclass
class Job:
    """A run in a folder. The other members are stored in DIR/slurm.json."""

    folder: Path
    name: str
    shards: int
    limit: int | None
    bench: str

    @property
    def script(self) -> Path:
        return self.folder / "slurm.sh"

    def shard(self, index: int) -> Path:
        return self.folder / "shards" / str(index)

    def log(self, index: int) -> Path:
        return self.folder / "logs" / f"{index}.log"

    def open(self) -> list[int]:
        """Returns the indices of the shards that are not finished."""
        every = range(1, self.shards + 1)
        return [index for index in every if not (self.shard(index) / "run.json").is_file()]

    def cells(self, index: int) -> int:
        try:
            return sum(entry.name.endswith(".json") for entry in os.scandir(self.shard(index) / "cells"))
        except OSError:
            return 0

    def save(self) -> None:
        facts = {key: fact for key, fact in asdict(self).items() if key != "folder"}
        (self.folder / "slurm.json").write_text(json.dumps(facts, indent=1) + "\n", encoding="utf-8")

    @staticmethod
    def load(folder: Path) -> Job:
        """@raises SlurmError"""
        file = folder / "slurm.json"
        try:
            return Job(folder=folder, **json.loads(file.read_text(encoding="utf-8")))
        except FileNotFoundError:
            raise SlurmError(f"{folder}: holds no run of --slurm (no slurm.json)") from None
        except (OSError, ValueError, TypeError) as error:
            raise SlurmError(f"{file}: cannot be used: {error}; submit {folder / 'slurm.sh'} by hand "
                             "and merge its shards with geodesic-bench merge") from None  # fmt: skip


def say(words: str) -> None:
    print(words, flush=True)


def call(*words: str) -> str:
    """Returns the output of a command of Slurm. @raises SlurmError when it fails without output"""
    try:
        ended = subprocess.run(words, capture_output=True, text=True)
    except FileNotFoundError:
        raise SlurmError(f"there is no {words[0]}: run this where Slurm's commands are") from None
    if ended.returncode != 0 and not ended.stdout:
        lines = ended.stderr.strip().splitlines() or [f"exit code {ended.returncode}"]
        raise SlurmError(f"{words[0]}: {'; '.join(lines)}")
    return ended.stdout


def queued(job: Job) -> list[str]:
    """Returns the numbers of the job's arrays in the queue, of any submission. @raises SlurmError"""
    text = call("squeue", "--noheader", f"--user={getpass.getuser()}", f"--name={job.name}",
                "--format=%F")  # fmt: skip
    return sorted(set(text.split()))


def submit_and_wait(job: Job, shards: Sequence[int]) -> None:
    """Submits these shards and waits until all have ended or failed. Arrays that are already queued end
    first, so that no two jobs have the same shard. @raises SlurmError"""
    earlier = queued(job)
    words = [f"--dependency=afterany:{':'.join(earlier)}"] if earlier else []
    limit = "" if job.limit is None else f"%{job.limit}"
    # The exit code of sbatch is that of the tasks, some of which may fail.
    call("sbatch", "--wait", *words, f"--array={ranges(shards)}{limit}", str(job.script))


def ranges(numbers: Sequence[int]) -> str:
    """Converts 1, 2, 3 and 7 to "1-3,7"."""
    found: list[list[int]] = []
    for number in numbers:
        if found and number == found[-1][1] + 1:
            found[-1][1] = number
        else:
            found.append([number, number])
    return ",".join(str(a) if a == b else f"{a}-{b}" for a, b in found)


def last_words(job: Job, index: int) -> str:
    """Returns Slurm's reason for the end of a shard's last job, or else the last line of the log."""
    try:
        lines = job.log(index).read_text(encoding="utf-8", errors="replace").strip().splitlines()
    except OSError:
        lines = []
    begins = [number for number, line in enumerate(lines) if line.startswith(f"shard {index} on ")]
    slurms = [line for line in lines[begins[-1] if begins else 0 :] if ENDED.search(line)]
    line = (slurms or lines[-1:] or ["it left no log"])[-1]
    return "".join(c if c.isprintable() else "?" for c in line)[:300]


def measure(job: Job) -> list[int]:
    """Measures until every shard is done or given up. Returns those given up. @raises SlurmError"""
    fruitless: dict[int, int] = {}
    while again := [index for index in job.open() if fruitless.get(index, 0) < FRUITLESS]:
        say(f"{job.shards - len(job.open())} of {job.shards} shards done; submitted as {job.name}: "
            f"shards {ranges(again)}; squeue --name={job.name} shows them")  # fmt: skip
        before = {index: job.cells(index) for index in again}
        submit_and_wait(job, again)
        for index in set(again) & set(job.open()):
            cells = job.cells(index)
            fruitless[index] = fruitless.get(index, 0) + 1 if cells == before[index] else 0
            if fruitless[index] == FRUITLESS:
                what = f"given up: submitted {FRUITLESS} times without a further cell"
            else:
                what = f"ended early after {cells} cells and is submitted again"
            say(f"shard {index}: {what}; its log ends: {last_words(job, index)} ({job.log(index)})")
    say(f"{job.shards - len(job.open())} of {job.shards} shards done")
    return job.open()


def measure_and_merge(job: Job) -> int:
    """Measures and merges; returns the exit code. The jobs continue after Ctrl-C."""
    follow_again = f"./run_all.sh --slurm-follow {shlex.quote(str(job.folder))}"
    try:
        given_up = measure(job)
    except KeyboardInterrupt:
        say(f"\nnot followed any more; the jobs go on. Follow them: {follow_again}; cancel them: "
            f"scancel --name={job.name}")  # fmt: skip
        return 130
    words = [job.bench, "merge", str(job.folder / "shards"), "--out", str(job.folder)]
    ended = subprocess.run(words + (["--allow-gaps"] if given_up else []))
    if given_up:
        say(f"without shards {ranges(given_up)}: correct the reason and go on: {follow_again}")
    return ended.returncode or bool(given_up)


def planned(bench: str, words: Sequence[str]) -> dict[str, int]:
    """Returns the numbers of meshes, pairs and cells. @raises SlurmError"""
    ended = subprocess.run([bench, "run", *words, "--plan"], capture_output=True, text=True)
    if ended.returncode != 0:
        raise SlurmError(ended.stderr.strip().removeprefix("geodesic-bench: "))
    found: dict[str, int] = json.loads(ended.stdout)
    return found


def write_script(job: Job, options: Sequence[str], words: Sequence[str]) -> None:
    """Writes DIR/slurm.sh."""
    quoted = shlex.quote
    cache = os.environ.get("GEODESIC_DATASETS")
    exports = f"export GEODESIC_DATASETS={quoted(cache)}\n" if cache else ""
    directives = "".join(f"#SBATCH {option}\n" for option in options)
    text = SCRIPT.format(
        shards=job.shards, script=quoted(str(job.script)), name=job.name,
        limit="" if job.limit is None else f"%{job.limit}",
        follow=f"./run_all.sh --slurm-follow {quoted(str(job.folder))}",
        log=f"{job.folder}/logs/%a.log", folder=os.getcwd(), options=directives.rstrip("\n"),
        exports=exports, limits=OWN_LIMIT if "--memory-limit" in words else LIMIT, out=quoted(str(job.folder)), bench=quoted(job.bench),
        words=shlex.join(words),
    )  # fmt: skip
    job.script.write_text(text, encoding="utf-8")
    job.script.chmod(0o755)


def parse(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="run_all.sh --slurm", description=(__doc__ or "").splitlines()[0], allow_abbrev=False
    )
    commands = parser.add_subparsers(dest="command", required=True)
    new = commands.add_parser("submit")
    new.add_argument("--out", type=Path, required=True)
    new.add_argument("--bench", required=True)
    new.add_argument("--shards", type=int)
    new.add_argument("--array-limit", type=int)
    for name in ("partition", "time", "mem"):
        new.add_argument(f"--{name}")
    new.add_argument("--exclusive", action="store_true")
    new.add_argument("--sbatch", action="append", default=[])
    new.add_argument("--write-only", action="store_true")
    new.add_argument("words", nargs="*")
    old = commands.add_parser("follow")
    old.add_argument("folder", type=Path)
    return parser.parse_args(arguments)


def new_job(wish: argparse.Namespace) -> Job:
    """Makes the folder with the batch script. @raises SlurmError"""
    folder = wish.out.absolute()
    unfit = re.search(r"[\s%\\]", f"{folder}{os.getcwd()}")
    if unfit:
        raise SlurmError(f"{folder}: {unfit[0]!r} in the folder's path means something else to Slurm, "
                         "and so it does in that of the checkout")  # fmt: skip
    for name in ("run.json", "slurm.json"):
        if (folder / name).exists():
            raise SlurmError(f"{folder} holds a run already: follow it with --slurm-follow, or give "
                             "another --out")  # fmt: skip
    pairs = planned(wish.bench, wish.words)["pairs"]
    shards = min(pairs, wish.shards or SHARDS)
    if wish.shards and wish.shards > pairs:
        say(f"{pairs} shards: there are only {pairs} pairs of mesh and source")
    (folder / "logs").mkdir(parents=True, exist_ok=True)
    digest = hashlib.sha256(str(folder).encode()).hexdigest()[:6]
    name = f"geodesic-{re.sub(r'[^A-Za-z0-9_.-]', '-', folder.name)}-{digest}"
    job = Job(folder, name, shards, wish.array_limit, wish.bench)
    options = [f"--{name}={getattr(wish, name)}" for name in ("partition", "time", "mem")
               if getattr(wish, name)]  # fmt: skip
    options += ["--exclusive"] * wish.exclusive + wish.sbatch
    write_script(job, options, wish.words)
    job.save()
    return job


def main(arguments: Sequence[str] | None = None) -> int:
    wish = parse(arguments)
    try:
        if wish.command == "follow":
            return measure_and_merge(Job.load(wish.folder.absolute()))
        job = new_job(wish)
        say(f"the batch script: {job.script} ({job.shards} shards)")
        if wish.write_only:
            return 0
        return measure_and_merge(job)
    except (SlurmError, OSError) as error:
        print(f"run_all.sh: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
