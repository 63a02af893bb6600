"""All levels on two programs: what is run, in which order, and what comes of it."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from . import baseline, levels, noise, pairs
from .errors import GateError
from .findings import LevelResult
from .program import Cell, Program, Run
from .verdict import Verdict, judge

CORPUS = "regression"
ALL_LEVELS = (0, 1, 2, 3, 4)
MARGIN = 1.10


@dataclass(frozen=True)
class Options:
    out: Path
    """Folder for runs and reports."""
    levels: tuple[int, ...] = ALL_LEVELS
    margin: float = MARGIN
    solvers: tuple[str, ...] = ()
    """All when empty."""
    meshes: tuple[str, ...] = ()
    """Of the manifest, in place of the suite when not empty."""
    strict: bool = False
    noise_file: Path | None = None
    """Where --a-a keeps what it measured."""


def say(line: str) -> None:
    """Progress: to the error stream, so that the verdict alone is the output."""
    print(line, file=sys.stderr, flush=True)


def processors() -> int:
    return os.cpu_count() or 1


def check(base: Program, head: Program, baseline_tree: Path, options: Options) -> Verdict:
    """@raises GateError when the programs cannot be compared"""
    base_run, head_run = run_both(base, head, options)
    results: list[LevelResult] = []
    # Level 0 always: of a wrong answer nothing else is worth knowing.
    results.append(levels.answers(base_run, head_run))
    if 1 in options.levels:
        counters = baseline.read(baseline_tree)
        results.append(baseline.compare(counters, head_run, options.solvers or None))
    if 2 in options.levels:
        say("level 2: counting instructions")
        results.append(levels.instructions(base, head, base_run, head_run, processors()))
    if 3 in options.levels:
        results.append(levels.memory(base_run, head_run))
    if 4 in options.levels:
        cells = timed_cells(base_run, head_run, options)
        causes = [result for result in results if result.level in (1, 2)]
        results.append(pairs.times(base, head, cells, options.margin, causes, say))
    return judge(base.label, head.label, results, options.strict)


def timed_cells(base_run: Run, head_run: Run, options: Options) -> list[Cell]:
    """What level 4 times. @raises GateError when the margin is below the noise of one of them"""
    cells = pairs.timed_cells(levels.common_cells(base_run, head_run), base_run)
    if options.noise_file is not None:
        processor = head_run.context["processor"]
        noise.check_margin(options.noise_file, processor, cells, options.margin)
    return cells


def run_both(base: Program, head: Program, options: Options) -> tuple[Run, Run]:
    """Both at once: nothing is timed here."""
    say("levels 0, 1 and 3: verifying and counting")
    with ThreadPoolExecutor() as pool:
        both = list(pool.map(lambda program: run_one(program, options), (base, head)))
    return both[0], both[1]


def run_one(program: Program, options: Options) -> Run:
    """@raises GateError for a solver that was asked for and is not there"""
    known = program.solvers(options.solvers)
    solvers = [name for name in known if not options.solvers or name in options.solvers]
    if program.name == "head":
        unknown = sorted(set(options.solvers) - set(known))
        if unknown:
            raise GateError(
                f"the head has no solver {', '.join(unknown)}; there are {', '.join(known)}"
            )
    out = options.out / program.name
    shutil.rmtree(out, ignore_errors=True)
    if not solvers:  # all those asked for are new
        return Run({}, {})
    return program.run(CORPUS, options.meshes, solvers, out)


def against_itself(program: Program, sessions: int, options: Options) -> Verdict:
    """--a-a: reports this machine's noise and keeps it for later margins."""
    run = run_one(program, options)
    cells = pairs.timed_cells(list(levels.common_cells(run, run)), run)
    result, floors = noise.against_itself(program, cells, sessions, options.margin, say)
    if options.noise_file is not None and floors:
        noise.keep(options.noise_file, run.context["processor"], floors)
    return judge(program.label, "itself", [result], options.strict)


def update_baseline(program: Program, tree: Path, reason: str, options: Options) -> Sequence[str]:
    """Of right answers only. @raises GateError when there are wrong ones"""
    run = run_one(program, options)
    failures = levels.answers(Run({}, {}), run).findings
    wrong = [finding.text for finding in failures if finding.exit_code]
    if wrong:
        raise GateError(f"the baseline stays as it is: {wrong[0]}")
    return baseline.update(tree, run, reason)
