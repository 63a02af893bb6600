"""`geodesic-bench compare`: what differs between two runs, or between the two programs of one run.

A time fails a limit in two cases only: in an interleaved run, where pairs decide a cell; and as the
geometric mean over the cells of a solver, whose interval must lie above the limit. A single cell of
two separate runs is shown and never fails, because the machine may have drifted between the runs.
"""

from __future__ import annotations

import json
import math
import re
import statistics
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from results import console

if __name__ == "__main__":
    console.prepare("geodesic-bench compare")  # before imports that may fail

from results.console import Parser, complain, printable  # noqa: E402
from results.reader import Cell, ResultError, Run, read_run  # noqa: E402
from results.statistics import (  # noqa: E402
    Decision,
    Estimate,
    decide,
    geometric_mean_of_medians,
    geometric_mean_of_ratios,
    rank_test,
)
from results.table import Table, escape_markdown, text_cells, to_markdown, to_text  # noqa: E402

from .cells import COUNTERS, MEMORY, WRONG, Measured, measured, paired, programs  # noqa: E402
from .findings import REGRESSION, WRONG_ANSWER, GateError  # noqa: E402

SIGNIFICANCE = 0.01
"""Of the rank test for a cell of two separate runs."""
LEAST_REPETITIONS = 5
"""Of either side for that: 2 / C(10, 5) = 0.008."""
LEAST_CELLS = 3
"""Of a mean that may fail: fewer say little about a solver."""
MEMORY_FLOOR = 64 * 1024
"""Bytes by which memory may always grow: a table that is doubled once more."""
SAME_BUILD = ("processor", "compiler", "compiler_flags", "build_type")

SEPARATE = (
    "times are of two separate runs, so they include a drift of the machine between them:"
    " `run --program old=FILE --program new=FILE` measures both programs in pairs"
)


@dataclass(frozen=True)
class Change:
    """A number of the old and the new side."""

    old: float
    new: float

    @property
    def ratio(self) -> float:
        return self.new / self.old if self.old else math.inf

    def exceeds(self, limit: float) -> bool:
        return self.new > (1 + limit) * self.old


@dataclass(frozen=True)
class TimeChange:
    """Medians of CPU time in milliseconds."""

    old: float
    new: float
    ratio: float
    resolved: bool
    evidence: dict[str, float]
    """What `resolved` follows from: `p`, or `low`, `high` and `pairs`."""
    ratios: list[float]
    """Of the pairs; empty for two separate runs."""


@dataclass(frozen=True)
class CellChange:
    old: Measured
    new: Measured
    time: TimeChange | None
    counters: dict[str, Change]
    """Those that differ."""
    memory: Change | None

    @property
    def name(self) -> str:
        return str(self.new.cell)

    @property
    def lost(self) -> bool:
        return self.old.ok and not self.new.ok

    @property
    def wrong(self) -> bool:
        return self.new.failure is not None and self.new.failure.outcome == WRONG


@dataclass(frozen=True)
class Mean:
    """Geometric mean of the cells' ratios of time, of a solver or of all."""

    of: str
    cells: int
    ratio: Estimate


@dataclass
class Comparison:
    interleaved: bool
    cells: list[CellChange] = field(default_factory=list)
    means: list[Mean] = field(default_factory=list)
    """One a solver, "all" last; empty without times."""
    only_old: list[str] = field(default_factory=list)
    only_new: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def compare(old: Run, new: Run) -> Comparison:
    """Two separate runs. @raises GateError when they cannot be compared"""
    _check_meshes(old, new)
    result = Comparison(interleaved=False, notes=_differences(old.ours, new.ours))
    times = old.ours["processor"] == new.ours["processor"]
    if not times:
        result.notes.append("times of different processors are not compared")
    sides = measured(old), measured(new)
    _compare_cells(result, *sides, times=times)
    if not result.cells:
        raise GateError(f"nothing to compare: {old.file} and {new.file} have no cell in common")
    if times:
        result.notes.append(SEPARATE)
    if any(min(len(c.old.times), len(c.new.times)) < LEAST_REPETITIONS for c in _timed(result)):
        result.notes.append(
            f"cells with fewer than {LEAST_REPETITIONS} repetitions cannot be resolved: run with"
            f" --repetitions {LEAST_REPETITIONS}"
        )
    return result


def compare_programs(run: Run) -> Comparison:
    """The two programs of an interleaved run. @raises GateError when it has not two"""
    names = programs(run)
    if len(names) != 2:
        have = ", ".join(names) if names else "no programs"
        raise GateError(
            f"{run.file}: a single run is compared when it was measured with two --program; it has"
            f" {have}. Give two runs otherwise"
        )
    result = Comparison(interleaved=True, notes=_differences(*run.ours["programs"]))
    result.notes.append(f"old is {names[0]}, new is {names[1]}")
    _compare_cells(result, measured(run, names[0]), measured(run, names[1]), times=True)
    return result


def _check_meshes(old: Run, new: Run) -> None:
    if old.ours["corpus"] != new.ours["corpus"]:
        raise GateError(
            f"different corpora cannot be compared: {old.file} is of {old.ours['corpus']},"
            f" {new.file} of {new.ours['corpus']}"
        )
    for name, mesh in new.meshes.items():
        if name in old.meshes and old.meshes[name].sha256 != mesh.sha256:
            raise GateError(
                f"mesh {name} is another file in {new.file} than in {old.file}: what was measured"
                " on it cannot be compared"
            )


def _differences(old: dict[str, Any], new: dict[str, Any]) -> list[str]:
    return [
        f"the {key} differs: {old[key]} / {new[key]}"
        for key in SAME_BUILD
        if key in old and key in new and old[key] != new[key]
    ]


def _compare_cells(
    result: Comparison, old: dict[Cell, Measured], new: dict[Cell, Measured], times: bool
) -> None:
    for cell, after in new.items():
        if cell not in old:
            result.only_new.append(str(cell))
            continue
        before = old[cell]
        time = _time_change(before, after, result.interleaved) if times else None
        counters = {name: _change(name, before, after) for name in COUNTERS}
        differing = {name: c for name, c in counters.items() if c is not None and c.old != c.new}
        memory = _change(MEMORY, before, after)
        result.cells.append(CellChange(before, after, time, differing, memory))
    result.only_old = [str(cell) for cell in old if cell not in new]
    by_solver: dict[str, list[CellChange]] = {}
    for change in _timed(result):
        by_solver.setdefault(change.new.cell.solver, []).append(change)
    result.means = [_mean(solver, by_solver[solver]) for solver in sorted(by_solver)]
    if by_solver:
        result.means.append(_mean("all", _timed(result)))


def _change(key: str, old: Measured, new: Measured) -> Change | None:
    before, after = old.number(key), new.number(key)
    return None if before is None or after is None else Change(before, after)


def _time_change(old: Measured, new: Measured, interleaved: bool) -> TimeChange | None:
    if not (old.ok and new.ok):
        return None
    if not interleaved:
        before, after = statistics.median(old.times), statistics.median(new.times)
        p = rank_test(old.times, new.times)
        if before <= 0 or after <= 0:
            return None
        return TimeChange(before, after, after / before, p <= SIGNIFICANCE, {"p": p}, [])
    pairs = paired(old, new)
    if len(pairs) == 0:
        return None
    judged = decide(pairs.ratios, 1)
    ratio = judged.ratio
    evidence = {"low": ratio.low, "high": ratio.high, "pairs": len(pairs)}
    return TimeChange(
        old=statistics.median(pairs.first),
        new=statistics.median(pairs.second),
        ratio=ratio.value,
        resolved=judged.decision in (Decision.SLOWER, Decision.FASTER),
        evidence=evidence,
        ratios=pairs.ratios,
    )


def _timed(comparison: Comparison) -> list[CellChange]:
    return [change for change in comparison.cells if change.time is not None]


def _mean(of: str, changes: Sequence[CellChange]) -> Mean:
    ratios = [change.time.ratios for change in changes if change.time is not None]
    if all(ratios):
        return Mean(of, len(changes), geometric_mean_of_medians(ratios))
    samples = [([t for t in c.old.times if t > 0], [t for t in c.new.times if t > 0])
               for c in changes]  # fmt: skip
    return Mean(of, len(changes), geometric_mean_of_ratios(samples))


def parse_limits(text: str) -> dict[str, float]:
    """ "time=10%,memory=2%" as fractions. @raises GateError"""
    limits = {}
    for word in text.split(","):
        kind, _, percent = word.partition("=")
        if kind not in ("time", "counters", "memory"):
            raise GateError(
                f"--fail-on: no kind of limit named '{kind}'; there are counters, memory, time"
            )
        if not re.fullmatch(r"\d+(\.\d*)?%", percent):
            raise GateError(f"--fail-on: '{word}' must have the form {kind}=10%")
        limits[kind] = float(percent[:-1]) / 100
    return limits


def exceeded(comparison: Comparison, limits: dict[str, float]) -> list[str]:
    """A line for everything above its limit, and for every cell that was ok and has failed."""
    if not limits:
        return []
    lines: list[str] = []
    for change in comparison.cells:
        lines += _cell_failures(change, limits)
    for mean in comparison.means if "time" in limits else []:
        if mean.ratio.low > 1 + limits["time"] and mean.cells >= LEAST_CELLS:
            lines.append(f"{mean.of}: time {_interval(mean.ratio)} over {mean.cells} cells")
    return lines


def _cell_failures(change: CellChange, limits: dict[str, float]) -> list[str]:
    lines = [f"{change.name}: was ok, now {change.new.state}"] if change.lost else []
    for name, counter in change.counters.items():
        if "counters" in limits and counter.exceeds(limits["counters"]):
            lines.append(f"{change.name}: {name} {_growth(counter)}")
    memory = change.memory
    if "memory" in limits and memory and memory.exceeds(limits["memory"]):
        if memory.new - memory.old > MEMORY_FLOOR:
            lines.append(f"{change.name}: memory {_growth(memory, ' B')}")
    if _decision(change, limits) == Decision.SLOWER and change.time:
        grown = _growth(Change(change.time.old, change.time.new), " ms")
        lines.append(f"{change.name}: time {grown}, {len(change.time.ratios)} pairs")
    return lines


def _decision(change: CellChange, limits: dict[str, float]) -> Decision | None:
    """Of a cell by pairs against the limit of time."""
    if "time" not in limits or change.time is None or not change.time.ratios:
        return None
    return decide(change.time.ratios, 1 + limits["time"]).decision


def unresolved(comparison: Comparison, limits: dict[str, float]) -> list[str]:
    """Cells whose pairs do not decide whether they exceed the limit of time."""
    return [
        f"{change.name}: time {change.time.ratio:.3f} times"
        f" [{change.time.evidence['low']:.3f}, {change.time.evidence['high']:.3f}],"
        " more --repetitions decide it"
        for change in comparison.cells
        if change.time and _decision(change, limits) == Decision.UNDECIDED
    ]


def _growth(change: Change, unit: str = "") -> str:
    return f"{change.ratio:.4g} times ({change.old:.6g}{unit} to {change.new:.6g}{unit})"


def _interval(ratio: Estimate) -> str:
    return f"{ratio.value:.4g} times [{ratio.low:.4g}, {ratio.high:.4g}]"


def summary(comparison: Comparison, limits: dict[str, float]) -> list[str]:
    """The verdict in lines, the worst first."""
    lines = [f"WRONG: {c.name}: {c.new.state}" for c in comparison.cells if c.wrong]
    lines += [f"FAILED: {line}" for line in exceeded(comparison, limits)]
    lines += [f"NOT RESOLVED: {line}" for line in unresolved(comparison, limits)]
    times = [change.time for change in comparison.cells if change.time]
    longer = sum(time.resolved and time.ratio > 1 for time in times)
    shorter = sum(time.resolved and time.ratio < 1 for time in times)
    words = ("slower", "faster") if comparison.interleaved else ("longer", "shorter")
    differing = sum(bool(change.counters) for change in comparison.cells)
    lines.append(
        f"{len(comparison.cells)} cells compared: {longer} {words[0]}, {shorter} {words[1]},"
        f" {len(times) - longer - shorter} not resolved (~); {differing} counted differently;"
        f" {sum(change.lost for change in comparison.cells)} that were ok and failed"
    )
    for side, names in (("old", comparison.only_old), ("new", comparison.only_new)):
        if names:
            lines.append(f"only in the {side} run: {', '.join(names)}")
    return lines + comparison.notes


def tables(comparison: Comparison) -> list[Table]:
    means = [
        [mean.of, str(mean.cells), _ratio(mean.ratio.value, mean.ratio.excludes_one),
         f"{mean.ratio.low:.3f} to {mean.ratio.high:.3f}"]
        for mean in comparison.means
    ]  # fmt: skip
    heading = ["solver", "cells", "time new/old", "95% interval"]
    cells = [_row(change) for change in comparison.cells]
    columns = ["cell", "old ms", "new ms", "new/old", "memory new/old", "counters"]
    found = [(heading, means), (columns, cells)]
    return [
        Table("", "", header, 1, [text_cells(row) for row in rows]) for header, rows in found if rows
    ]


def _row(change: CellChange) -> list[str]:
    if not (change.old.ok and change.new.ok):
        return [change.name, *["-"] * 4, f"old {change.old.state}; new {change.new.state}"]
    time, memory = change.time, change.memory
    times = ["-"] * 3
    if time:
        times = [f"{time.old:.4g}", f"{time.new:.4g}", _ratio(time.ratio, time.resolved)]
    counters = [f"{name} {c.old:.0f} -> {c.new:.0f}" for name, c in change.counters.items()]
    return [change.name, *times, f"{memory.ratio:.3f}" if memory else "-",
            ", ".join(counters) or "same"]  # fmt: skip


def _ratio(value: float, resolved: bool) -> str:
    return f"{value:.3f}" if resolved else f"~ {value:.3f}"


def as_text(comparison: Comparison, limits: dict[str, float]) -> str:
    lines = "".join(f"{printable(line)}\n" for line in summary(comparison, limits))
    return lines + "".join(f"\n{to_text(table)}" for table in tables(comparison))


def as_markdown(comparison: Comparison, limits: dict[str, float]) -> str:
    lines = "".join(f"- {escape_markdown(line)}\n" for line in summary(comparison, limits))
    return lines + "".join(f"\n{to_markdown(table)}" for table in tables(comparison))


def as_json(comparison: Comparison, limits: dict[str, float]) -> str:
    def numbers(name: str, change: Change | None) -> dict[str, Any] | None:
        return None if change is None else {"name": name, "old": change.old, "new": change.new}

    def cell(change: CellChange) -> dict[str, Any]:
        time = change.time
        return {
            "name": change.name,
            "solver": change.new.cell.solver,
            "old_failed": None if change.old.ok else change.old.state,
            "new_failed": None if change.new.ok else change.new.state,
            "time": None if time is None else {
                "old_ms": time.old, "new_ms": time.new, "ratio": time.ratio,
                "resolved": time.resolved, **time.evidence,
            },
            "memory": numbers(MEMORY, change.memory),
            "counters": [numbers(name, c) for name, c in change.counters.items()],
        }  # fmt: skip

    def mean(one: Mean) -> dict[str, Any]:
        ratio = one.ratio
        return {"of": one.of, "cells": one.cells, "ratio": ratio.value, "low": ratio.low,
                "high": ratio.high, "resolved": ratio.excludes_one}  # fmt: skip

    data = {
        "interleaved": comparison.interleaved,
        "failures": exceeded(comparison, limits),
        "unresolved": unresolved(comparison, limits),
        "notes": comparison.notes,
        "only_old": comparison.only_old,
        "only_new": comparison.only_new,
        "overall": [mean(one) for one in comparison.means],
        "cells": [cell(change) for change in comparison.cells],
    }
    return json.dumps(data, indent=2) + "\n"


FORMATS = {"text": as_text, "markdown": as_markdown, "json": as_json}


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser(__doc__)
    parser.add_argument("old", type=Path, help="a result file or run folder")
    parser.add_argument(
        "new", type=Path, nargs="?",
        help="another of the same corpus; without it, old is a run with two --program",
    )  # fmt: skip
    parser.add_argument(
        "--fail-on", metavar="LIMITS", action="append", default=[],
        help="exit code 3 for growth above these limits, as in time=10%%,counters=1%%,memory=2%%",
    )  # fmt: skip
    parser.add_argument("--format", choices=FORMATS, default="text", help="default: text")
    options = parser.parse_args(arguments)
    try:
        limits = parse_limits(",".join(options.fail_on)) if options.fail_on else {}
        old = read_run(options.old)
        comparison = compare(old, read_run(options.new)) if options.new else compare_programs(old)
    except (GateError, ResultError, OSError) as error:
        return complain(error)
    print(FORMATS[options.format](comparison, limits), end="")
    if any(change.wrong for change in comparison.cells):
        return WRONG_ANSWER
    return REGRESSION if exceeded(comparison, limits) else 0


if __name__ == "__main__":
    sys.exit(main())
