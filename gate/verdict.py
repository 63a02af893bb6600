"""The verdict of all levels: as an exit code, as text, Markdown and JSON."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from .errors import ERROR, GOOD, INCONCLUSIVE, REGRESSION, WRONG, GateError
from .findings import Finding, LevelResult, Weight

WORST_FIRST = (WRONG, REGRESSION, ERROR)
WORDS = {
    GOOD: "good",
    ERROR: "error",
    WRONG: "WRONG ANSWER",
    REGRESSION: "REGRESSION",
    INCONCLUSIVE: "inconclusive",
}
LABELS = {
    Weight.FAILURE: "FAILED",
    Weight.INCONCLUSIVE: "inconclusive",
    Weight.WARNING: "warning",
    Weight.NOTE: "note",
}


@dataclass(frozen=True)
class Verdict:
    base: str
    head: str
    levels: list[LevelResult]
    exit_code: int

    @property
    def findings(self) -> list[Finding]:
        """Failures first, and of those the lowest level: the first cause."""
        found = [finding for level in self.levels for finding in level.findings]
        return sorted(found, key=lambda finding: (-finding.weight, finding.level))

    @property
    def headline(self) -> str:
        return f"{WORDS[self.exit_code]}: {self.head} against {self.base}"


def judge(base: str, head: str, levels: Sequence[LevelResult], strict: bool) -> Verdict:
    """@raises GateError when nothing at all was compared: that is not green"""
    findings = [finding for level in levels for finding in level.findings]
    failures = {finding.exit_code for finding in findings if finding.weight == Weight.FAILURE}
    undecided = any(finding.weight == Weight.INCONCLUSIVE for finding in findings)
    if not failures and not undecided and sum(level.compared for level in levels) == 0:
        why = "; ".join(f"level {x.level}: {x.skipped}" for x in levels if x.skipped)
        raise GateError(f"no row was compared{f' ({why})' if why else ''}: that is not green")
    code = next((code for code in WORST_FIRST if code in failures), GOOD)
    if code == GOOD and undecided and strict:
        code = INCONCLUSIVE
    return Verdict(base, head, list(levels), code)


def as_text(verdict: Verdict) -> str:
    lines = [verdict.headline]
    lines += [f"  level {f.level} {LABELS[f.weight]}: {f.text}" for f in verdict.findings]
    for level in verdict.levels:
        lines += ["", _title(level)]
        if level.table:
            lines += _aligned([level.heading, *level.table])
    return "\n".join(lines) + "\n"


def as_markdown(verdict: Verdict) -> str:
    lines = [f"## {verdict.headline}", ""]
    lines += [f"- level {f.level} **{LABELS[f.weight]}**: {f.text}" for f in verdict.findings]
    for level in verdict.levels:
        lines += ["", f"### {_title(level)}", ""]
        if level.table:
            rows = [level.heading, ["---"] * len(level.heading), *level.table]
            lines += [f"| {' | '.join(row)} |" for row in rows]
    return "\n".join(lines) + "\n"


def as_json(verdict: Verdict) -> str:
    data = {
        "verdict": WORDS[verdict.exit_code],
        "exit_code": verdict.exit_code,
        "base": verdict.base,
        "head": verdict.head,
        "levels": [asdict(level) for level in verdict.levels],
    }
    return json.dumps(data, indent=1) + "\n"


def write(verdict: Verdict, folder: Path) -> None:
    (folder / "verdict.md").write_text(as_markdown(verdict), encoding="utf-8")
    (folder / "verdict.json").write_text(as_json(verdict), encoding="utf-8")


def _title(level: LevelResult) -> str:
    what = f"skipped: {level.skipped}" if level.skipped else f"{level.compared} rows compared"
    return f"Level {level.level}. {level.title}: {what}"


def _aligned(table: list[list[str]]) -> list[str]:
    widths = [max(len(row[column]) for row in table) for column in range(len(table[0]))]
    return [
        "  " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip()
        for row in table
    ]
