#!/usr/bin/python3
"""Does the gate find known faults, and nothing else? Runs it many times on each.

    tests/gate/study.py --programs build/ci [--runs 20] [--a-a 40] [--only slower-15,a-a]

The faults are in programs of their own (faulty_solve.cpp); the base is geodesic-bench from the same
build folder. During half of the A/A runs another process loads one core. Prints a table in Markdown
and exits with 1 when a fault was found less often than docs/regression-gate.md promises.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from gate import baseline, check, levels  # noqa: E402  (needs the path above)
from gate.findings import GOOD, REGRESSION, WRONG_ANSWER, Weight  # noqa: E402
from gate.program import NotCountableError, Program  # noqa: E402
from gate.verdict import Verdict  # noqa: E402

SOLVERS = ("ich", "fwp-mmp", "mmp")
MESHES = (*levels.CALLGRIND_MESHES, "needles")
AMOUNT = "GEODESIC_FAULT_AMOUNT"


@dataclass(frozen=True)
class Fault:
    name: str
    what: str
    levels: tuple[int, ...]
    found_by: int | None
    """The lowest level that must fail; None: no level, and the word must not be "good"."""
    exit_code: int
    promised: float = 1.0
    """Share of the runs in which it must be found."""
    percent: int = 0
    """Of a slow-down."""

    @property
    def program(self) -> str:
        return self.name.split("-")[0]


FAULTS = (
    Fault("wrong", "one distance of one solver off by 1e-9", (0,), 0, WRONG_ANSWER),
    Fault("windows", "5% more window propagations", (0, 1), 1, REGRESSION),
    Fault("instructions", "5% more instructions", (0, 2), 2, REGRESSION),
    Fault("memory", "10% more memory", (0, 3), 3, REGRESSION),
    Fault("slower-25", "25% more time, nothing else", check.ALL_LEVELS, 4, REGRESSION, 0.95, 25),
    Fault("slower-15", "15% more time, nothing else", check.ALL_LEVELS, 4, REGRESSION, 0.95, 15),
    Fault("slower-8", "8% more time, nothing else", check.ALL_LEVELS, None, GOOD, 1.0, 8),
)
A_A = Fault("a-a", "the base itself", check.ALL_LEVELS, None, GOOD)


class Study:
    """Programs, meshes and a baseline in a folder of its own."""

    def __init__(self, programs: Path, folder: Path, meshes: Path) -> None:
        self._programs, self._folder, self._meshes = programs, folder, meshes
        self._base = self._program("base", programs / "geodesic-bench")
        fetch = [sys.executable, str(ROOT / "datasets" / "fetch.py"), *MESHES]
        subprocess.run(
            [*fetch, "--cache", str(meshes), "--bench", str(self._base.path)],
            check=True, stdout=subprocess.DEVNULL,
        )  # fmt: skip
        self.base_run = check.verify(self._base, self._options((0,)))
        file = folder / baseline.FOLDER / baseline.FILE
        file.parent.mkdir(parents=True)
        file.write_text(baseline.as_csv(baseline.counters_of(self.base_run)))

    def _program(self, name: str, path: Path) -> Program:
        return Program(name, path.name, path, self._meshes, ROOT / "datasets" / "manifest.json")

    def _options(self, chosen: tuple[int, ...]) -> check.Options:
        return check.Options(self._folder, chosen, solvers=SOLVERS, meshes=MESHES)

    def run(self, fault: Fault) -> Verdict:
        faulty = self._programs / "tests" / f"geodesic-bench-{fault.program}"
        os.environ[AMOUNT] = str(self._amount(fault))
        head = self._program("head", self._base.path if fault is A_A else faulty)
        return check.check(self._base, head, self._folder, self._options(fault.levels))

    def _amount(self, fault: Fault) -> int:
        """Per cent of time, 5% of the instructions of mmp on tiny-terrain, or 10% of its memory on
        needles."""
        if fault.percent:
            return fault.percent
        rows = self.base_run.cells
        if fault.name == "instructions":
            [cell] = [c for c in rows if (c.solver, c.mesh) == ("mmp", "tiny-terrain")]
            return self._base.instructions(cell) // 20
        [cell] = [c for c in rows if (c.solver, c.mesh) == ("mmp", "needles")]
        return int(rows[cell].number("solver_peak_bytes") or 0) // 10


@contextlib.contextmanager
def loaded_core(wanted: bool) -> Iterator[None]:
    if not wanted:
        yield
        return
    burner = subprocess.Popen([sys.executable, "-c", "while True: pass"])
    try:
        yield
    finally:
        burner.kill()
        burner.wait()


@dataclass(frozen=True)
class Ended:
    """The outcome of a run."""

    exit_code: int
    failed: int | None
    """The lowest level that failed."""
    word: str

    def found(self, fault: Fault) -> bool:
        """8% may be a regression, be slower within the margin or not resolved, but not good."""
        if fault.found_by is None and fault is not A_A:
            return self.word != "good"
        return (self.exit_code, self.failed) == (fault.exit_code, fault.found_by)


def ended(verdict: Verdict) -> Ended:
    failed = [f.level for f in verdict.findings if f.weight == Weight.FAILURE]
    return Ended(verdict.exit_code, min(failed, default=None), verdict.word)


def repeat(study: Study, fault: Fault, runs: int, loaded: bool) -> list[Ended]:
    with loaded_core(loaded):
        return [ended(study.run(fault)) for _ in range(runs)]


def line(fault: Fault, where: str, runs: list[Ended], seconds: float) -> str:
    found = sum(run.found(fault) for run in runs)
    words = ", ".join(f"{word}: {n}" for word, n in sorted(Counter(r.word for r in runs).items()))
    by = "no level" if fault.found_by is None else f"level {fault.found_by}"
    return (
        f"| {fault.what}{where} | {by} | {found} of {len(runs)} | {words}"
        f" | {seconds / len(runs):.0f} s |"
    )


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    names = [fault.name for fault in (*FAULTS, A_A)]
    parser.add_argument("--programs", type=Path, required=True, help="a build folder")
    parser.add_argument("--runs", type=int, default=20, help="of each fault (default: 20)")
    parser.add_argument("--a-a", type=int, default=40, help="runs without a fault (default: 40)")
    parser.add_argument("--only", default=",".join(names), help=f"some of {', '.join(names)}")
    return parser.parse_args()


def main() -> int:
    options = parse()
    only = options.only.split(",")
    plan = [(f, "", options.runs, False) for f in FAULTS if f.name in only]
    if A_A.name in only:
        half = options.a_a // 2
        plan += [(A_A, ", alone", options.a_a - half, False), (A_A, ", beside a load", half, True)]
    missed = False
    print("| change | to be failed by | as it should be | verdicts | a run |")
    print("| --- | --- | --- | --- | --- |", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        study = Study(options.programs.absolute(), work, work / "meshes")
        for fault, where, runs, loaded in plan:
            if runs == 0:
                continue
            began = time.monotonic()
            try:
                results = repeat(study, fault, runs, loaded)
            except NotCountableError as error:
                print(f"| {fault.what} | | {error} | | |", flush=True)
                continue
            print(line(fault, where, results, time.monotonic() - began), flush=True)
            missed |= sum(r.found(fault) for r in results) < fault.promised * runs
    return int(missed)


if __name__ == "__main__":
    sys.exit(main())
