"""Levels 0 to 3: answers, counters, instructions and memory, which do not depend on the machine's load.

The gate's level 1 compares with a baseline (baseline.py). Level 4 is in timing.py.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor

from results.reader import Cell

from gate.findings import REGRESSION, WRONG_ANSWER, LevelResult, Weight
from gate.measured import COUNTERS, MEMORY, MEMORY_FLOOR, UNSUPPORTED, WRONG, Measured, Number
from gate.program import NotCountableError, Program, Verified
from gate.progress import about, say

INSTRUCTIONS = "Instructions inside solve, counted by callgrind"
INSTRUCTIONS_FAIL = 0.02
INSTRUCTIONS_WARN = 0.005
"""Also the noise of a count."""
MEMORY_FAIL = 0.02
COUNTERS_FAIL = 0.01
CALLGRIND_MESHES = ("tiny-terrain", "tiny-torus", "tiny-plate")
"""The smallest meshes of the suite, because a program runs 50 times slower under callgrind."""
SECONDS_OF_COUNT = 2.5
"""Typical duration of one count, for the announcement of level 2."""


def answers(base: Verified, head: Verified) -> LevelResult:
    """Level 0. Judges every row of the head, in comparison with the base if the base has the row."""
    result = LevelResult(0, "Distances against the oracles")
    result.heading = ["solver", "rows right", "largest relative error", "state"]
    by_solver: dict[str, list[Measured]] = {}
    for cell, after in head.cells.items():
        by_solver.setdefault(cell.solver, []).append(after)
        _judge_answer(result, after, base.cells.get(cell))
    _only_in(result, "base", base.cells.keys() - head.cells.keys(), head.cells)
    _only_in(result, "head", head.cells.keys() - base.cells.keys(), base.cells)
    result.table = [_answer_line(solver, rows) for solver, rows in by_solver.items()]
    return result


def _judge_answer(result: LevelResult, after: Measured, before: Measured | None) -> None:
    if after.failure is None:
        result.compared += 1
        return
    outcome, text, state = after.failure.outcome, str(after.cell), after.state
    if outcome == WRONG:
        result.fail(text, WRONG_ANSWER, remark=state)
    elif before is not None and not before.ok:
        if outcome != UNSUPPORTED:
            result.add(Weight.WARNING, text, remark=f"{state} (as in the base)")
    elif before is not None:
        code = REGRESSION if outcome == UNSUPPORTED else WRONG_ANSWER
        result.fail(text, code, remark=f"{state} (the base solves it)")
    elif outcome != UNSUPPORTED:  # a new solver or mesh
        result.fail(text, WRONG_ANSWER, remark=state)


def _answer_line(solver: str, rows: list[Measured]) -> list[str]:
    errors = [row.number("max_relative_error") for row in rows if row.ok]
    outcomes = [row.failure.outcome for row in rows if row.failure is not None]
    wrong = outcomes.count(WRONG)
    state = f"WRONG ANSWER on {wrong}" if wrong else ", ".join(sorted(set(outcomes))) or "ok"
    largest = f"{max(error or 0.0 for error in errors):.1e}" if errors else "-"
    return [solver, f"{len(errors)} of {len(rows)}", largest, state]


def _only_in(
    result: LevelResult, side: str, cells: Iterable[Cell], others: Iterable[Cell]
) -> None:
    meaning = "new, nothing to compare with" if side == "head" else "removed or renamed"
    both = {cell.solver for cell in others}
    for name in sorted({str(cell) if cell.solver in both else cell.solver for cell in cells}):
        result.add(Weight.NOTE, name, remark=f"only in the {side}: {meaning}")


def common(base: Verified, head: Verified) -> list[tuple[Measured, Measured]]:
    """Returns the base's and head's measurements of the cells that both solved, in the head's order."""
    return [
        (base.cells[cell], after)
        for cell, after in head.cells.items()
        if after.ok and cell in base.cells and base.cells[cell].ok
    ]


def counters_heading(base: str) -> list[str]:
    return ["row", "counter", base, "head", "change"]


def judge_counters(
    result: LevelResult, cell: Cell, old: dict[str, int], new: dict[str, int], gain: str = ""
) -> list[str]:
    """Level 1 for a row. Returns the names of the counters that only one of the two has.

    @param gain what is said of a counter that has decreased"""
    for name in COUNTERS:
        before, after = old.get(name), new.get(name)
        if before is None or after is None or before == after:
            continue
        number = Number(before, after)
        result.table.append([str(cell), name, str(before), str(after), number.change])
        text = f"{cell}: {name} {number.change}, {before} to {after}"
        if after > before:
            result.judge_growth(text, number, cell.solver, COUNTERS_FAIL, warn=0)
        else:
            result.add(Weight.NOTE, text, remark=gain)
    return [name for name in COUNTERS if (name in old) != (name in new)]


def memory(base: Verified, head: Verified) -> LevelResult:
    """Level 3: the solver's peak memory."""
    result = LevelResult(3, "Solver's peak memory")
    result.heading = ["row", "base bytes", "head bytes", "change"]
    for before, after in common(base, head):
        old, new = (int(side.number(MEMORY) or 0) for side in (before, after))
        result.compared += 1
        if old == new:
            continue
        number, cell = Number(old, new), after.cell
        result.table.append([str(cell), f"{old}", f"{new}", number.change])
        text = f"{cell}: peak memory {number.change}, {old} to {new} bytes"
        result.judge_growth(text, number, cell.solver, MEMORY_FAIL, floor=MEMORY_FLOOR)
    return result


def instructions(
    base: Program, head: Program, base_run: Verified, head_run: Verified, processes: int
) -> LevelResult:
    """Level 2: instructions inside solve, counted by callgrind."""
    result = LevelResult(2, INSTRUCTIONS)
    compilers = [run.context["compiler"] for run in (base_run, head_run)]
    if shutil.which("valgrind") is None:
        result.skipped = "valgrind is not installed (Debian's package valgrind)"
    elif compilers[0] != compilers[1]:
        result.skipped = f"not comparable: {compilers[0]} built the base, {compilers[1]} the head"
    if result.skipped:
        return result
    both = [after.cell for _, after in common(base_run, head_run)]
    cells = [cell for cell in both if cell.mesh in CALLGRIND_MESHES]
    seconds = 2 * len(cells) * SECONDS_OF_COUNT / processes
    say(f"level 2: counting the instructions of {len(cells)} rows in base and head, {about(seconds)}")
    try:
        with ThreadPoolExecutor(processes) as pool:
            old_counts = pool.map(base.instructions, cells)
            new_counts = pool.map(head.instructions, cells)
            counts = list(zip(cells, old_counts, new_counts, strict=True))
    except NotCountableError as error:
        result.skipped = str(error)
        return result
    result.heading = ["row", "base", "head", "change"]
    differ = {
        cell.solver for cell, old, new in counts
        if Number(old, new).above(INSTRUCTIONS_WARN) or Number(new, old).above(INSTRUCTIONS_WARN)
    }  # fmt: skip
    result.same = [name for name in dict.fromkeys(c.solver for c in cells) if name not in differ]
    for cell, old, new in counts:
        number = Number(old, new)
        result.compared += 1
        result.table.append([str(cell), f"{old}", f"{new}", number.change])
        text = f"{cell}: {number.change} instructions inside solve, {old} to {new}"
        result.judge_growth(text, number, cell.solver, INSTRUCTIONS_FAIL, INSTRUCTIONS_WARN)
    flags = [run.context["compiler_flags"] for run in (base_run, head_run)]
    if flags[0] != flags[1]:
        result.add(Weight.NOTE, f"compiler flags differ: {flags[0]} / {flags[1]}")
    return result
