"""The verdict of all levels: exit code, headline, text, Markdown and JSON."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from itertools import groupby
from pathlib import Path

from results.table import Table, markdown_page, text_fields, text_page

from gate.findings import ERROR, GOOD, NOT_RESOLVED, REGRESSION, WRONG_ANSWER
from gate.findings import Finding, GateError, LevelResult, Weight, alike

WORST_FIRST = (WRONG_ANSWER, REGRESSION, ERROR)
WORDS = {ERROR: "ERROR", WRONG_ANSWER: "WRONG ANSWER", REGRESSION: "REGRESSION"}
LABELS = {
    Weight.FAILURE: "FAILED",
    Weight.NOT_RESOLVED: "NOT RESOLVED",
    Weight.WITHIN_MARGIN: "slower within the margin",
    Weight.WARNING: "warning",
    Weight.NOTE: "note",
}


FIRST = 3
"""Number of findings of one level and weight that are printed above the tables, and of rows of one
remark."""


@dataclass(frozen=True)
class Verdict:
    base: str
    head: str
    levels: list[LevelResult]
    exit_code: int
    environments: list[str] = field(default_factory=list)
    """The differences of the environments of both sides, or one line that they agree."""

    @property
    def findings(self) -> list[Finding]:
        """All findings, failures first, then by level: the first cause comes first."""
        found = [finding for level in self.levels for finding in level.findings]
        return sorted(found, key=lambda finding: (-finding.weight, finding.level))

    @property
    def word(self) -> str:
        """The verdict in a word: "good" if nothing failed, is unresolved or is slower."""
        worst = max((finding.weight for finding in self.findings), default=Weight.NOTE)
        if self.exit_code in WORDS:
            return WORDS[self.exit_code]
        if worst == Weight.NOT_RESOLVED:
            return "NOT RESOLVED"
        return "SLOWER WITHIN THE MARGIN" if worst == Weight.WITHIN_MARGIN else "good"

    @property
    def headline(self) -> str:
        return f"{self.word}: {self.head} against {self.base}"


def judge(
    base: str, head: str, levels: Sequence[LevelResult], strict: bool, environments: Sequence[str] = ()
) -> Verdict:
    """@raises GateError when no row was compared"""
    findings = [finding for level in levels for finding in level.findings]
    failures = {finding.exit_code for finding in findings if finding.weight == Weight.FAILURE}
    unresolved = any(finding.weight == Weight.NOT_RESOLVED for finding in findings)
    if not failures and not unresolved and sum(level.compared for level in levels) == 0:
        why = "; ".join(f"level {x.level}: {x.skipped}" for x in levels if x.skipped)
        raise GateError(f"no row was compared{f' ({why})' if why else ''}")
    code = next((code for code in WORST_FIRST if code in failures), GOOD)
    if code == GOOD and unresolved and strict:
        code = NOT_RESOLVED
    return Verdict(base, head, sorted(levels, key=lambda level: level.level), code, list(environments))


def of_level(level: LevelResult) -> list[str]:
    """Returns the lines that are printed when a level ends."""
    findings = sorted(level.findings, key=lambda finding: -finding.weight)
    return [_title(level), *(f"  {line}" for line in _lines(findings))]


def as_text(verdict: Verdict) -> str:
    lines = [verdict.headline, *(f"  {line}" for line in _below(verdict))]
    return text_page(lines, map(_table, verdict.levels))


def as_markdown(verdict: Verdict) -> str:
    return markdown_page(verdict.headline, _below(verdict), map(_table, verdict.levels))


def _below(verdict: Verdict) -> list[str]:
    return [*_lines(verdict.findings), *verdict.environments]


def _lines(findings: Sequence[Finding]) -> list[str]:
    """Returns the first findings of each level and weight, with a remark about several rows once. The
    tables have all rows."""
    lines = []
    for (level, weight), group in groupby(findings, key=lambda f: (f.level, f.weight)):
        texts = []
        for remark, rows in alike((finding.text, finding.remark) for finding in group).items():
            texts += [f"{'; '.join(_first(rows))}: {remark}"] if remark else rows
        lines += [f"level {level} {LABELS[weight]}: {text}" for text in _first(texts)]
    return lines


def _first(texts: list[str]) -> list[str]:
    more = len(texts) - FIRST
    return [*texts[:FIRST], f"and {more} more, in the table"] if more > 1 else texts


def _title(level: LevelResult) -> str:
    return f"Level {level.level}. {level.title}: {level.result}"


def _table(level: LevelResult) -> Table:
    """Returns the table of a level; only its title if the level has no rows."""
    heading = level.heading if level.table else []
    return Table("", _title(level), heading, 1, [text_fields(row) for row in level.table])


def as_json(verdict: Verdict) -> str:
    data = {
        "verdict": verdict.word,
        "exit_code": verdict.exit_code,
        "base": verdict.base,
        "head": verdict.head,
        "environments": verdict.environments,
        "levels": [asdict(level) for level in verdict.levels],
    }
    return json.dumps(data, indent=1) + "\n"


def write(verdict: Verdict, folder: Path) -> None:
    (folder / "verdict.md").write_text(as_markdown(verdict), encoding="utf-8")
    (folder / "verdict.json").write_text(as_json(verdict), encoding="utf-8")
