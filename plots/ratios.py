"""Ratios for the terminal and the pages, and those that the thesis's text mentions, from our rows and
from its Table 5.2. Both numbers of a ratio belong to one pair (results/pairs.py). A mesh counts once,
by the geometric mean over its sources and repetitions.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

import numpy as np

from plots.measures import (
    ABSENT, COUNTING, CREATED, EDGE_BASED, LIMIT, LIMIT_SOLVER, PEAK, PEAK_BYTES, PROPAGATIONS, REINSERTIONS,
    SPACE, TIME, VALID, Measure, failure, limit_solver, measured_solvers, partial_failure,
    values,
)  # fmt: skip
from results import published
from results.pairs import Floats, all_times, paired
from results.reader import Run
from results.statistics import Estimate, Sample, geometric_mean
from results.table import Field, decimals, estimate_field

RIVAL = "the solver in the column"


def plain(value: float) -> str:
    return f"{value:.3f}" if round(value, 3) < 10 else f"{value:,.1f}"


def number(value: float) -> str:
    """Returns the value with three significant digits; from 100 on rounded to an integer."""
    return f"{value:,.{decimals(value, 3)}f}"


def _fewer(value: float) -> str:
    return f"{100 * (1 - value):.1f}%"


@dataclass(frozen=True)
class Ratio:
    """A ratio of two measures, above / below. The solver RIVAL stands for the one passed to a method."""

    key: str
    label: str
    above: tuple[str, Measure]
    below: tuple[str, Measure]
    show: Callable[[float], str] = plain
    note: str = ""
    falling: bool = False
    """Whether the shown value falls as the ratio rises."""

    def measured(self, run: Run, mesh: str, solver: str) -> Sample:
        """Returns the paired ratios by source; empty if one of the two values is missing or 0."""
        above, below = (
            values(run, mesh, self._solver(run, mesh, of, measure, solver), measure)
            for of, measure in (self.above, self.below)
        )
        return paired(above, below)

    @staticmethod
    def _solver(run: Run, mesh: str, named: str, measure: Measure, rival: str) -> str:
        if measure is LIMIT:
            return limit_solver(run, mesh)
        return rival if named == RIVAL else named

    def is_of(self, run: Run) -> bool:
        """Returns whether the run has the solvers that the ratio names, or a value of the ratio."""
        solvers = {of for of, _ in (self.above, self.below)} - {RIVAL}
        return solvers <= set(run.solvers) or any(
            self.measured(run, mesh, solver) for mesh in run.meshes for solver in run.solvers
        )

    def published(self, model: str, solver: str) -> float | None:
        above, below = (
            published.measure(model, str(measure.published), solver if of == RIVAL else of)
            for of, measure in (self.above, self.below)
        )
        if isinstance(above, int | float) and isinstance(below, int | float):
            return above / below
        return None

    def mean(self, run: Run, mesh: str, solver: str) -> Estimate | None:
        """Returns the geometric mean over sources and repetitions, or None if nothing is measured."""
        sample = self.measured(run, mesh, solver)
        return geometric_mean([sample]) if sample else None

    def field(self, run: Run, mesh: str, solver: str) -> Field:
        """Returns the mean, or the reason why there is none."""
        estimate = self.mean(run, mesh, solver)
        if estimate is None:
            return failure(run, mesh, solver) or Field(ABSENT)
        note = partial_failure(run, mesh, solver)
        return estimate_field(estimate, self.interval(estimate), note)

    def interval(self, estimate: Estimate) -> str:
        ends = sorted([estimate.low, estimate.high], reverse=self.falling)
        return f"{self.show(estimate.value)} [{', '.join(map(self.show, ends))}]"

    def range(self, least: float, most: float) -> str:
        ends = sorted([least, most], reverse=self.falling)
        return " to ".join(map(self.show, ends))


def time_over(base: str) -> Ratio:
    """@param base a solver; empty if no solver has a time"""
    return Ratio("speed-up", f"Time / {base}" if base else "Ratio", (RIVAL, TIME), (base, TIME))


BELOW_1 = (
    "Less than 1 is possible on a mesh with a boundary, as a flat grid has: windows on boundary "
    "edges count towards the limit, and have no face to be propagated across."
)

RATIOS = [
    time_over(EDGE_BASED),
    Ratio(
        "propagations over the limit", "Window propagations / window limit",
        (RIVAL, PROPAGATIONS), (LIMIT_SOLVER, LIMIT), note=f"{COUNTING} {BELOW_1}",
    ),
    Ratio(
        "re-insertions over the limit", "Re-insertions among them / window limit",
        (RIVAL, REINSERTIONS), (LIMIT_SOLVER, LIMIT),
    ),
    Ratio(
        "created over the limit", "Windows created, before filtering / window limit",
        (RIVAL, CREATED), (LIMIT_SOLVER, LIMIT),
    ),
    Ratio(
        "fewer windows", "Windows that edge-based saves",
        (EDGE_BASED, PROPAGATIONS), (RIVAL, PROPAGATIONS), _fewer, COUNTING, True,
    ),
    Ratio(
        "valid over propagations", "Valid windows / window propagations",
        (RIVAL, VALID), (RIVAL, PROPAGATIONS), note=COUNTING,
    ),
    Ratio("peak wavefront", "Peak wavefront / edge-based", (RIVAL, PEAK), (EDGE_BASED, PEAK)),
    Ratio(
        "space", "Space by the thesis's rule / edge-based", (RIVAL, SPACE), (EDGE_BASED, SPACE)
    ),
    Ratio(
        "measured space", "Solver's peak bytes, measured / edge-based",
        (RIVAL, PEAK_BYTES), (EDGE_BASED, PEAK_BYTES),
    ),
]  # fmt: skip

BY_KEY = {ratio.key: ratio for ratio in RATIOS}


@dataclass(frozen=True)
class Mean:
    """Geometric mean over the meshes that have the ratio."""

    estimate: Estimate
    coverage: str
    """For example "2 of 3 meshes"; empty if all meshes have the ratio."""


def over_meshes(ratio: Ratio, run: Run, meshes: list[str], solver: str) -> Mean | None:
    """Returns the mean, or None if no mesh has the ratio."""
    samples = [sample for mesh in meshes if (sample := ratio.measured(run, mesh, solver))]
    if not samples:
        return None
    complete = len(samples) == len(meshes)
    coverage = "" if complete else f"{len(samples)} of {len(meshes)} meshes"
    return Mean(geometric_mean(samples), coverage)


def mean_field(ratio: Ratio, mean: Mean, solver: str) -> Field:
    note = f"{solver}: a mean over {mean.coverage}." if mean.coverage else ""
    return estimate_field(mean.estimate, ratio.interval(mean.estimate), note)


def over_each_mesh(run: Run, base: str) -> dict[str, Floats]:
    """Returns, by solver, the ratio to the base's time of every mesh that has both times. `over_meshes`
    also computes the interval of their mean."""
    found = all_times(run)
    if base not in found.solvers:
        return {}
    by_solver = {s: found.by_mesh(s, base) for s in measured_solvers(run)}
    return {s: of[~np.isnan(of)] for s, of in by_solver.items() if not np.isnan(of).all()}


def mean(ratios: Sequence[float] | Floats) -> float:
    """Returns the geometric mean."""
    return float(np.exp(np.log(ratios).mean()))


def fastest_exact(run: Run, but: Collection[str] = ()) -> str:
    """Returns the solver that times are compared with: the exact solver with the least geometric mean of
    time ratios to the solver with the most meshes, on the meshes that both have. Solvers with less than
    half as many meshes are left out. Without an exact solver, the others are compared; empty without any.

    @param but solvers to leave out"""
    measured = [solver for solver in measured_solvers(run) if solver not in but]
    exact = [solver for solver in measured if run.solvers[solver].exact]
    found = all_times(run)
    meshes = {s: found.by_mesh(s) for s in exact or measured}
    counts = {s: int((~np.isnan(of)).sum()) for s, of in meshes.items()}
    known = [solver for solver, count in counts.items() if count]
    if not known:
        return ""
    widest = max(known, key=lambda solver: counts[solver])
    ratios = {
        s: of[~np.isnan(of)]
        for s in known
        if 2 * counts[s] >= counts[widest]
        for of in [found.by_mesh(s, widest)]
    }
    return min((s for s in ratios if len(ratios[s])), key=lambda solver: mean(ratios[solver]))
