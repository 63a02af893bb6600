"""The report of a level of the gate: findings with a weight and a table. Also the exit codes."""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable
from dataclasses import dataclass, field
from enum import IntEnum
from typing import TypeVar

from gate.measured import Number

GOOD = 0
ERROR = 1
"""A usage or harness error: nothing was judged, or a required comparison is missing."""
WRONG_ANSWER = 2
"""A wrong answer, or a missing answer."""
REGRESSION = 3
NOT_RESOLVED = 4
"""Returned only with --strict."""


What = TypeVar("What", bound=Hashable)


class GateError(Exception):
    """Ends a command with ERROR; its message states what is wrong and what to do."""


class Weight(IntEnum):
    """How much a finding matters. Higher weights are reported first."""

    NOTE = 0
    WARNING = 1
    WITHIN_MARGIN = 2
    """Slower by less than the margin: not a failure, but not good."""
    NOT_RESOLVED = 3
    FAILURE = 4


@dataclass(frozen=True)
class Finding:
    level: int
    weight: Weight
    text: str
    """One line, which begins with the row or file concerned."""
    exit_code: int = 0
    """Exit code of a failure; 0 for other findings."""
    solver: str | None = None
    remark: str = ""
    """The end of the line if it can be the same for other rows. It is then printed once."""

    @property
    def line(self) -> str:
        return f"{self.text}: {self.remark}" if self.remark else self.text


def alike(said: Iterable[tuple[str, What]]) -> dict[What, list[str]]:
    """Returns the rows by what is said of them, in the order of what was said first.

    @param said pairs of a row and what is said of it"""
    rows: dict[What, list[str]] = {}
    for row, what in said:
        rows.setdefault(what, []).append(row)
    return rows


@dataclass
class LevelResult:
    level: int
    title: str
    compared: int = 0
    """Number of rows that were judged."""
    skipped: str = ""
    """Why the level was not run; empty if it was run."""
    heading: list[str] = field(default_factory=list)
    table: list[list[str]] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    same: list[str] = field(default_factory=list)
    """Level 2: the solvers none of whose counts differ by more than the noise."""

    @property
    def result(self) -> str:
        return f"skipped: {self.skipped}" if self.skipped else f"{self.compared} rows compared"

    def add(
        self, weight: Weight, text: str, exit_code: int = 0, solver: str | None = None,
        remark: str = "",
    ) -> None:
        self.findings.append(Finding(self.level, weight, text, exit_code, solver, remark))

    def fail(
        self, text: str, exit_code: int, solver: str | None = None, remark: str = ""
    ) -> None:
        self.add(Weight.FAILURE, text, exit_code, solver, remark)

    def judge_growth(
        self, text: str, number: Number, solver: str, fail: float,
        warn: float = math.inf, floor: float = 0,
    ) -> None:
        """Judges the growth of a number that does not depend on the machine's load.

        @param text one line that describes the change
        @param fail, warn growth, as a fraction, above which there is a failure or a warning
        @param floor absolute growth that is always accepted"""
        if number.above(fail, floor):
            self.fail(text, REGRESSION, solver)
        elif number.above(warn):
            self.add(Weight.WARNING, text, solver=solver)

    @property
    def failed(self) -> bool:
        """Whether the verdict is certain after this level, whatever the other levels find: no level
        takes a wrong answer or a regression back."""
        return any(f.exit_code in (WRONG_ANSWER, REGRESSION) for f in self.findings)

    def grew(self, solver: str) -> bool:
        """Whether a number of this solver increased at this level, even within its limit."""
        return any(f.solver == solver and f.weight != Weight.NOTE for f in self.findings)
