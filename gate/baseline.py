"""Level 1: integer counters compared with the committed counters in results/baseline/.

The file has one line per row. A change of an algorithm is therefore a readable diff.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Collection
from datetime import date
from pathlib import Path

from results.reader import Cell, Source
from results.text import read_text

from gate.findings import ERROR, GateError, LevelResult, Weight
from gate.levels import counters_heading, judge_counters
from gate.measured import COUNTERS
from gate.program import Verified

FOLDER = Path("results") / "baseline"
FILE = "counters.csv"
CHANGES = "CHANGES.md"
KEEP = "--update-baseline keeps the gain"
KEY = ["solver", "mesh", "source"]
Counters = dict[Cell, dict[str, int]]


def changed(tree: Path) -> dict[str, str]:
    """Returns the day of the last recorded change of a solver's counters, by solver."""
    days: dict[str, str] = {}
    day = ""
    for line in read_text(tree / FOLDER / CHANGES).splitlines():
        if line.startswith("## "):
            day = line[3:]
        elif line.startswith("- "):
            days[line[2:].split(":")[0]] = day
    return days


def counters_of(run: Verified) -> Counters:
    """Returns the integer counters of every cell that succeeded and has counters."""
    found = {cell: one.counters() for cell, one in run.cells.items() if one.ok}
    return {cell: numbers for cell, numbers in found.items() if numbers}


def read(tree: Path) -> Counters:
    """@raises GateError when the baseline is missing or is not a table of counters"""
    file = tree / FOLDER / FILE
    try:
        return dict(_entry(line) for line in csv.DictReader(io.StringIO(read_text(file))))
    except FileNotFoundError:
        raise GateError(
            f"{file}: no baseline of counters; ./check_performance.sh --update-baseline writes it"
        ) from None
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise GateError(f"{file}: not a table of counters: {error}") from None


def _source(text: str) -> Source:
    return int(text) if text.isdecimal() else text


def _entry(line: dict[str, str]) -> tuple[Cell, dict[str, int]]:
    cell = Cell(line["solver"], line["mesh"], _source(line["source"]))
    return cell, {name: int(line[name]) for name in COUNTERS if line[name] != ""}


def as_csv(counters: Counters) -> str:
    text = io.StringIO()
    lines = csv.writer(text, lineterminator="\n")
    lines.writerow([*KEY, *COUNTERS])
    for cell in sorted(counters):
        numbers = counters[cell]
        values = [numbers.get(name, "") for name in COUNTERS]
        lines.writerow([cell.solver, cell.mesh, cell.source, *values])
    return text.getvalue()


def compare(
    baseline: Counters, run: Verified, solvers: Collection[str] | None = None
) -> LevelResult:
    """@param solvers names of the solvers to compare; None for all"""
    result = LevelResult(1, "The algorithms' counters against the committed baseline")
    result.heading = counters_heading("baseline")
    counted = counters_of(run)
    expected = {c: n for c, n in baseline.items() if solvers is None or c.solver in solvers}
    for cell in sorted(expected.keys() & counted.keys()):
        result.compared += 1
        for name in judge_counters(result, cell, expected[cell], counted[cell], KEEP):
            result.fail(f"{cell}: {name}", ERROR, remark="only one of the two has this counter")
    _missing(result, sorted(expected.keys() - counted.keys()), run)
    new = {f"{cell.solver} on {cell.mesh}" for cell in counted.keys() - baseline.keys()}
    if new:
        result.add(
            Weight.WARNING,
            f"not in the baseline yet, so not judged: {', '.join(sorted(new))};"
            " --update-baseline adds them",
        )
    return result


def _missing(result: LevelResult, cells: list[Cell], run: Verified) -> None:
    """Reports the rows of the baseline that the run has not measured as errors."""
    gone = [cell for cell in cells if cell not in run.cells]  # level 0 reports the cells that failed
    meshes_left = {cell.mesh for cell in run.cells}
    for solver in sorted({cell.solver for cell in gone if cell.mesh in meshes_left}):
        why = "in the baseline and not in the head: removed, or renamed? If meant, --update-baseline"
        result.fail(solver, ERROR, remark=why)
    for mesh in sorted({cell.mesh for cell in gone} - meshes_left):
        why = "in the baseline and no mesh of the suite any more. If meant, --update-baseline"
        result.fail(mesh, ERROR, remark=why)


def update(tree: Path, run: Verified, reason: str) -> list[str]:
    """Rewrites the baseline, appends to its history and returns the changes as lines of text."""
    file = tree / FOLDER / FILE
    old = read(tree) if file.exists() else {}
    new = counters_of(run)
    if not new:
        raise GateError("no row has counters: the baseline stays as it is")
    changes = summary(old, new)
    if not changes:
        return [f"{file}: nothing changed"]
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(as_csv(new), encoding="utf-8")
    history = file.parent / CHANGES
    before = history.read_text(encoding="utf-8") if history.exists() else HISTORY
    lines = "\n".join(f"- {change}" for change in changes)
    history.write_text(f"{before}\n## {date.today()}\n\n{reason}\n\n{lines}\n", encoding="utf-8")
    return [*changes, f"written: {file}, and why in {history}"]


HISTORY = """# Changes of the counter baseline

Every rewriting of `counters.csv` by `./check_performance.sh --update-baseline --reason "..."`:
why it was accepted, and what changed.
"""


def summary(old: Counters, new: Counters) -> list[str]:
    """Returns one line per solver and changed counter, with the range of the relative changes."""
    lines = []
    for what, cells in (("new", new.keys() - old.keys()), ("gone", old.keys() - new.keys())):
        for solver in sorted({cell.solver for cell in cells}):
            meshes = sorted(cell.mesh for cell in cells if cell.solver == solver)
            lines.append(f"{solver}: {what} on {', '.join(meshes)}")
    for solver in sorted({cell.solver for cell in new}):
        for name in COUNTERS:
            ratios = _ratios(old, new, solver, name)
            if ratios:
                lines.append(
                    f"{solver}: {name} {min(ratios) - 1:+.2%} to {max(ratios) - 1:+.2%}"
                    f" on {len(ratios)} meshes"
                )
    return lines


def _ratios(old: Counters, new: Counters, solver: str, name: str) -> list[float]:
    """Returns the ratios new / old that are not 1. A counter that was 0 or missing counts as doubled."""
    both = [(old[cell].get(name), new[cell].get(name)) for cell in new if cell in old
            and cell.solver == solver]  # fmt: skip
    return [(b or 0) / a if a else 2.0 for a, b in both if a != b]
