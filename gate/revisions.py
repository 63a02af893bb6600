"""Runs the levels on two programs, says the result of each when it ends, and returns the verdict."""

from __future__ import annotations

import itertools
import os
import shutil
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from results import environment
from results.names import unknown_name
from results.pairs import Pairs
from results.reader import Cell

from gate import baseline, code, levels, timing
from gate.findings import GateError, LevelResult, Weight
from gate.options import MARGIN
from gate.program import Program, Verified
from gate.progress import say
from gate.verdict import Verdict, judge, of_level

CORPUS = "regression"
ALL_LEVELS = (0, 1, 2, 3, 4)
BUDGET = 300.0
UNDECIDED = "not decided against the margin"
REPEAT = "repeat with a larger --budget, or on a quieter machine"


@dataclass(frozen=True)
class Options:
    out: Path
    """Folder for runs and reports."""
    levels: tuple[int, ...] = ALL_LEVELS
    margin: float = MARGIN
    """Largest ratio of times that level 4 accepts."""
    budget: float = BUDGET
    """Seconds that level 4 may spend on sessions after the first."""
    solvers: tuple[str, ...] = ()
    """Names of the solvers to judge; empty for all."""
    meshes: tuple[str, ...] = ()
    """Names of meshes of the manifest to use instead of the suite; empty for the suite."""
    strict: bool = False
    everything: bool = False
    """Measures on when the verdict is certain, and times solvers that did not change."""
    noise_file: Path | None = None
    """File in which --a-a stores the measured noise."""


def compare(base: Program, head: Program, tree: Path, options: Options) -> Verdict:
    """Runs the levels, those that need no further process first, until the verdict is certain.

    @param tree the head's files: the baseline of counters, and the sources of the solvers
    @raises GateError when the programs cannot be compared"""
    say("levels 0, 1 and 3: verifying and counting")
    with ThreadPoolExecutor() as pool:  # both at once: nothing is timed here
        base_run, head_run = pool.map(lambda program: verify(program, options), (base, head))
    results: list[LevelResult] = []

    def add(result: LevelResult) -> None:
        results.append(result)
        for line in of_level(result):
            say(line)

    def measure(level: int, title: str, measured: Callable[[], LevelResult]) -> None:
        failed = min((one.level for one in results if one.failed), default=None)
        if level not in options.levels:
            return
        if failed is None or options.everything:
            add(measured())
        else:
            why = f"level {failed} has failed, so that the verdict is certain (--all measures on)"
            add(LevelResult(level, title, skipped=why))

    environments: list[str] = []
    if base_run.run and head_run.run:
        environments = environment.differences_of_runs(base_run.run, head_run.run)
    for line in environments:
        say(line)
    add(levels.answers(base_run, head_run))  # always
    if 1 in options.levels:
        counters = baseline.read(tree)
        add(baseline.compare(counters, head_run, options.solvers or None))
    if 3 in options.levels:
        add(levels.memory(base_run, head_run))
    processes = os.cpu_count() or 1
    measure(2, levels.INSTRUCTIONS,
            lambda: levels.instructions(base, head, base_run, head_run, processes))  # fmt: skip
    measure(4, timing.TITLE, lambda: _time(base, head, tree, base_run, head_run, results, options))
    return judge(base.label, head.label, results, options.strict, environments)


def _time(
    base: Program, head: Program, tree: Path, base_run: Verified, head_run: Verified,
    earlier: Sequence[LevelResult], options: Options,
) -> LevelResult:
    rows = levels.common(base_run, head_run)
    cells = timing.timed_cells([before for before, _ in rows])
    if not cells:
        return LevelResult(4, timing.TITLE, skipped="base and head have no row in common")
    counted = {name for level in earlier for name in level.same}
    counted -= {after.cell.solver for before, after in rows if before.counters() != after.counters()}
    if options.everything:
        counted = set()
    same = code.unchanged(base.path.parent, head.path.parent, tree, counted)
    left = ", ".join(dict.fromkeys(cell.solver for cell in cells if cell.solver in same))
    why = f"{left}: not timed: nothing changed (machine code, counters, instructions)"
    cells = [cell for cell in cells if cell.solver not in same]
    if not cells:
        return LevelResult(4, timing.TITLE, skipped=why)
    if options.noise_file is not None:
        timing.check_margin(options.noise_file, _processor(head_run), cells, options.margin)
    grown = {
        cell.solver: level.level
        for level in sorted(earlier, key=lambda one: -one.level) if level.level in (1, 2)
        for cell in cells if level.grew(cell.solver)
    }  # fmt: skip
    timed = timing.Timing(options.margin, grown, options.everything)
    timing.measure(timed, cells, sessions(base, head, options), options.budget, say)
    result = timing.report(timed, f"{UNDECIDED} in {options.budget:g} s of further sessions: {REPEAT}")
    if left:
        result.add(Weight.NOTE, why)
    return result


def sessions(base: Program, head: Program, options: Options) -> timing.Session:
    """Returns a function that measures a session with the head's program into OUT/time-1, OUT/time-2, ..."""
    numbers = itertools.count(1)

    def session(cells: Sequence[Cell]) -> dict[Cell, Pairs]:
        chosen = _chosen(options, list(dict.fromkeys(cell.solver for cell in cells)))
        out = _empty(options.out / f"time-{next(numbers)}")
        return head.measure_pairs(base, chosen, cells, timing.PAIRS, out)

    return session


def verify(program: Program, options: Options) -> Verified:
    """@raises GateError for a solver that was named and does not exist"""
    known = program.solvers(options.solvers)
    solvers = [name for name in known if not options.solvers or name in options.solvers]
    if program.name == "head":
        for name in sorted(set(options.solvers) - set(known)):
            raise GateError(f"the head: {unknown_name('solver', name, known)}")
    if not solvers:  # all named solvers are new
        return Verified()
    return program.verify(_chosen(options, solvers), _empty(options.out / program.name))


def _chosen(options: Options, solvers: Sequence[str]) -> list[str]:
    meshes = ["--meshes", ",".join(options.meshes)] if options.meshes else ["--corpus", CORPUS]
    return [*meshes, "--solvers", ",".join(solvers)]


def _empty(folder: Path) -> Path:
    shutil.rmtree(folder, ignore_errors=True)
    return folder


def _processor(run: Verified) -> str:
    return str(run.context.get("processor", "unknown"))


def against_itself(program: Program, count: int, options: Options) -> Verdict:
    """--a-a: reports this machine's noise and stores it, so that later margins can be checked."""
    run = verify(program, options)
    cells = timing.timed_cells([row for row in run.cells.values() if row.ok])
    session = sessions(program, program, options)
    result, floors = timing.against_itself(cells, session, count, options.margin, say)
    if options.noise_file is not None and floors:
        timing.keep_noise(options.noise_file, _processor(run), floors)
    return judge(program.label, "itself", [result], options.strict)


def update_baseline(program: Program, tree: Path, reason: str, options: Options) -> Sequence[str]:
    """Updates the baseline if all answers are right. @raises GateError when an answer is wrong"""
    run = verify(program, options)
    failures = levels.answers(Verified(), run).findings
    wrong = [finding.line for finding in failures if finding.exit_code]
    if wrong:
        raise GateError(f"the baseline stays as it is: {wrong[0]}")
    return baseline.update(tree, run, reason)
