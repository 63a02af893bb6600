#!/usr/bin/python3
"""Does the gate find known faults, and nothing else? Runs it many times on each.

    tools/gate_study.py --programs build/ci [--runs 20] [--a-a 40] [--budget 60]
                        [--only slower-15,a-a]

The faults are those of geodesic-bench-faulty (faulty_solve.cpp); the base is geodesic-bench from
the same build folder. Faults that level 4 alone can find are judged by level 4 alone, on three rows
of one solver. During half of the A/A runs another process loads one core. Prints a line for each
run as it ends, with the ratios of level 4; then, after Ctrl-C too, a table in Markdown. Exits with
1 when a fault was found less often than docs/regression-gate.md promises.
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
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from gate import baseline, levels, revisions  # noqa: E402  (needs the path above)
from gate.findings import GOOD, REGRESSION, WRONG_ANSWER, Weight  # noqa: E402
from gate.program import NotCountableError, Program  # noqa: E402
from gate.verdict import Verdict  # noqa: E402

SOLVERS: tuple[str, ...] = ("ich", "fwp-mmp", "mmp")
MESHES: tuple[str, ...] = (*levels.CALLGRIND_MESHES, "needles")
COUNTED_SOLVERS = ("mmp",)
COUNTED_MESHES = ("tiny-terrain",)
"""The meshes and solvers of level 2. Callgrind takes seconds per row, and every solver has the fault."""
TIMED_SOLVERS = ("ich",)
TIMED_MESHES = ("icosphere", "needles", "growth-10k")
"""Meshes and solvers of level 4, with rows of 4 to 20 ms."""


def failed_level(verdict: Verdict) -> int | None:
    """Returns the lowest level that failed, or None."""
    failed = (f.level for f in verdict.findings if f.weight == Weight.FAILURE)
    return min(failed, default=None)


@dataclass(frozen=True)
class Fault:
    name: str
    what: str
    levels: tuple[int, ...]
    """Levels to judge, in addition to level 0."""
    found_by: int | None
    """The lowest level that must fail. None if no level may fail; the verdict must not be "good"."""
    exit_code: int
    promised: float = 1.0
    """Share of the runs in which the fault must be found."""
    percent: int = 0
    """Percentage of a slow-down."""

    @property
    def kind(self) -> str:
        """The name of the fault in faulty_solve.cpp."""
        return self.name.split("-")[0]

    def found(self, verdict: Verdict) -> bool:
        """Whether the verdict is right. For 8% it may be any verdict but "good"."""
        if self.found_by is None and self is not A_A:
            return verdict.word != "good"
        return (verdict.exit_code, failed_level(verdict)) == (self.exit_code, self.found_by)


FAULTS = (
    Fault("wrong", "one distance of one solver off by 1e-9", (0,), 0, WRONG_ANSWER),
    Fault("windows", "5% more window propagations", (0, 1), 1, REGRESSION),
    Fault("instructions", "5% more instructions", (0, 2), 2, REGRESSION),
    Fault("memory", "10% more memory", (0, 3), 3, REGRESSION),
    Fault("slower-25", "25% more time, nothing else", (4,), 4, REGRESSION, 0.95, 25),
    Fault("slower-15", "15% more time, nothing else", (4,), 4, REGRESSION, 0.95, 15),
    Fault("slower-8", "8% more time, nothing else", (4,), None, GOOD, 1.0, 8),
)
A_A = Fault("a-a", "the base itself", (4,), None, GOOD)


class Study:
    """Programs, meshes and a baseline in a separate folder."""

    def __init__(self, programs: Path, folder: Path, budget: float = revisions.BUDGET) -> None:
        self._programs, self._folder, self._budget = programs, folder, budget
        self._meshes = folder / "meshes"
        self._base = self._program("base", programs / "geodesic-bench")
        fetch = [sys.executable, str(ROOT / "datasets" / "fetch.py"), *{*MESHES, *TIMED_MESHES}]
        subprocess.run(
            [*fetch, "--cache", str(self._meshes), "--bench", str(self._base.path)],
            check=True, stdout=subprocess.DEVNULL,
        )  # fmt: skip
        self.base_run = revisions.verify(self._base, self._options((0,)))
        file = folder / baseline.FOLDER / baseline.FILE
        file.parent.mkdir(parents=True)
        file.write_text(baseline.as_csv(baseline.counters_of(self.base_run)))

    def _program(self, name: str, path: Path) -> Program:
        return Program(name, path.name, path, self._meshes, ROOT / "datasets" / "manifest.json")

    def _options(self, chosen: tuple[int, ...]) -> revisions.Options:
        timed = 4 in chosen
        solvers, meshes = SOLVERS, MESHES
        if timed:
            solvers, meshes = TIMED_SOLVERS, TIMED_MESHES
        elif 2 in chosen:
            solvers, meshes = COUNTED_SOLVERS, COUNTED_MESHES
        return revisions.Options(
            self._folder, chosen, budget=self._budget, solvers=solvers, meshes=meshes
        )

    def run(self, fault: Fault) -> Verdict:
        faulty = self._programs / "tests" / "geodesic-bench-faulty"
        os.environ["GEODESIC_FAULT"] = fault.kind
        os.environ["GEODESIC_FAULT_AMOUNT"] = str(self._amount(fault))
        head = self._program("head", self._base.path if fault is A_A else faulty)
        return revisions.compare(self._base, head, self._folder, self._options(fault.levels))

    def _amount(self, fault: Fault) -> int:
        """Returns the percentage of time, 5% of the instructions of mmp on tiny-terrain, or 10% of its
        memory on needles."""
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


@dataclass
class Series:
    """The runs of one fault."""

    fault: Fault
    wanted: int
    loaded: bool = False
    runs: list[Verdict] = field(default_factory=list)
    seconds: float = 0.0
    not_countable: str = ""

    @property
    def found(self) -> int:
        return sum(map(self.fault.found, self.runs))

    @property
    def missed(self) -> bool:
        return self.found < self.fault.promised * len(self.runs)

    def measure(self, study: Study) -> None:
        with loaded_core(self.loaded):
            while len(self.runs) < self.wanted:
                began = time.monotonic()
                try:
                    self.runs.append(study.run(self.fault))
                except NotCountableError as error:
                    self.not_countable = str(error)
                    return
                taken = time.monotonic() - began
                self.seconds += taken
                print(self._last(taken), flush=True)

    def _last(self, seconds: float) -> str:
        run = self.runs[-1]
        parts = [f"{run.word}, {seconds:.0f} s"]
        for level in run.levels:
            if level.level == 4:
                parts += [row[level.heading.index("head/base")] for row in level.table]
        if not self.fault.found(run):
            parts.append("not as it should be")
        name = f"{self.fault.name}{' loaded' * self.loaded}"
        return f"{name} {len(self.runs)} of {self.wanted}: {', '.join(parts)}"

    def line(self) -> str:
        """Returns the row of the table."""
        what, by = self.fault.what, self.fault.found_by
        if self.fault is A_A:
            what += ", beside a load" if self.loaded else ", alone"
        if not self.runs:
            return f"| {what} | | {self.not_countable} | | |"
        words = sorted(Counter(run.word for run in self.runs).items())
        return (
            f"| {what} | {'no level' if by is None else f'level {by}'}"
            f" | {self.found} of {len(self.runs)} | {', '.join(f'{w}: {n}' for w, n in words)}"
            f" | {self.seconds / len(self.runs):.0f} s |"
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
    parser.add_argument(
        "--budget", type=float, default=revisions.BUDGET, metavar="SECONDS",
        help=f"of level 4 for sessions beyond the first (default: {revisions.BUDGET:g})",
    )  # fmt: skip
    return parser.parse_args()


def planned(options: argparse.Namespace) -> list[Series]:
    only = options.only.split(",")
    half = options.a_a // 2
    plan = [Series(fault, options.runs) for fault in FAULTS]
    plan += [Series(A_A, options.a_a - half), Series(A_A, half, loaded=True)]
    return [series for series in plan if series.fault.name in only and series.wanted > 0]


def main() -> int:
    options = parse()
    plan = planned(options)
    with tempfile.TemporaryDirectory() as folder, contextlib.suppress(KeyboardInterrupt):
        study = Study(options.programs.absolute(), Path(folder), options.budget)
        for series in plan:
            series.measure(study)
    print("\n| change | to be failed by | as it should be | verdicts | a run |")
    print("| --- | --- | --- | --- | --- |")
    for series in plan:
        if series.runs or series.not_countable:
            print(series.line())
    return int(any(series.missed for series in plan))


if __name__ == "__main__":
    sys.exit(main())
