"""What a level says: findings, worst first, and a table."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum


class Weight(IntEnum):
    """How much a finding matters; the higher comes first."""

    NOTE = 0
    WARNING = 1
    INCONCLUSIVE = 2
    FAILURE = 3


@dataclass(frozen=True)
class Finding:
    level: int
    weight: Weight
    text: str
    """One line that begins with the row or the file that it is about."""
    exit_code: int = 0
    """Of a failure."""
    solver: str | None = None


@dataclass
class LevelResult:
    level: int
    title: str
    compared: int = 0
    """Rows that were judged."""
    skipped: str = ""
    """Why the level was not run, if it was not."""
    heading: list[str] = field(default_factory=list)
    table: list[list[str]] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)

    def add(
        self, weight: Weight, text: str, exit_code: int = 0, solver: str | None = None
    ) -> None:
        self.findings.append(Finding(self.level, weight, text, exit_code, solver))

    def up(self, solver: str) -> bool:
        """Whether something of this solver grew here, be it within what is allowed."""
        return any(f.solver == solver and f.weight != Weight.NOTE for f in self.findings)
