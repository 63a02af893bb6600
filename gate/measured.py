"""What a run measured of each cell: what compare, rank and the gate judge by."""

from __future__ import annotations

import math
from collections.abc import Iterable
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
"""Bytes by which memory may always grow: a table that is doubled once more."""


@dataclass(frozen=True)
class Number:
    """Of the old and the new side; it may grow up to a limit."""

    old: float
    new: float
    unit: str = ""

    @property
    def ratio(self) -> float:
        return self.new / self.old if self.old else math.inf

    @property
    def change(self) -> str:
        """ "+2.18%" """
        return f"{self.ratio - 1:+.2%}" if self.old else "new"

    def above(self, limit: float | None, floor: float = 0) -> bool:
        """Whether it has grown by more than the limit, as a fraction, and by more than the floor."""
        grown = limit is not None and self.new > (1 + limit) * self.old
        return grown and self.new - self.old > floor

    def __str__(self) -> str:
        return f"{self.ratio:.4g} times ({self.old:.6g}{self.unit} to {self.new:.6g}{self.unit})"


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

    def numbers(self, keys: Iterable[str]) -> dict[str, float]:
        """Those that the solver has."""
        return {key: value for key in keys if (value := self.number(key)) is not None}

    def counters(self) -> dict[str, int]:
        return {name: int(value) for name, value in self.numbers(COUNTERS).items()}


def measured(run: Run, program: str | None = None) -> dict[Cell, Measured]:
    """@param program of an interleaved run: only what this one measured"""
    return {cell: Measured(cell, rows) for cell, rows in run.cells(program).items()}


def programs(run: Run) -> list[str]:
    """The labels of the programs of a run that has several."""
    return [program["name"] for program in run.ours.get("programs", [])]
