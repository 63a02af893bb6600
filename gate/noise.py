"""This machine's noise: a build against itself, and the margins that it forbids."""

from __future__ import annotations

import json
import statistics
from collections.abc import Sequence
from pathlib import Path

from .errors import REGRESSION, GateError
from .findings import LevelResult, Weight
from .pairs import PAIRS, Say, Session, measure
from .program import Cell, Program


def against_itself(
    program: Program, cells: Sequence[Cell], sessions: int, margin: float, say: Say
) -> tuple[LevelResult, dict[str, float]]:
    """--a-a N: each row's spread over N sessions; and its noise, as the gate keeps it."""
    result = LevelResult(4, f"One build against itself, {sessions} sessions of {PAIRS} pairs")
    result.heading = ["row", "ms", "noise", "median ratios", "statistics", "red"]
    floors: dict[str, float] = {}
    for number, cell in enumerate(cells, 1):
        say(f"a-a: {number}/{len(cells)} {cell}")
        measured = [measure(program, program, cell) for _ in range(sessions)]
        quiet = [session for session in measured if not session.disturbed]
        if len(quiet) < len(measured):
            why = next(session.disturbed for session in measured if session.disturbed)
            lost = len(measured) - len(quiet)
            result.add(Weight.INCONCLUSIVE, f"{cell}: {lost} sessions not timed: {why}")
        if quiet:
            result.compared += 1
            floors[str(cell)] = max(session.noise for session in quiet)
            _report(result, cell, quiet, margin)
    return result, floors


def _report(result: LevelResult, cell: Cell, sessions: list[Session], margin: float) -> None:
    medians = [statistics.median(session.ratios) for session in sessions]
    judged = [session.statistic for session in sessions]
    red = sum(session.slower(margin) for session in sessions)
    result.table.append([
        str(cell),
        f"{statistics.median(time for s in sessions for time in s.base):.2f}",
        f"{max(session.noise for session in sessions) - 1:.1%}",
        f"{min(medians):.3f} to {max(medians):.3f}",
        f"{min(judged):.3f} to {max(judged):.3f}",
        f"{red} of {len(sessions)}",
    ])  # fmt: skip
    if red:
        result.add(Weight.FAILURE, f"{cell}: red against itself", REGRESSION)


def keep(file: Path, processor: str, floors: dict[str, float]) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps({"processor": processor, "noise": floors}, indent=1) + "\n")


def check_margin(file: Path, processor: str, cells: Sequence[Cell], margin: float) -> None:
    """@raises GateError when --a-a measured more noise in one of these rows than the margin."""
    try:
        kept = json.loads(file.read_text(encoding="utf-8"))
        floors = kept["noise"] if kept["processor"] == processor else {}
    except (OSError, ValueError, KeyError):
        return  # not measured: every session still looks at its own noise
    for cell in cells:
        floor = floors.get(str(cell), 1.0)
        if margin < floor:
            raise GateError(
                f"the margin {margin:g} is below this machine's noise of {cell}, {floor:.3f}"
                f" ({file}): use --margin {_rounded_up(floor)} or more, or a quieter machine"
            )


def _rounded_up(value: float) -> str:
    """Two digits, rounded up."""
    return f"{-(-value * 100 // 1) / 100:.2f}"
