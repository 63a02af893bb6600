"""Levels 0, 2 and 3: answers, instructions and memory. None of them depends on the machine's mood.

Level 1 is in baseline.py, level 4 in pairs.py.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor

from .errors import REGRESSION, WRONG
from .findings import LevelResult, Weight
from .program import Cell, Program, Row, Run

INSTRUCTIONS_FAIL = 0.02
INSTRUCTIONS_WARN = 0.005
MEMORY_FAIL = 0.02
MEMORY_FLOOR = 64 * 1024
"""Bytes by which memory may always grow: a table that is doubled once more."""
CALLGRIND_MESHES = ("tiny-terrain", "tiny-torus", "tiny-plate")
"""Callgrind is 50 times slower than the processor: the smallest of the suite."""

UNSUPPORTED = "unsupported"


def answers(base: Run, head: Run) -> LevelResult:
    """Level 0. Every row of the head is judged; the base tells what was there before."""
    result = LevelResult(0, "Distances against the oracles")
    result.heading = ["solver", "rows", "largest relative error"]
    errors: dict[str, list[float]] = {}
    for cell, row in head.rows.items():
        before = base.rows.get(cell)
        if row.ok:
            result.compared += 1
            errors.setdefault(cell.solver, []).append(row.numbers["max_relative_error"])
        elif row.outcome == "wrong answer":
            result.add(Weight.FAILURE, f"{cell}: wrong answer: {row.message}", WRONG)
        elif before is None or before.ok:
            _no_answer(result, row, before)
        elif row.outcome != UNSUPPORTED:
            result.add(Weight.WARNING, f"{cell}: {row.outcome}, as in the base: {row.message}")
    _only_in(result, "base", base.rows.keys() - head.rows.keys())
    _only_in(result, "head", head.rows.keys() - base.rows.keys())
    for solver, values in errors.items():
        result.table.append([solver, str(len(values)), f"{max(values):.1e}"])
    return result


def _no_answer(result: LevelResult, row: Row, before: Row | None) -> None:
    """A cell that should have distances and has none."""
    text = f"{row.cell}: {row.outcome}: {row.message}"
    if before is None and row.outcome == UNSUPPORTED:
        return  # a new solver or mesh, and the solver says itself that it cannot
    if before is not None:
        text += " (the base solves it)"
    result.add(Weight.FAILURE, text, REGRESSION if row.outcome == UNSUPPORTED else WRONG)


def _only_in(result: LevelResult, side: str, cells: Iterable[Cell]) -> None:
    for solver in sorted({cell.solver for cell in cells}):
        meaning = "new: nothing to compare with" if side == "head" else "removed or renamed"
        result.add(Weight.NOTE, f"{solver}: only in the {side}, {meaning}")


def _growth(before: float, after: float) -> float:
    return after / before - 1


def memory(base: Run, head: Run) -> LevelResult:
    """Level 3."""
    result = LevelResult(3, "Solver's peak memory")
    result.heading = ["row", "base bytes", "head bytes", "change"]
    for cell, before, after in _both_ok(base, head):
        old, new = (row.numbers["solver_peak_bytes"] for row in (before, after))
        result.compared += 1
        change = f"{_growth(old, new):+.2%}"
        if old != new:
            result.table.append([str(cell), f"{old}", f"{new}", change])
        if new > old * (1 + MEMORY_FAIL) and new - old > MEMORY_FLOOR:
            text = f"{cell}: peak memory {change}, {old} to {new} bytes"
            result.add(Weight.FAILURE, text, REGRESSION, cell.solver)
    return result


def _both_ok(base: Run, head: Run) -> list[tuple[Cell, Row, Row]]:
    return [
        (cell, base.rows[cell], row)
        for cell, row in head.rows.items()
        if row.ok and cell in base.rows and base.rows[cell].ok
    ]


def common_cells(base: Run, head: Run) -> list[Cell]:
    """Cells that both solved, in the head's order."""
    return [cell for cell, _, _ in _both_ok(base, head)]


def instructions(
    base: Program, head: Program, base_run: Run, head_run: Run, processes: int
) -> LevelResult:
    """Level 2."""
    result = LevelResult(2, "Instructions inside solve, counted by callgrind")
    compilers = [run.context["compiler"] for run in (base_run, head_run)]
    if shutil.which("valgrind") is None:
        result.skipped = "valgrind is not installed (Debian's package valgrind)"
    elif compilers[0] != compilers[1]:
        result.skipped = f"not comparable: {compilers[0]} built the base, {compilers[1]} the head"
    if result.skipped:
        return result
    cells = [cell for cell in common_cells(base_run, head_run) if cell.mesh in CALLGRIND_MESHES]
    with ThreadPoolExecutor(processes) as pool:
        old_counts = pool.map(base.instructions, cells)
        new_counts = pool.map(head.instructions, cells)
        counts = list(zip(cells, old_counts, new_counts, strict=True))
    result.heading = ["row", "base", "head", "change"]
    for cell, old, new in counts:
        _judge_instructions(result, cell, old, new)
    flags = [run.context["compiler_flags"] for run in (base_run, head_run)]
    if flags[0] != flags[1]:
        result.add(Weight.NOTE, f"compiler flags differ: {flags[0]} / {flags[1]}")
    return result


def _judge_instructions(result: LevelResult, cell: Cell, old: int, new: int) -> None:
    growth = _growth(old, new)
    result.compared += 1
    result.table.append([str(cell), f"{old}", f"{new}", f"{growth:+.2%}"])
    text = f"{cell}: {growth:+.2%} instructions inside solve, {old} to {new}"
    if growth > INSTRUCTIONS_FAIL:
        result.add(Weight.FAILURE, text, REGRESSION, cell.solver)
    elif growth > INSTRUCTIONS_WARN:
        result.add(Weight.WARNING, text, solver=cell.solver)
