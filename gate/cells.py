"""The cells of a run, and times in pairs: what compare, rank and the gate judge by.

docs/measuring.md describes how pairs are measured, and why.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from results.reader import Cell, Row, Run
from results.schema import schema
from results.statistics import DECISION_CONFIDENCE, least_for_interval

TIME = "cpu_time"
MEMORY = "solver_peak_bytes"
COUNTERS = tuple(
    key
    for key, part in schema()["$defs"]["row"]["properties"].items()
    if part.get("$ref") == "#/$defs/counter"
)
"""The integer counters: equal in every run of one program."""

WRONG = "wrong answer"
UNSUPPORTED = "unsupported"

MEMORY_FLOOR = 64 * 1024
"""Bytes by which memory may always grow: a table that is doubled once more."""

MOST_STOLEN = 0.01
"""Of all processors' time."""
MOST_SWITCHES = 500.0
"""Involuntary switches a second of CPU time. A core shared with two or three others has 200 to 350,
at which the CPU times of paired solves still spread by only 2 to 3%."""


@dataclass(frozen=True)
class Measured:
    """Everything that a run, or one program of an interleaved run, has of a cell."""

    cell: Cell
    rows: list[Row]

    @property
    def failure(self) -> Row | None:
        """The first repetition that failed."""
        return next((row for row in self.rows if not row.ok), None)

    @property
    def ok(self) -> bool:
        return self.failure is None

    @property
    def state(self) -> str:
        """ "ok", or the outcome and its message."""
        return "ok" if self.failure is None else f"{self.failure.outcome}: {self.failure.message}"

    @property
    def times(self) -> list[float]:
        """Of one solve in milliseconds, a value a repetition."""
        return [row.time for row in self.rows if row.ok]

    def number(self, key: str) -> float | None:
        """A number that is the same in every repetition; None where the solver has none."""
        return next((n for row in self.rows if (n := row.number(key)) is not None), None)

    def counters(self) -> dict[str, int]:
        found = {name: self.number(name) for name in COUNTERS}
        return {name: int(value) for name, value in found.items() if value is not None}


def measured(run: Run, program: str | None = None) -> dict[Cell, Measured]:
    """@param program of an interleaved run: only what this one measured"""
    return {cell: Measured(cell, rows) for cell, rows in run.cells(program).items()}


def programs(run: Run) -> list[str]:
    """The labels of the programs of a run that has several."""
    return [program["name"] for program in run.ours.get("programs", [])]


@dataclass(frozen=True)
class Pairs:
    """CPU times of two sides of a cell in milliseconds, an entry a pair."""

    first: list[float]
    second: list[float]
    disturbed: int = 0
    """Pairs in which something disturbed one of the two."""

    @property
    def ratios(self) -> list[float]:
        """The second side's time over the first's."""
        return [b / a for a, b in zip(self.first, self.second, strict=True)]

    def __len__(self) -> int:
        return len(self.first)


def paired(first: Measured, second: Measured) -> Pairs:
    """The repetitions that both sides have, of one interleaved run.

    Pairs that were disturbed are left out while enough others for an interval remain.
    """
    by_repetition = {row.repetition: row for row in first.rows if _timed(row)}
    both = [
        (by_repetition[row.repetition], row)
        for row in second.rows
        if row.repetition in by_repetition and _timed(row)
    ]
    quiet = [pair for pair in both if not any(map(disturbed, pair))]
    kept = quiet if len(quiet) >= least_for_interval(DECISION_CONFIDENCE) else both
    return Pairs(
        first=[a.time for a, _ in kept],
        second=[b.time for _, b in kept],
        disturbed=len(both) - len(quiet),
    )


def together(parts: Iterable[Pairs]) -> Pairs:
    """The pairs of several sources, or of several runs, as one sample."""
    all_parts = list(parts)
    return Pairs(
        first=[time for part in all_parts for time in part.first],
        second=[time for part in all_parts for time in part.second],
        disturbed=sum(part.disturbed for part in all_parts),
    )


def disturbed(row: Row) -> bool:
    """Whether the hypervisor or other processes took too much of the time of this row's process."""
    stolen = row.number("stolen_share") or 0.0
    switches = row.number("involuntary_switches_per_s") or 0.0
    return stolen > MOST_STOLEN or switches > MOST_SWITCHES


def _timed(row: Row) -> bool:
    """A ratio needs times above 0."""
    return row.ok and row.time > 0
