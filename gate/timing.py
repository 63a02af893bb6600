"""Level 4: CPU time of base and head in pairs, and the noise of a build against itself.

A session is one interleaved run with PAIRS pairs per row. Rows that are undecided or slower are
measured in further sessions, until every row is decided or the budget is spent. The pairs of all
sessions are combined. docs/measuring.md describes the decision rule.
"""

from __future__ import annotations

import json
import math
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from results.pairs import Pairs, together
from results.reader import Cell
from results.statistics import Decision, Estimate, decide, geometric_mean_of_medians
from results.table import four_digits

from gate.findings import REGRESSION, GateError, LevelResult, Weight
from gate.measured import Measured
from gate.progress import about

TITLE = "CPU time, interleaved pairs"
PAIRS = 15
CONFIRMED = 2
"""Number of sessions that confirm a slower row; 1 if the solver also grew at level 1 or 2."""
SHORTEST_MS, LONGEST_MS = 10.0, 150.0
"""Least and longest time of a timed row: long enough for low noise, short enough for many pairs."""
LEAST_ROWS = 3
"""Least number of timed rows of each solver, on any machine."""
SECONDS_OF_PAIR = 0.8
"""Typical duration of a pair of processes, for the announcement of a session."""

Say = Callable[[str], None]
Session = Callable[[Sequence[Cell]], dict[Cell, Pairs]]
"""Measures PAIRS pairs of each of the given cells."""


def timed_cells(base: Sequence[Measured]) -> list[Cell]:
    """Selects the rows of level 4 by the times of the base: the rows of suitable length. A solver with
    fewer than LEAST_ROWS also gets the longest of its shorter rows, then the shortest of its longer."""
    by_solver: dict[str, list[Measured]] = {}
    for one in base:
        by_solver.setdefault(one.cell.solver, []).append(one)
    chosen: list[Cell] = []
    for rows in by_solver.values():
        rows.sort(key=_milliseconds)
        suitable = [row for row in rows if SHORTEST_MS <= _milliseconds(row) <= LONGEST_MS]
        shorter = [row for row in rows if _milliseconds(row) < SHORTEST_MS]
        longer = [row for row in rows if _milliseconds(row) > LONGEST_MS]
        missing = max(LEAST_ROWS - len(suitable), 0)
        chosen += [row.cell for row in (*suitable, *[*reversed(shorter), *longer][:missing])]
    return [one.cell for one in base if one.cell in chosen]


def _milliseconds(row: Measured) -> float:
    return statistics.median(row.times)


@dataclass
class Timing:
    """All pairs of all sessions, and the decisions that follow from them."""

    margin: float
    grown: dict[str, int]
    """Level, 1 or 2, at which a solver has grown, by solver."""
    everything: bool = False
    """Whether rows are measured until they are decided when another one has failed."""
    confirmed: int = CONFIRMED
    pairs: dict[Cell, Pairs] = field(default_factory=dict)
    sessions: dict[Cell, int] = field(default_factory=dict)
    _means: dict[str, Estimate] = field(default_factory=dict)

    def add(self, session: dict[Cell, Pairs]) -> None:
        for cell, pairs in session.items():
            self.pairs[cell] = together([*filter(None, [self.pairs.get(cell)]), pairs])
            self.sessions[cell] = self.sessions.get(cell, 0) + 1
            self._means.pop(cell.solver, None)

    def cells_of(self, solver: str) -> list[Cell]:
        return [cell for cell in self.pairs if cell.solver == solver]

    @property
    def solvers(self) -> list[str]:
        return list(dict.fromkeys(cell.solver for cell in self.pairs))

    def mean(self, solver: str) -> Estimate | None:
        """Returns the mean ratio over the solver's rows; None if there is only one row."""
        ratios = [self.pairs[cell].ratios for cell in self.cells_of(solver)]
        if solver not in self._means and len(ratios) > 1:
            self._means[solver] = geometric_mean_of_medians(ratios)
        return self._means.get(solver)

    def decision(self, cell: Cell) -> Decision:
        """Returns the decision against the margin. A slower row is undecided until it is confirmed.
        A row that is not slower is undecided until its interval shows half of the allowed growth."""
        judged = decide(self.pairs[cell].ratios, self.margin)
        wide = judged.ratio.high - judged.ratio.value > (self.margin - 1) / 2
        if judged.decision == Decision.SAME and wide:
            return Decision.UNDECIDED
        return self._confirmed(judged.decision, [cell])

    def mean_decision(self, solver: str) -> Decision:
        mean = self.mean(solver)
        if mean is None or mean.value <= self.margin:
            return Decision.SAME
        decision = Decision.SLOWER if mean.low > self.margin else Decision.UNDECIDED
        return self._confirmed(decision, self.cells_of(solver))

    def _confirmed(self, decision: Decision, cells: list[Cell]) -> Decision:
        confirmed = all(self.sessions[cell] >= self.confirmed for cell in cells)
        if decision != Decision.SLOWER or confirmed or cells[0].solver in self.grown:
            return decision
        return Decision.UNDECIDED

    @property
    def certain(self) -> bool:
        """Whether nothing more is measured because a row or a solver has failed."""
        decisions = (*map(self.mean_decision, self.solvers), *map(self.decision, self.pairs))
        return not self.everything and Decision.SLOWER in decisions

    def suspects(self) -> list[Cell]:
        """Returns the rows that need more pairs. A solver that is slower on the mean needs none."""
        found: list[Cell] = []
        for solver in self.solvers:
            of_mean, cells = self.mean_decision(solver), self.cells_of(solver)
            if of_mean == Decision.UNDECIDED:
                found += cells
            elif of_mean == Decision.SAME:
                found += [cell for cell in cells if self.decision(cell) == Decision.UNDECIDED]
        return found


def measure(
    timing: Timing, cells: Sequence[Cell], session: Session, seconds: float, say: Say
) -> None:
    """Measures sessions until every row is decided, one has failed, or the budget for further
    sessions is spent."""

    def lasts(rows: Sequence[Cell]) -> str:
        return about(len(rows) * PAIRS * SECONDS_OF_PAIR)

    say(f"level 4: {PAIRS} pairs of each of {len(cells)} rows, {lasts(cells)}")
    timing.add(session(cells))
    end = time.monotonic() + seconds
    while not timing.certain and (suspects := timing.suspects()) and time.monotonic() < end:
        say(f"level 4: {PAIRS} more pairs of {len(suspects)} rows that are not decided, {lasts(suspects)}")
        timing.add(session(suspects))


def report(timing: Timing, undecided: str) -> LevelResult:
    """Returns the result of level 4. @param undecided what is said of rows that the pairs do not decide"""
    result = LevelResult(4, f"{TITLE}, margin {timing.margin:g}")
    result.heading = ["row", "base ms", "head ms", "head/base", "interval", "pairs", "decision"]
    for solver in timing.solvers:
        failed = _report_mean(result, timing, solver)
        for cell in timing.cells_of(solver):
            _report_row(result, timing, cell, undecided, solver_failed=failed)
    return result


def _report_mean(result: LevelResult, timing: Timing, solver: str) -> bool:
    """Reports the mean of a solver. Returns whether the solver is slower on the mean."""
    mean, decision = timing.mean(solver), timing.mean_decision(solver)
    if mean is None:
        return False
    what = mean_of(solver, len(timing.cells_of(solver)))
    result.table.append([what, "", "", f"{mean.value:.3f}", interval(mean), "", str(decision)])
    text = f"{what}: {times(mean)}"
    if decision == Decision.SLOWER:
        result.fail(text + _cause(timing, solver), REGRESSION, solver)
    elif noticeable(mean, timing.margin):
        result.add(Weight.WITHIN_MARGIN, text, solver=solver)
    return decision == Decision.SLOWER


def _report_row(
    result: LevelResult, timing: Timing, cell: Cell, undecided: str, solver_failed: bool
) -> None:
    pairs, decision = timing.pairs[cell], timing.decision(cell)
    judged = decide(pairs.ratios, timing.margin)
    ratio = judged.ratio
    result.compared += 1
    old, new = statistics.median(pairs.first), statistics.median(pairs.second)
    result.table.append([
        str(cell), four_digits(old), four_digits(new),
        f"{ratio.value:.3f}", interval(ratio), str(len(pairs)),
        "NOT RESOLVED" if decision == Decision.UNDECIDED else str(decision),
    ])  # fmt: skip
    text = f"{cell}: {times(ratio)}, {len(pairs)} pairs"
    if pairs.disturbed:
        text += f", {pairs.disturbed} disturbed"
    if decision == Decision.SLOWER:
        result.fail(text + _cause(timing, cell.solver), REGRESSION, cell.solver)
    elif decision == Decision.UNDECIDED and not solver_failed:
        why = (
            "not measured further, since the verdict is certain (--all measures on)" if timing.certain
            else undecided
        )  # fmt: skip
        result.add(Weight.NOT_RESOLVED, text, remark=why)
    elif noticeable(ratio, timing.margin) and not solver_failed:
        result.add(Weight.WITHIN_MARGIN, text, solver=cell.solver)


def mean_of(solver: str, rows: int) -> str:
    return f"{solver}, geometric mean over {rows} rows"


def times(ratio: Estimate) -> str:
    return f"{ratio.value:.3f} times as long [{ratio.low:.3f}, {ratio.high:.3f}]"


def interval(mean: Estimate) -> str:
    return f"{mean.low:.3f} to {mean.high:.3f}"


def _cause(timing: Timing, solver: str) -> str:
    return f"; level {timing.grown[solver]} has grown as well" if solver in timing.grown else ""


def noticeable(ratio: Estimate, margin: float) -> bool:
    """Whether the ratio is certainly above 1 and its growth is at least half of the allowed growth."""
    return ratio.low > 1 and ratio.value >= 1 + (margin - 1) / 2


def noise(pairs: Pairs) -> float:
    """Returns the spread of the ratios of pairs of one program, 1.04 for 4%: one standard deviation,
    estimated from the median absolute logarithm."""
    return math.exp(1.4826 * statistics.median(abs(math.log(ratio)) for ratio in pairs.ratios))


def against_itself(
    cells: Sequence[Cell], session: Session, sessions: int, margin: float, say: Say
) -> tuple[LevelResult, dict[str, float]]:
    """--a-a: returns the report, and the noise of each row."""
    result = LevelResult(4, f"One build against itself, {sessions} sessions of {PAIRS} pairs")
    result.heading = ["row", "ms", "noise", "median ratios", "intervals", "called slower"]
    measured: dict[Cell, list[Pairs]] = {cell: [] for cell in cells}
    for number in range(sessions):
        say(f"a-a: session {number + 1} of {sessions}, {len(cells)} rows")
        for cell, pairs in session(cells).items():
            measured[cell].append(pairs)
    for cell, all_pairs in measured.items():
        judged = [decide(pairs.ratios, margin) for pairs in all_pairs]
        slower = sum(one.decision == Decision.SLOWER for one in judged)
        medians = [one.ratio.value for one in judged]
        result.compared += 1
        result.table.append([
            str(cell), four_digits(statistics.median(t for p in all_pairs for t in p.first)),
            f"{max(map(noise, all_pairs)) - 1:.1%}", f"{min(medians):.3f} to {max(medians):.3f}",
            f"{min(one.ratio.low for one in judged):.3f} to"
            f" {max(one.ratio.high for one in judged):.3f}",
            f"{slower} of {sessions}",
        ])  # fmt: skip
        if slower:
            result.fail(str(cell), REGRESSION, remark="slower than itself")
    return result, {str(cell): max(map(noise, pairs)) for cell, pairs in measured.items()}


def keep_noise(file: Path, processor: str, floors: dict[str, float]) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps({"processor": processor, "noise": floors}, indent=1) + "\n")


def check_margin(file: Path, processor: str, cells: Sequence[Cell], margin: float) -> None:
    """@raises GateError when --a-a measured more noise in one of these rows than the margin"""
    try:
        kept = json.loads(file.read_text(encoding="utf-8"))
        floors = kept["noise"] if kept["processor"] == processor else {}
    except (OSError, ValueError, KeyError):
        return  # no stored noise: every interval contains its own noise
    for cell in cells:
        floor = floors.get(str(cell), 1.0)
        if margin < floor:
            least = f"{math.ceil(floor * 100) / 100:.2f}"
            raise GateError(
                f"the margin {margin:g} is below this machine's noise of {cell}, {floor:.3f}"
                f" ({file}): use --margin {least} or more, or a quieter machine"
            )
