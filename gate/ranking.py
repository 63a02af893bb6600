"""A ranking, computed from the file of an interleaved run.

Every ratio is the solver's number divided by the candidate's: above 1 the solver takes more.
docs/ranking.md describes the numbers, docs/measuring.md the pairs.
"""

from __future__ import annotations

import itertools
import math
import statistics
from collections.abc import Sequence
from dataclasses import dataclass, field

from results.pairs import Pairs, interleaved, together
from results.reader import Cell, Row, Run
from results.statistics import (
    CONFIDENCE,
    Estimate,
    geometric_mean_of_medians,
    least_for_interval,
    median_interval,
)

from gate.findings import GateError, alike
from gate.measured import MEMORY, WRONG, Measured, measured

WINDOWS = "window_propagations"
ERROR = "max_relative_error"


@dataclass(frozen=True)
class Ratio:
    """A ratio of times with its 95% interval."""

    estimate: Estimate
    pairs: int
    """Number of pairs; over several meshes, the smallest number on one mesh."""

    @property
    def has_interval(self) -> bool:
        return self.pairs >= least_for_interval(CONFIDENCE)

    @property
    def resolved(self) -> bool:
        """Whether there is an interval and it excludes 1."""
        return self.has_interval and self.estimate.excludes_one


@dataclass(frozen=True)
class OnMesh:
    """A solver compared with the candidate on one mesh."""

    mesh: str
    time: Ratio
    """Median ratio over the pairs of all sources."""
    milliseconds: float
    """Median time of the solver."""
    ratios: list[float]
    windows: float | None
    memory: float | None


@dataclass
class Standing:
    solver: str
    right: int
    """Number of meshes, out of `all`, that the solver solved correctly."""
    all: int
    max_relative_error: float | None
    meshes: list[OnMesh] = field(default_factory=list)
    """The meshes on which both the solver and the candidate were timed."""
    time: Ratio | None = None
    """Geometric mean over `meshes`, as are the two below; None for the candidate."""
    windows: float | None = None
    memory: float | None = None
    rank: int | None = None

    def on(self, mesh: str) -> OnMesh | None:
        return next((one for one in self.meshes if one.mesh == mesh), None)


class Measurements:
    """The cells of the run by mesh and solver."""

    def __init__(self, run: Run) -> None:
        self._cells = measured(run)
        self._sources = run.sources
        self.meshes = [mesh for mesh in run.meshes if any(c.mesh == mesh for c in self._cells)]

    def of(self, solver: str, mesh: str) -> list[Measured]:
        cells = [Cell(solver, mesh, source) for source in self._sources[mesh]]
        return [self._cells[cell] for cell in cells if cell in self._cells]

    def failure(self, solver: str, mesh: str) -> Row | None:
        """The solver's first failure on the mesh."""
        return next((one.failure for one in self.of(solver, mesh) if one.failure), None)

    def numbers(self, solver: str, mesh: str, key: str) -> list[float]:
        """Returns one number per source; empty unless all sources have it."""
        found = [one.number(key) for one in self.of(solver, mesh)]
        present = [value for value in found if value is not None]
        return present if len(present) == len(found) else []

    def pairs(self, first: str, second: str, mesh: str) -> Pairs:
        """Returns the pairs of all sources as one sample; empty if one of the two solvers failed."""
        if self.failure(first, mesh) or self.failure(second, mesh):
            return Pairs([], [])
        sides = zip(self.of(first, mesh), self.of(second, mesh), strict=False)
        return together(interleaved(a.rows, b.rows) for a, b in sides)

    def ratio(self, first: str, second: str, mesh: str, key: str) -> float | None:
        """Returns the second solver's geometric mean over the sources divided by the first's."""
        below, above = self.numbers(first, mesh, key), self.numbers(second, mesh, key)
        if not below or not above or min(*below, *above) <= 0:
            return None
        return statistics.geometric_mean(above) / statistics.geometric_mean(below)

    def mean(self, first: str, second: str) -> Ratio | None:
        """Returns the mean ratio of times over the meshes that both solved; None if there are none."""
        samples = [self.pairs(first, second, mesh).ratios for mesh in self.meshes]
        samples = [ratios for ratios in samples if ratios]
        if not samples:
            return None
        return Ratio(geometric_mean_of_medians(samples), min(map(len, samples)))


@dataclass
class Ranking:
    candidate: str
    measurements: Measurements
    standings: list[Standing]
    """Fastest solver first; solvers without a mean are last."""
    remarks: list[str]

    @property
    def of_candidate(self) -> Standing:
        return next(one for one in self.standings if one.solver == self.candidate)

    @property
    def wrong(self) -> list[str]:
        """Solvers with a wrong answer on at least one mesh."""
        found = self.measurements
        failures = [(one.solver, found.failure(one.solver, mesh))
                    for one in self.standings for mesh in found.meshes]  # fmt: skip
        wrong = (solver for solver, row in failures if row is not None and row.outcome == WRONG)
        return list(dict.fromkeys(wrong))


def rank(run: Run, candidate: str | None = None) -> Ranking:
    """@param candidate name of the solver to rank; None for the run's first solver
    @raises GateError when the run is not interleaved or lacks the solver"""
    solvers = list(run.solvers)
    if not run.interleaved or len(solvers) < 2:
        raise GateError(f"{run.file}: not an interleaved run of two or more solvers")
    name = candidate or solvers[0]
    if name not in solvers:
        raise GateError(f"{run.file}: has no solver {name}; it has {', '.join(solvers)}")
    measurements = Measurements(run)
    standings = [_standing(measurements, name, solver) for solver in solvers]
    ranking = Ranking(name, measurements, standings, [])
    ranking.standings.sort(key=lambda one: _order(one, name))
    _give_ranks(ranking)
    ranking.remarks = [*_failures(ranking), *_about_means(ranking, run)]
    return ranking


def _standing(measurements: Measurements, candidate: str, solver: str) -> Standing:
    right = [mesh for mesh in measurements.meshes if measurements.failure(solver, mesh) is None]
    errors = [value for mesh in right for value in measurements.numbers(solver, mesh, ERROR)]
    standing = Standing(solver, len(right), len(measurements.meshes), max(errors, default=None))
    if solver == candidate:
        return standing
    for mesh in measurements.meshes:
        if pairs := measurements.pairs(candidate, solver, mesh):
            windows = measurements.ratio(candidate, solver, mesh, WINDOWS)
            memory = measurements.ratio(candidate, solver, mesh, MEMORY)
            time = Ratio(median_interval(pairs.ratios), len(pairs))
            milliseconds = statistics.median(pairs.second)
            standing.meshes.append(
                OnMesh(mesh, time, milliseconds, pairs.ratios, windows, memory)
            )
    standing.time = measurements.mean(candidate, solver)
    standing.windows = _mean([one.windows for one in standing.meshes])
    standing.memory = _mean([one.memory for one in standing.meshes])
    return standing


def _mean(values: Sequence[float | None]) -> float | None:
    present = [value for value in values if value is not None]
    return statistics.geometric_mean(present) if present else None


def _order(standing: Standing, candidate: str) -> float:
    """Returns the time relative to the candidate; infinity for a solver that has no place."""
    if standing.time is not None:
        return standing.time.estimate.value
    return 1.0 if standing.solver == candidate and standing.right else math.inf


def _give_ranks(ranking: Ranking) -> None:
    """Assigns the ranks. A rank begins where the pairs resolve each solver before as faster than each
    behind it. Solvers without a common mesh are not resolved. Too few pairs for an interval give no ranks."""
    placed = [one for one in ranking.standings if _order(one, ranking.candidate) < math.inf]
    if not any(one.time is not None and one.time.has_interval for one in placed):
        return
    tied = [
        (first, second)
        for first, second in itertools.combinations(range(len(placed)), 2)
        if not _faster(ranking.measurements.mean(placed[first].solver, placed[second].solver))
    ]
    for place, standing in enumerate(placed):
        if not any(first < place <= second for first, second in tied):
            rank = place + 1
        standing.rank = rank


def _faster(mean: Ratio | None) -> bool:
    """Whether the pairs resolve the first solver of the mean as faster. The order of means over different
    meshes can be another one than that of two solvers on the meshes that both solved."""
    return mean is not None and mean.resolved and mean.estimate.low > 1


def _failures(ranking: Ranking) -> list[str]:
    reasons = alike(
        (mesh, (standing.solver, f"{row.outcome}: {row.message}"))
        for mesh in ranking.measurements.meshes
        for standing in ranking.standings
        if (row := ranking.measurements.failure(standing.solver, mesh)) is not None
    )
    said = alike((solver, (", ".join(meshes), why)) for (solver, why), meshes in reasons.items())
    return [f"without a time: {', '.join(names)} on {meshes}: {why}"
            for (meshes, why), names in said.items()]  # fmt: skip


def _about_means(ranking: Ranking, run: Run) -> list[str]:
    count, lines = len(ranking.measurements.meshes), []
    timed = [one for one in ranking.standings if one.time is not None]
    places = alike((one.solver, tuple(on.mesh for on in one.meshes)) for one in timed)
    for meshes, solvers in places.items():
        if len(meshes) < count:
            lines.append(
                f"the means of {', '.join(solvers)} are over {len(meshes)} of {count} meshes: compare"
                " them only with means over the same meshes"
            )
    if any(one.time is not None and not one.time.has_interval for one in timed):
        least = least_for_interval(CONFIDENCE)
        lines.append(f"fewer than {least} pairs resolve nothing (~): rank with more --pairs")
    disturbed = sum(
        ranking.measurements.pairs(ranking.candidate, one.solver, mesh).disturbed
        for one in timed for mesh in ranking.measurements.meshes
    )  # fmt: skip
    if disturbed:
        lines.append(
            f"{disturbed} pairs were disturbed, by other processes or the hypervisor: rank on a"
            " machine that does nothing else"
        )
    if count == 1:
        lines.append("one mesh does not show how the solvers compare on others")
    skipped = alike((skip.mesh, skip.why) for skip in run.not_measured)
    return lines + [f"skipped {', '.join(meshes)}: {why}" for why, meshes in skipped.items()]
