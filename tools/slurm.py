"""Measures a run on a cluster with Slurm: writes the batch script, submits it, follows it, merges.

    tools/slurm.py submit --out DIR --bench PROGRAM [OPTION...] -- OPTION OF geodesic-bench run...
    tools/slurm.py follow DIR

./run_all.sh --slurm calls it. DIR/slurm.sh is an array job, a shard a task; it can be submitted by
hand. What is done is seen from the shards' folders alone, and what is queued from squeue by the
job's name: whoever follows a run needs nothing of what followed it before.
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
import time
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

SHARDS = 32
"""Unless --shards says otherwise, or there are fewer pairs of mesh and source."""
FRUITLESS = 3
"""So many submissions of a shard in which it finished no cell end it."""
SECONDS = float(os.environ.get("GEODESIC_SLURM_SECONDS", "15"))
"""Between two looks at the queue: an administrator's patience is longer than a test's."""
CANCEL_WITHIN = 5
"""Seconds in which a second Ctrl-C cancels the jobs."""
WAITING = ("PENDING", "REQUEUED", "CONFIGURING", "SUSPENDED")
HELD = re.compile(r"held|JobHeld|launch_failed", re.IGNORECASE)

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
"""Why Slurm ended a job, in its log."""


class SlurmError(RuntimeError):
    """Its message is one line."""


@dataclass
class Shard:
    """What is remembered of one between submissions."""

    cells: int = 0
    """Finished when it was last submitted."""
    fruitless: int = 0
    """Submissions since then that finished none."""


@dataclass
class Job:
    """A run in a folder: the script's facts, in DIR/slurm.json, and the shards' history."""

    folder: Path
    name: str
    shards: int
    limit: int | None
    bench: str
    history: dict[int, Shard] = field(default_factory=dict)

    @property
    def script(self) -> Path:
        return self.folder / "slurm.sh"

    def shard(self, index: int) -> Path:
        return self.folder / "shards" / str(index)

    def log(self, index: int) -> Path:
        return self.folder / "logs" / f"{index}.log"

    def done(self) -> set[int]:
        every = range(1, self.shards + 1)
        return {index for index in every if (self.shard(index) / "run.json").is_file()}

    def cells(self, index: int) -> int:
        try:
            return sum(entry.name.endswith(".json") for entry in os.scandir(self.shard(index) / "cells"))
        except OSError:
            return 0

    def save(self) -> None:
        facts = {"name": self.name, "shards": self.shards, "limit": self.limit, "bench": self.bench,
                 "history": {i: vars(shard) for i, shard in sorted(self.history.items())}}  # fmt: skip
        part = self.folder / f"slurm.json.{os.getpid()}.part"
        part.write_text(json.dumps(facts, indent=1) + "\n", encoding="utf-8")
        part.replace(self.folder / "slurm.json")

    @staticmethod
    def load(folder: Path) -> Job:
        """@raises SlurmError"""
        file = folder / "slurm.json"
        try:
            facts = json.loads(file.read_text(encoding="utf-8"))
            history = {int(i): Shard(**shard) for i, shard in facts.pop("history").items()}
            return Job(folder=folder, history=history, **facts)
        except FileNotFoundError:
            raise SlurmError(f"{folder}: holds no run of --slurm (no slurm.json)") from None
        except (OSError, ValueError, TypeError, KeyError, AttributeError) as error:
            raise SlurmError(f"{file}: cannot be used: {error}; submit {folder / 'slurm.sh'} by hand "
                             "and merge its shards with geodesic-bench merge") from None  # fmt: skip


@dataclass(frozen=True)
class Task:
    shard: int
    state: str
    reason: str


def say(words: str) -> None:
    print(words, flush=True)


def call(*words: str) -> str:
    """What a command of Slurm prints. @raises SlurmError"""
    try:
        ended = subprocess.run(words, capture_output=True, text=True)
    except FileNotFoundError:
        raise SlurmError(f"there is no {words[0]}: run this where Slurm's commands are") from None
    if ended.returncode != 0:
        lines = ended.stderr.strip().splitlines() or [f"exit code {ended.returncode}"]
        raise SlurmError(f"{words[0]}: {'; '.join(lines)}")
    return ended.stdout


def queued(job: Job) -> list[Task]:
    """The job's tasks that wait or run, whoever submitted them. @raises SlurmError"""
    text = call("squeue", "--noheader", "--array", f"--user={getpass.getuser()}",
                f"--name={job.name}", "--format=%K|%T|%r")  # fmt: skip
    tasks = []
    for line in text.splitlines():
        index, state, reason = line.split("|", 2)
        if index.isdigit():
            tasks.append(Task(int(index), state, reason))
    return tasks


def submit(job: Job, shards: Iterable[int], running: int = 0) -> None:
    """@param running others, which count towards the limit
    @raises SlurmError"""
    chosen = sorted(shards)
    for index in chosen:
        shard = job.history.setdefault(index, Shard())
        cells = job.cells(index)
        shard.fruitless = shard.fruitless + 1 if cells == shard.cells else 1
        shard.cells = cells
    job.save()
    limit = "" if job.limit is None else f"%{job.limit - running}"
    call("sbatch", f"--array={ranges(chosen)}{limit}", str(job.script))


def ranges(numbers: Sequence[int]) -> str:
    """1-3,7 of 1, 2, 3 and 7"""
    found: list[list[int]] = []
    for number in numbers:
        if found and number == found[-1][1] + 1:
            found[-1][1] = number
        else:
            found.append([number, number])
    return ",".join(str(a) if a == b else f"{a}-{b}" for a, b in found)


def last_words(job: Job, index: int) -> str:
    """The last line of a shard's log; of its last job rather what Slurm says of its end."""
    try:
        lines = job.log(index).read_text(encoding="utf-8", errors="replace").strip().splitlines()
    except OSError:
        lines = []
    begins = [number for number, line in enumerate(lines) if line.startswith(f"shard {index} on ")]
    slurms = [line for line in lines[begins[-1] if begins else 0 :] if ENDED.search(line)]
    line = (slurms or lines[-1:] or ["it left no log"])[-1]
    return "".join(c if c.isprintable() else "?" for c in line)[:300]


def progress(job: Job, tasks: Sequence[Task], done: set[int]) -> str:
    """ "12 of 32 shards done, 8 running, 12 waiting (Priority); 140 cells in running ones" """
    active = [task for task in tasks if task.shard not in done]
    waiting = [task for task in active if task.state in WAITING]
    running = {task.shard for task in active if task.state not in WAITING}
    text = f"{len(done)} of {job.shards} shards done, {len(running)} running, {len(waiting)} waiting"
    reasons = Counter(task.reason for task in waiting if task.reason not in ("None", ""))
    if reasons:
        text += f" ({', '.join(f'{reason}: {n}' for reason, n in reasons.most_common(3))})"
    if running:
        text += f"; cells finished in running ones: {sum(map(job.cells, running))}"
    return text


def follow(job: Job) -> list[int]:
    """Until every shard is done or given up; those are returned. @raises SlurmError"""
    said, trouble, given_up, silent = "", "", set[int](), set[int]()
    last = 0.0
    while True:
        try:
            tasks = queued(job)
        except SlurmError as error:  # the controller may be restarted
            if str(error) != trouble:
                say(f"{error}: looking again every {SECONDS:.0f} s")
            trouble = str(error)
            time.sleep(SECONDS)
            continue
        trouble = ""
        done = job.done()  # after the queue: what left it meanwhile has its run.json
        lost = set(range(1, job.shards + 1)) - done - {task.shard for task in tasks}
        for index in sorted(lost - given_up):
            shard = job.history.get(index, Shard())
            if shard.fruitless >= FRUITLESS and job.cells(index) == shard.cells:
                given_up.add(index)
                say(f"shard {index}: given up: submitted {FRUITLESS} times without a further cell; "
                    f"its log ends: {last_words(job, index)} ({job.log(index)})")  # fmt: skip
        again = lost - given_up
        running = sum(task.state not in WAITING for task in tasks)
        if job.limit is not None and (len(tasks) > running or running >= job.limit):
            again = set()  # the limit is of one array: another one begins when none waits
        if again:
            known = [index for index in sorted(again) if index in job.history]
            for index in known[:10]:
                say(f"shard {index}: ended early after {job.cells(index)} cells and is submitted "
                    f"again; its log ends: {last_words(job, index)}")  # fmt: skip
            submit(job, again, running)
        held = {task.shard for task in tasks if HELD.search(task.reason)} - silent
        if held:
            silent |= held
            say(f"held by Slurm: shards {ranges(sorted(held))}; release them: "
                f"scontrol release jobname={job.name}")  # fmt: skip
        if not again and done | given_up >= set(range(1, job.shards + 1)):
            say(f"{len(done)} of {job.shards} shards done")
            return sorted(given_up)
        now = progress(job, tasks, done)
        if not again and (now != said or time.monotonic() - last > 600):
            say(now)
            said, last = now, time.monotonic()
        time.sleep(SECONDS if not again else min(SECONDS, 1))


def follow_until_interrupted(job: Job) -> int:
    """Follows and merges; Ctrl-C leaves the jobs to themselves, twice cancels them."""
    follow_again = f"./run_all.sh --slurm-follow {shlex.quote(str(job.folder))}"
    try:
        given_up = follow(job)
    except KeyboardInterrupt:
        try:
            say(f"\nnot followed any more; the jobs go on. Follow them: {follow_again}; cancel them: "
                f"scancel --name={job.name}, or Ctrl-C again within {CANCEL_WITHIN} seconds")  # fmt: skip
            time.sleep(CANCEL_WITHIN)
        except KeyboardInterrupt:
            call("scancel", f"--user={getpass.getuser()}", f"--name={job.name}")
            say(f"cancelled; what is measured is kept. Go on: {follow_again}")
        return 130
    words = [job.bench, "merge", str(job.folder / "shards"), "--out", str(job.folder)]
    ended = subprocess.run(words + (["--allow-gaps"] if given_up else []))
    if given_up:
        say(f"without shards {ranges(given_up)}: correct the reason and go on: {follow_again}")
    return ended.returncode or bool(given_up)


def planned(bench: str, words: Sequence[str]) -> dict[str, int]:
    """How many meshes, pairs and cells. @raises SlurmError"""
    ended = subprocess.run([bench, "run", *words, "--plan"], capture_output=True, text=True)
    if ended.returncode != 0:
        raise SlurmError(ended.stderr.strip().removeprefix("geodesic-bench: "))
    found: dict[str, int] = json.loads(ended.stdout)
    return found


def write_script(job: Job, options: Sequence[str], words: Sequence[str]) -> None:
    """DIR/slurm.sh"""
    quoted = shlex.quote
    exports = "".join(
        f"export {name}={quoted(os.environ[name])}\n"
        for name in ("GEODESIC_DATASETS",)
        if os.environ.get(name)
    )
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
    """The folder with its script. @raises SlurmError"""
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
            job = Job.load(wish.folder.absolute())
            for shard in job.history.values():
                shard.fruitless = 0  # somebody looks after it again
            return follow_until_interrupted(job)
        job = new_job(wish)
        say(f"the batch script: {job.script} ({job.shards} shards)")
        if wish.write_only:
            return 0
        submit(job, range(1, job.shards + 1))
        say(f"submitted as {job.name}")
        return follow_until_interrupted(job)
    except (SlurmError, OSError) as error:
        print(f"run_all.sh: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        say("interrupted; what was submitted goes on")
        return 130


if __name__ == "__main__":
    sys.exit(main())
