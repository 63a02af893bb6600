"""Level 4: time, base and head by turns in fresh processes: A B, B A, A B, ...

A session is 15 pairs of one row. The row is slower when the third smallest of the 15 ratios is
above the margin: were there no difference, a ratio above 1 would be the toss of a coin, and 13 or
more of 15 come up with a probability of 0.4%. One session only makes it suspect; a second one, or
level 1 or 2 of the same solver, makes it a regression.
"""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from . import machine
from .errors import REGRESSION
from .findings import LevelResult, Weight
from .program import Cell, Program, Run

PAIRS = 15
RANK = 3
SOLVES = 4
"""In a process; the first touches fresh memory and is not counted, the least of the others is."""
LEAST_MS = 10.0
MOST_MS = 150.0
"""Only rows between these are timed: shorter ones drown in noise, longer ones take too long."""
FLOOR_MS = 1.0
"""A regression is at least this much longer."""
REDO_PAIR = 3
REDO_SESSION = 10

Say = Callable[[str], None]


@dataclass(frozen=True)
class Session:
    base: list[float]
    head: list[float]
    """Milliseconds, in the order of the pairs."""
    redone: int
    disturbed: str
    """Why the session cannot be judged; empty when it can."""

    @property
    def ratios(self) -> list[float]:
        return [head / base for base, head in zip(self.base, self.head, strict=True)]

    @property
    def statistic(self) -> float:
        return sorted(self.ratios)[RANK - 1]

    @property
    def growth_ms(self) -> float:
        return statistics.median(self.head) - statistics.median(self.base)

    @property
    def noise(self) -> float:
        return noise([self.base, self.head])

    def slower(self, margin: float) -> bool:
        return self.statistic > margin and self.growth_ms > FLOOR_MS


def noise(series: Sequence[Sequence[float]]) -> float:
    """Spread of the ratio of two neighbouring times of the same build: 1.04 means 4%.

    One standard deviation, estimated by the median of the logarithms' absolute values.
    """
    logs = [abs(math.log(b / a)) for times in series for a, b in zip(times, times[1:])]
    return math.exp(1.4826 * statistics.median(logs))


def measure(base: Program, head: Program, cell: Cell) -> Session:
    """One session. A pair that something disturbed is measured again, a few times at most."""
    times: dict[bool, list[float]] = {True: [], False: []}  # of the base: True
    redone = 0
    for pair in range(PAIRS):
        order = [True, False] if pair % 2 == 0 else [False, True]
        for attempt in range(REDO_PAIR + 1):
            before = machine.now()
            taken = {which: _time(base if which else head, cell) for which in order}
            disturbed = machine.disturbance(before, machine.now())
            if not disturbed:
                break
            redone += 1
            if attempt == REDO_PAIR or redone > REDO_SESSION:
                return Session([], [], redone, disturbed)
        for which, milliseconds in taken.items():
            times[which].append(milliseconds)
    return Session(times[True], times[False], redone, "")


def _time(program: Program, cell: Cell) -> float:
    return min(program.solve_ms(cell, SOLVES)[1:])


def timed_cells(cells: Sequence[Cell], base: Run) -> list[Cell]:
    """Those whose base is neither too short nor too long; ratios of less say little."""
    return [c for c in cells if LEAST_MS <= base.rows[c].numbers["cpu_time"] <= MOST_MS]


def times(
    base: Program,
    head: Program,
    cells: Sequence[Cell],
    margin: float,
    earlier: Sequence[LevelResult],
    say: Say,
) -> LevelResult:
    """Level 4.

    @param earlier the results of levels 1 and 2, where one growing makes a suspect a regression
    """
    result = LevelResult(4, f"Time, {PAIRS} pairs by turns, margin {margin:g}")
    result.heading = ["row", "base ms", "head ms", "median", f"{_ordinal()} of {PAIRS}", "noise"]
    for number, cell in enumerate(cells, 1):
        say(f"level 4: {number}/{len(cells)} {cell}")
        session = measure(base, head, cell)
        if session.disturbed:
            result.add(Weight.INCONCLUSIVE, f"{cell}: not timed: {session.disturbed}")
            continue
        result.compared += 1
        result.table.append(_line(cell, session))
        if session.noise > margin:
            result.add(
                Weight.INCONCLUSIVE,
                f"{cell}: noise of {session.noise - 1:.1%} here is above the margin",
            )
        elif session.slower(margin):
            grown = next((level.level for level in earlier if level.up(cell.solver)), None)
            _confirm(result, cell, session, margin, grown, lambda: measure(base, head, cell))
    return result


def _confirm(
    result: LevelResult,
    cell: Cell,
    first: Session,
    margin: float,
    grown: int | None,
    again: Callable[[], Session],
) -> None:
    """A suspect becomes a regression, or not."""
    text = f"{cell}: {statistics.median(first.ratios):.3f} times as long (median of pairs)"
    if grown is not None:
        result.add(
            Weight.FAILURE, f"{text}; level {grown} is up as well", REGRESSION, cell.solver
        )
        return
    second = again()
    if second.disturbed:
        result.add(
            Weight.INCONCLUSIVE,
            f"{text}, and a second session could not be timed: {second.disturbed}",
        )
        return
    result.table.append(_line(cell, second, "again"))
    if second.slower(margin):
        result.add(Weight.FAILURE, f"{text}, again in a second session", REGRESSION, cell.solver)
    else:
        result.add(Weight.NOTE, f"{text}, but not in a second session")


def _line(cell: Cell, session: Session, which: str = "") -> list[str]:
    return [
        f"{cell} {which}".strip(),
        f"{statistics.median(session.base):.2f}",
        f"{statistics.median(session.head):.2f}",
        f"{statistics.median(session.ratios):.3f}",
        f"{session.statistic:.3f}",
        f"{session.noise - 1:.1%}",
    ]


def _ordinal() -> str:
    return {1: "1st", 2: "2nd", 3: "3rd"}.get(RANK, f"{RANK}th")
