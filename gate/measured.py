"""The measurements of each cell of a run, which compare, rank and the gate judge."""

from __future__ import annotations

import math
from dataclasses import dataclass

from results.reader import Cell, Row, Run
from results.schema import schema

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
"""Growth of memory in bytes that is always accepted, such as one more doubling of a table."""


@dataclass(frozen=True)
class Number:
    """A number on the old and the new side, and its growth."""

    old: float
    new: float
    unit: str = ""

    @property
    def ratio(self) -> float:
        return self.new / self.old if self.old else math.inf

    @property
    def change(self) -> str:
        """The relative change as text, such as "+2.18%"; "new" if the old number is 0."""
        return f"{self.ratio - 1:+.2%}" if self.old else "new"

    def above(self, limit: float | None, floor: float = 0) -> bool:
        """Whether the growth exceeds both the limit, a fraction, and the floor. False for limit None."""
        grown = limit is not None and self.new > (1 + limit) * self.old
        return grown and self.new - self.old > floor

    def __str__(self) -> str:
        return f"{self.ratio:.4g} times ({self.old:.6g}{self.unit} to {self.new:.6g}{self.unit})"


@dataclass(frozen=True)
class Measured:
    """All rows of a cell in a run, or those of one program of an interleaved run."""

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
        """The text "ok", or the outcome and message of the failure."""
        return "ok" if self.failure is None else f"{self.failure.outcome}: {self.failure.message}"

    @property
    def times(self) -> list[float]:
        """Times of one solve in milliseconds, one per successful repetition."""
        return [row.time for row in self.rows if row.ok]

    def number(self, key: str) -> float | None:
        """Returns a number that is equal in all repetitions, or None if the solver does not have it."""
        return next((n for row in self.rows if (n := row.number(key)) is not None), None)

    def counters(self) -> dict[str, int]:
        return {key: int(value) for key in COUNTERS if (value := self.number(key)) is not None}


def measured(run: Run, program: str | None = None) -> dict[Cell, Measured]:
    """@param program label of a program of an interleaved run: selects its rows only"""
    return {cell: Measured(cell, rows) for cell, rows in run.cells(program).items()}


def programs(run: Run) -> list[str]:
    """Returns the labels of the run's programs; empty if it names none."""
    return [program["name"] for program in run.ours.get("programs", [])]
