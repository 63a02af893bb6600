"""Runs that are killed at random moments and resumed until they end.

These runs are small and use everything that a run can have: several meshes, sources and solvers,
repetitions, recordings.
"""

from __future__ import annotations

import hashlib
import random
import re
import shutil
import signal
import subprocess
import time
from pathlib import Path

SOLVERS = "edge-based,ich,mmp,dijkstra"
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)

VARYING = (
    "real_time cpu_time iterations prepare_time mesh_time propagation trimming queue "
    "timer_overhead process_peak_bytes date started finished checksum mhz_per_cpu executable "
    "memory_limit load stolen_share involuntary_switches_per_s solver_peak_bytes"
).split()
"""Keys whose values are times or depend on times or on other processes of the machine. solver_peak_bytes
is one of them: malloc adds 16 bytes to a block if the rest of a free chunk is too small to be split off.
This depends on earlier calls of free."""

_VARYING_LINE = re.compile(r'^\s*"(' + "|".join(VARYING) + r')": .*$', re.MULTILINE)
_LOAD = re.compile(r'"load_avg": \[[^\]]*\]')


class Lost(Exception):
    """A kill destroyed or changed data, or left a process running."""


def without_times(text: str) -> str:
    return _VARYING_LINE.sub("", _LOAD.sub("", text))


def contents(run: Path) -> dict[str, bytes]:
    """Returns the contents of all files of a run, by path, without times."""
    files = {}
    for file in sorted(run.rglob("*")):
        if file.is_file():
            data = file.read_bytes()
            if file.suffix == ".json":
                data = without_times(data.decode("utf-8")).encode("utf-8")
            files[str(file.relative_to(run))] = data
    return files


def processes_of(folder: Path) -> list[int]:
    """Returns the processes whose command lines contain the folder."""
    found = []
    for entry in Path("/proc").iterdir():
        try:
            if entry.name.isdigit() and str(folder).encode() in (entry / "cmdline").read_bytes():
                found.append(int(entry.name))
        except OSError:
            continue  # the process has ended
    return found


def two_meshes(bench: Path, folder: Path) -> str:
    """Generates a box and a terrain in a folder. Returns their files as an argument of `run --meshes`."""
    sizes = {
        "box": ["--x-cells", "6", "--y-cells", "5", "--z-cells", "4"],
        "terrain": ["--columns", "12", "--rows", "9"],
    }
    files = [str(folder / f"{kind}.ply") for kind in sizes]
    for kind, file in zip(sizes, files, strict=True):
        command = [str(bench), "generate", kind, *sizes[kind], "-o", file]
        subprocess.run(command, check=True, capture_output=True)
    return ",".join(files)


class Killing:
    def __init__(self, bench: Path, folder: Path, seed: int) -> None:
        self.bench = bench.resolve()
        self.folder = folder
        self.random = random.Random(seed)
        self.runs = self.kills = 0
        self.meshes = two_meshes(self.bench, folder)
        began = time.monotonic()
        whole = self._work()
        ended = self._start(whole, resume=False).wait()
        if ended != 0:
            raise Lost(f"the uninterrupted run ended with {ended}")
        self.seconds = time.monotonic() - began
        self.expected = contents(whole / "run")

    def _work(self) -> Path:
        """Returns the folder of a run. All its names have the same length, because the lengths of earlier
        names change the free blocks of the heap and the peak of malloc."""
        return self.folder / f"run-{self.runs:04}"

    def _start(self, work: Path, resume: bool) -> subprocess.Popen[str]:
        work.mkdir(exist_ok=True)
        words = ["--resume", "run"]
        if not resume:
            words = ["--meshes", self.meshes, "--solvers", SOLVERS, "--sources", "2", "--repetitions",
                     "2", "--min-time", "0.001", "--recordings", "all", "--out", "run"]
        with (work / "errors").open("w", encoding="utf-8") as errors:
            return subprocess.Popen(
                [str(self.bench), "run", *words], cwd=work, text=True, stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL, stderr=errors,
            )  # fmt: skip

    def until_killed(self, most: int) -> None:
        """Kills and resumes runs until there were `most` kills. Each run must end with the files of an
        uninterrupted run. Raises Lost if one does not."""
        while self.kills < most:
            self.runs += 1
            self._one_run(most)

    def _one_run(self, most: int) -> None:
        work = self._work()
        saved: dict[Path, str] = {}
        while True:
            process = self._start(work, resume=(work / "run" / "request.json").exists())
            if self.kills < most:
                self._kill(process)
            code = process.wait()
            if code == 0:
                break
            self._look_after(work, code)
            saved = self._cells_unchanged(work, saved)
        self._cells_unchanged(work, saved)
        self._same_as_uninterrupted(work)
        shutil.rmtree(work)

    def _kill(self, process: subprocess.Popen[str]) -> None:
        """Kills a run at a random moment. Early moments are more likely, because a resumed run is shorter."""
        delay = self.seconds * self.random.random() ** 2
        try:
            process.wait(delay)
        except subprocess.TimeoutExpired:
            process.send_signal(self.random.choice(SIGNALS))
            self.kills += 1

    def _look_after(self, work: Path, code: int) -> None:
        """Checks the exit code and the message of a killed process, and that no process is left."""
        errors = (work / "errors").read_text("utf-8")
        own = {130: signal.SIGINT, 143: signal.SIGTERM}
        if code in own:
            if "cells are saved in" not in errors or "--resume" not in errors:
                raise Lost(f"{own[code].name}: does not say how to go on:\n{errors}")
        elif code not in [-each for each in SIGNALS]:
            raise Lost(f"exit code {code}:\n{errors}")
        deadline = time.monotonic() + 5
        while left := processes_of(self.folder):  # it contains the meshes
            if time.monotonic() > deadline:
                raise Lost(f"processes {left} run on after exit code {code}")
            time.sleep(0.01)

    def _cells_unchanged(self, work: Path, before: dict[Path, str]) -> dict[Path, str]:
        cells = {
            file: hashlib.sha256(file.read_bytes()).hexdigest()
            for file in (work / "run" / "cells").glob("*.json")
        }
        for file, digest in before.items():
            if cells.get(file) != digest:
                raise Lost(f"{file} was saved and has been measured again or lost")
        return cells

    def _same_as_uninterrupted(self, work: Path) -> None:
        found = contents(work / "run")
        if found.keys() != self.expected.keys():
            raise Lost(f"other files: {sorted(found.keys() ^ self.expected.keys())}")
        for name, data in self.expected.items():
            if found[name] != data:
                (self.folder / "expected").write_bytes(data)
                (self.folder / "found").write_bytes(found[name])
                raise Lost(f"{name} differs: compare {self.folder}/expected with found")
