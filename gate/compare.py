"""`geodesic-bench compare`: the differences between two runs, or between the two programs of one run.

A time fails a limit in two cases only: in an interleaved run, where pairs decide a cell; and as the
geometric mean over the cells of a solver, whose interval must lie above the limit. A single cell of
two separate runs is shown and never fails, because the machine may have drifted between the runs.
"""

from __future__ import annotations

import json
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

from gate.findings import REGRESSION, WRONG_ANSWER, GateError
from gate.measured import COUNTERS, MEMORY, MEMORY_FLOOR, WRONG, Measured, Number, measured, programs
from results.console import complain
from results.names import unknown_name
from results.pairs import interleaved
from results.reader import Cell, ResultError, Run, read_run
from results.statistics import Decision, Estimate, decide, rank_test
from results.statistics import geometric_mean_of_medians, geometric_mean_of_ratios
from results.table import Table, four_digits, markdown_page, text_fields, text_page

SIGNIFICANCE = 0.01
"""Significance level of the rank test for a cell of two separate runs."""
LEAST_REPETITIONS = 5
"""Least repetitions of either run for this level: 2 / C(10, 5) = 0.008."""
LEAST_CELLS = 3
"""Least number of cells of a mean that may fail a limit. Fewer cells say little about a solver."""
ONE_PROGRAM = "both runs are of one program: where their times differ, the machine has drifted between them"
SAME_BUILD = ("processor", "compiler", "compiler_flags", "build_type")
SEPARATE = (
    "times are of two separate runs and include a drift of the machine between them:"
    " run --program old=FILE --program new=FILE measures both programs in pairs"
)

Limits = dict[str, float]
"""Largest growth as a fraction (0.1 for 10%), by kind: time, counters or memory."""


@dataclass
class Change:
    """The change of one cell from the old to the new side."""

    old: Measured
    new: Measured
    ratios: list[float] = field(default_factory=list)
    """Ratios of time of the pairs; empty for two separate runs."""
    time: Number | None = None
    """Medians of CPU time in milliseconds."""
    resolved: bool = False
    """Whether the difference of the times is significant."""
    evidence: dict[str, float] = field(default_factory=dict)
    """The numbers behind `resolved`: `p` of the rank test, or `low`, `high` and `pairs`."""

    @property
    def name(self) -> str:
        return str(self.new.cell)

    @property
    def one_processor(self) -> bool:
        return self.old.rows[0].processor == self.new.rows[0].processor

    @property
    def lost(self) -> bool:
        return self.old.ok and not self.new.ok

    @property
    def wrong(self) -> bool:
        return self.new.failure is not None and self.new.failure.outcome == WRONG

    def number(self, key: str, unit: str = "") -> Number | None:
        old, new = self.old.number(key), self.new.number(key)
        return None if old is None or new is None else Number(old, new, unit)

    @property
    def counters(self) -> dict[str, Number]:
        """The counters that differ."""
        found = {name: self.number(name) for name in COUNTERS}
        return {name: n for name, n in found.items() if n is not None and n.old != n.new}

    def measure(self) -> None:
        """Compares the times of two separate runs."""
        old, new = statistics.median(self.old.times), statistics.median(self.new.times)
        if old > 0 and new > 0:
            self.time = Number(old, new, " ms")
            self.evidence = {"p": rank_test(self.old.times, self.new.times)}
            self.resolved = self.evidence["p"] <= SIGNIFICANCE

    def measure_pairs(self) -> None:
        if pairs := interleaved(self.old.rows, self.new.rows):
            self.ratios, ratio = pairs.ratios, decide(pairs.ratios, 1).ratio
            medians = statistics.median(pairs.first), statistics.median(pairs.second)
            self.time, self.resolved = Number(*medians, " ms"), ratio.excludes_one
            self.evidence = {"low": ratio.low, "high": ratio.high, "pairs": len(pairs)}

    def decision(self, limits: Limits) -> Decision | None:
        """Returns the decision against the limit of time; None without such a limit or without pairs."""
        if "time" not in limits or not self.ratios:
            return None
        return decide(self.ratios, 1 + limits["time"]).decision


@dataclass
class Comparison:
    interleaved: bool
    cells: list[Change]
    means: list[tuple[str, int, Estimate]] = field(default_factory=list)
    """Solver, number of cells and geometric mean of their time ratios. The last one is of "all" cells."""
    only_old: list[str] = field(default_factory=list)
    only_new: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    one_program: bool = False
    """Whether both runs are of one program. Their times then show only a drift of the machine."""


def compare(old: Run, new: Run) -> Comparison:
    """Compares two separate runs. @raises GateError when they cannot be compared"""
    for name, mesh in new.meshes.items():
        if name in old.meshes and old.meshes[name].sha256 != mesh.sha256:
            raise GateError(f"mesh {name} is another file in {new.file} than in {old.file}")
    notes = _differences(old.ours, new.ours)
    result = _comparison(False, measured(old), measured(new), notes)
    alike = [c.one_processor for c in result.cells]
    builds = [[run.ours[key] for key in ("revision", *SAME_BUILD)] for run in (old, new)]
    result.one_program = builds[0] == builds[1] and {False} == {run.ours["modified"] for run in (old, new)}
    if any(alike):
        notes.append(ONE_PROGRAM if result.one_program else SEPARATE)
    if not all(alike):
        notes.append("times of different processors are not compared")
    if not result.cells:
        raise GateError(f"nothing to compare: {old.file} and {new.file} have no cell in common")
    repetitions = [len(side.times) for c in result.cells if c.time for side in (c.old, c.new)]
    if min(repetitions, default=LEAST_REPETITIONS) < LEAST_REPETITIONS:
        result.notes.append(
            f"cells with fewer than {LEAST_REPETITIONS} repetitions cannot be resolved: run with"
            f" --repetitions {LEAST_REPETITIONS}"
        )
    return result


def compare_programs(run: Run) -> Comparison:
    """Compares the programs of an interleaved run. @raises GateError when the run does not have two"""
    names = programs(run)
    if len(names) != 2:
        raise GateError(
            f"{run.file}: a single run is compared when it was measured with two --program; it has"
            f" {', '.join(names) or 'no programs'}. Give two runs otherwise"
        )
    notes = [*_differences(*run.ours["programs"]), f"old is {names[0]}, new is {names[1]}"]
    return _comparison(True, measured(run, names[0]), measured(run, names[1]), notes)


def _differences(old: dict[str, Any], new: dict[str, Any]) -> list[str]:
    both = [key for key in SAME_BUILD if key in old and key in new]
    return [f"the {key} differs: {old[key]} / {new[key]}" for key in both if old[key] != new[key]]


def _comparison(
    interleaved: bool, old: dict[Cell, Measured], new: dict[Cell, Measured], notes: list[str]
) -> Comparison:
    changes = [Change(old[cell], after) for cell, after in new.items() if cell in old]
    for change in changes:
        if change.one_processor and change.old.ok and change.new.ok:
            measure = change.measure_pairs if interleaved else change.measure
            measure()
    timed = [change for change in changes if change.time]
    solvers = sorted({change.new.cell.solver for change in timed})
    groups = [(name, [c for c in timed if c.new.cell.solver == name]) for name in solvers]
    groups += [("all", timed)] if timed else []
    return Comparison(
        interleaved, changes, [(name, len(group), _mean(group)) for name, group in groups],
        [str(cell) for cell in old if cell not in new],
        [str(cell) for cell in new if cell not in old], notes,
    )  # fmt: skip


def _mean(changes: Sequence[Change]) -> Estimate:
    if all(change.ratios for change in changes):
        return geometric_mean_of_medians([change.ratios for change in changes])
    positive = [
        ([t for t in change.old.times if t > 0], [t for t in change.new.times if t > 0])
        for change in changes
    ]
    return geometric_mean_of_ratios(positive)


def parse_limits(text: str) -> Limits:
    """Parses "time=10%,memory=2%" into fractions. @raises GateError"""
    limits = {}
    for word in text.split(","):
        kind, _, percent = word.partition("=")
        if kind not in ("counters", "memory", "time"):
            kinds = ("counters", "memory", "time")
            raise GateError(f"--fail-on: {unknown_name('kind of limit', kind, kinds)}")
        if not re.fullmatch(r"\d+(\.\d*)?%", percent):
            raise GateError(f"--fail-on: '{word}' must have the form {kind}=10%")
        limits[kind] = float(percent[:-1]) / 100
    return limits


def exceeded(comparison: Comparison, limits: Limits) -> list[str]:
    """Returns a line for every value above its limit, and for every cell that was ok and now fails."""
    lines = [line for change in comparison.cells for line in _failures(change, limits)]
    for name, cells, ratio in comparison.means:
        timed = "time" in limits and not comparison.one_program and cells >= LEAST_CELLS
        if timed and ratio.low > 1 + limits["time"]:
            lines.append(f"{name}: time {_times(ratio)} over {cells} cells")
    return lines if limits else []


def _failures(change: Change, limits: Limits) -> list[str]:
    lines = [f"was ok, now {change.new.state}"] if change.lost else []
    limit = limits.get("counters")
    lines += [f"{name} {c}" for name, c in change.counters.items() if c.above(limit)]
    memory = change.number(MEMORY, " B")
    if memory and memory.above(limits.get("memory"), MEMORY_FLOOR):
        lines.append(f"memory {memory}")
    if change.decision(limits) == Decision.SLOWER:
        lines.append(f"time {change.time}, {len(change.ratios)} pairs")
    return [f"{change.name}: {line}" for line in lines]


def unresolved(comparison: Comparison, limits: Limits) -> list[str]:
    """Returns a line for every cell whose pairs do not decide whether it exceeds the limit of time."""
    return [
        f"{c.name}: time {_times(decide(c.ratios, 1).ratio)}: more --repetitions decide it"
        for c in comparison.cells
        if c.decision(limits) == Decision.UNDECIDED
    ]


def _times(ratio: Estimate) -> str:
    return f"{ratio.value:.4g} times [{ratio.low:.4g}, {ratio.high:.4g}]"


def summary(comparison: Comparison, limits: Limits) -> list[str]:
    """Returns the verdict as lines of text, the worst first."""
    cells = comparison.cells
    lines = [f"WRONG: {c.name}: {c.new.state}" for c in cells if c.wrong]
    lines += [f"FAILED: {line}" for line in exceeded(comparison, limits)]
    lines += [f"NOT RESOLVED: {line}" for line in unresolved(comparison, limits)]
    timed = [c.time.ratio for c in cells if c.time]
    resolved = [c.time.ratio for c in cells if c.time and c.resolved]
    longer, shorter = ("slower", "faster") if comparison.interleaved else ("longer", "shorter")
    above = sum(ratio > 1 for ratio in resolved)
    lines.append(
        f"{len(cells)} cells compared: {above} {longer}, {len(resolved) - above} {shorter},"
        f" {len(timed) - len(resolved)} not resolved (~);"
        f" {sum(bool(c.counters) for c in cells)} counted differently;"
        f" {sum(c.lost for c in cells)} that were ok and failed"
    )
    for name, _, ratio in comparison.means[-1:]:
        decided = ratio.excludes_one and not comparison.one_program
        lines.append(f"{name}: time new/old {_times(ratio)}{'' if decided else ', not resolved (~)'}")
    for side, names in (("old", comparison.only_old), ("new", comparison.only_new)):
        lines += [f"only in the {side} run: {', '.join(names)}"] if names else []
    return lines + comparison.notes


def tables(comparison: Comparison) -> list[Table]:
    means = [
        [name, str(cells), _ratio(ratio.value, ratio.excludes_one and not comparison.one_program),
         f"{ratio.low:.3f} to {ratio.high:.3f}"]
        for name, cells, ratio in comparison.means
    ]  # fmt: skip
    heading = ["solver", "cells", "time new/old", "95% interval"]
    columns = ["cell", "counters", "old ms", "new ms", "new/old", "memory new/old"]
    cells = [_row(change) for change in comparison.cells]
    found = [(heading, 1, means), (columns, 2, cells)]
    return [Table("", "", head, n, [*map(text_fields, rows)]) for head, n, rows in found if rows]


def _row(change: Change) -> list[str]:
    if not (change.old.ok and change.new.ok):
        return [change.name, f"old {change.old.state}; new {change.new.state}", *["-"] * 4]
    counters = ", ".join(f"{n} {c.old:.0f} -> {c.new:.0f}" for n, c in change.counters.items())
    time, memory = change.time, change.number(MEMORY)
    times = ["-"] * 3
    if time:
        times = [four_digits(time.old), four_digits(time.new), _ratio(time.ratio, change.resolved)]
    return [change.name, counters or "same", *times, f"{memory.ratio:.3f}" if memory else "-"]


def _ratio(value: float, resolved: bool) -> str:
    return f"{value:.3f}" if resolved else f"~ {value:.3f}"


def as_text(comparison: Comparison, limits: Limits) -> str:
    return text_page(summary(comparison, limits), tables(comparison))


def as_markdown(comparison: Comparison, limits: Limits) -> str:
    return markdown_page("", summary(comparison, limits), tables(comparison))


def as_json(comparison: Comparison, limits: Limits) -> str:
    data = {
        "interleaved": comparison.interleaved,
        "failures": exceeded(comparison, limits),
        "unresolved": unresolved(comparison, limits),
        "notes": comparison.notes,
        "only_old": comparison.only_old,
        "only_new": comparison.only_new,
        "overall": [
            {"of": name, "cells": cells, "ratio": ratio.value, "low": ratio.low,
             "high": ratio.high, "resolved": ratio.excludes_one}
            for name, cells, ratio in comparison.means
        ],
        "cells": [_json(change) for change in comparison.cells],
    }  # fmt: skip
    return json.dumps(data, indent=2) + "\n"


def _json(change: Change) -> dict[str, Any]:
    def numbers(name: str, number: Number | None) -> dict[str, Any] | None:
        return {"name": name, "old": number.old, "new": number.new} if number else None

    time = change.time
    return {
        "name": change.name,
        "solver": change.new.cell.solver,
        "old_failed": None if change.old.ok else change.old.state,
        "new_failed": None if change.new.ok else change.new.state,
        "time": {"old_ms": time.old, "new_ms": time.new, "ratio": time.ratio,
                 "resolved": change.resolved, **change.evidence} if time else None,
        "memory": numbers(MEMORY, change.number(MEMORY)),
        "counters": [numbers(name, number) for name, number in change.counters.items()],
    }  # fmt: skip


FORMATS = {"text": as_text, "markdown": as_markdown, "json": as_json}


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.Parser(
        __doc__,
        "geodesic-bench compare results/runs/old results/runs/new",
        "geodesic-bench compare results/runs/two-programs --fail-on time=10%,counters=1%",
    )
    parser.add_argument("old", type=Path, help="a result file or run folder")
    parser.add_argument(
        "new", type=Path, nargs="?",
        help="a second one of the same corpus; if left out, old is a run with two --program",
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
