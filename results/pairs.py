"""Pairs: numbers that can be compared because they come from the same mesh, source and repetition,
and therefore from one processor. Tables, figures, `compare`, `rank` and the gate take their ratios
from this module. A time is `Row.time`, in seconds; `Pairs` has milliseconds.

docs/measuring.md describes how pairs are measured, and why.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .reader import OK, Row, Run, Source
from .statistics import DECISION_CONFIDENCE, Sample, least_for_interval

Floats = NDArray[np.float64]
Numbers = Mapping[tuple[Source, int], float]
"""Numbers by source and repetition."""
Time = Callable[[Row], float]
"""Function that returns a time in seconds of a row with outcome ok."""

MOST_STOLEN = 0.01
"""Largest share of the time of all processors that may be stolen while a row is measured."""
MOST_SWITCHES = 500.0
"""Largest number of involuntary switches per second of CPU time. A core that two or three other processes
share has 200 to 350. The CPU times of paired solves then still spread by only 2 to 3%."""


def solve(row: Row) -> float:
    return 1e-3 * row.time


def preparation(row: Row) -> float:
    return 1e-3 * (row.number("prepare_time") or 0)


def first(row: Row) -> float:
    return preparation(row) + solve(row)


def further(row: Row) -> float:
    """Returns the time of a further answer, from another source, by the same object."""
    return 1e-3 * (row.number("renew_time") or 0) + solve(row)


def each_of(sources: int) -> Time:
    """Returns the mean time per source when one object answers for this number of sources."""
    return lambda row: (first(row) + (sources - 1) * further(row)) / sources


def times(run: Run, mesh: str, solver: str, time: Time = solve) -> dict[tuple[Source, int], float]:
    rows = [row for row in run.cell(mesh, solver) if row.number("cpu_time") is not None]
    return {(row.source, row.repetition): time(row) for row in rows}


def by_source(numbers: Numbers) -> list[list[float]]:
    """Converts the numbers into a sample: one list of repetitions per source."""
    groups: dict[Source, list[float]] = {}
    for (source, _), number in numbers.items():
        groups.setdefault(source, []).append(number)
    return list(groups.values())


def paired(above: Numbers, below: Numbers) -> Sample:
    """Returns the ratios as a sample. A pair is used if both of its numbers are greater than 0."""
    both = [key for key in above if key in below]  # in order: an interval depends on the order of its sample
    return by_source({k: above[k] / below[k] for k in both if above[k] > 0 and below[k] > 0})


def ratios(run: Run, mesh: str, above: str, below: str, time: Time = solve) -> Sample:
    """Returns the ratios of the times of the solver `above` to those of the solver `below`."""
    return paired(times(run, mesh, above, time), times(run, mesh, below, time))


@dataclass(frozen=True)
class Times:
    """Times of a whole run of any size."""

    solvers: list[str]
    meshes: list[str]
    mesh_of: NDArray[np.int64]
    """Index of the mesh, by line. A line is a mesh, source and repetition."""
    seconds: Floats
    """Array of shape (lines, solvers), NaN where a solver has no time."""

    def by_mesh(self, solver: str, over: str = "") -> Floats:
        """Returns the geometric mean, by mesh, of the times or of their ratios to the times of the
        solver `over`; NaN for a mesh without times."""
        lines = self.seconds[:, self.solvers.index(solver)]
        if over:
            lines = lines / self.seconds[:, self.solvers.index(over)]
        known = ~np.isnan(lines)
        meshes, count = self.mesh_of[known], len(self.meshes)
        with np.errstate(invalid="ignore", divide="ignore"):
            sums = np.bincount(meshes, weights=np.log(lines[known]), minlength=count)
            return np.asarray(np.exp(sums / np.bincount(meshes, minlength=count)))


def all_times(run: Run) -> Times:
    rows = run.columns.take(run.columns.where("outcome", OK))
    solvers, meshes = rows.texts["solver"], rows.texts["mesh"]
    if not len(rows.numbers("source")):
        return Times(solvers, meshes, np.zeros(0, np.int64), np.zeros((0, len(solvers))))
    line = [rows.arrays["mesh"], rows.arrays["source"], rows.arrays["repetition_index"]]
    lines, line_of = np.unique(np.stack(line), axis=1, return_inverse=True)
    several = rows.numbers("threads") > 1
    milliseconds = np.where(several, rows.numbers("real_time"), rows.numbers("cpu_time"))
    seconds = np.full((lines.shape[1], len(solvers)), np.nan)
    seconds[line_of, rows.arrays["solver"]] = np.where(milliseconds > 0, 1e-3 * milliseconds, np.nan)
    return Times(solvers, meshes, lines[0].astype(np.int64), seconds)


@dataclass(frozen=True)
class Pairs:
    """Times of the two sides of a cell in milliseconds, one entry per pair."""

    first: list[float]
    second: list[float]
    disturbed: int = 0
    """Number of pairs in which a row was disturbed."""

    @property
    def ratios(self) -> list[float]:
        """The second side's time divided by the first's, by pair."""
        return [b / a for a, b in zip(self.first, self.second, strict=True)]

    def __len__(self) -> int:
        return len(self.first)


def interleaved(first_side: Iterable[Row], second_side: Iterable[Row]) -> Pairs:
    """Returns the repetitions of a cell that both sides of an interleaved run have.

    Disturbed pairs are left out if enough other pairs for an interval remain.
    """
    timed = {row.repetition: row for row in first_side if row.ok and row.time > 0}
    others = (row for row in second_side if row.repetition in timed and row.ok and row.time > 0)
    both = [(timed[row.repetition], row) for row in others]
    quiet = [pair for pair in both if not any(map(disturbed, pair))]
    kept = quiet if len(quiet) >= least_for_interval(DECISION_CONFIDENCE) else both
    return Pairs([a.time for a, _ in kept], [b.time for _, b in kept], len(both) - len(quiet))


def together(parts: Iterable[Pairs]) -> Pairs:
    """Joins the pairs of several sources or of several runs into one sample."""
    every = list(parts)
    return Pairs(
        [time for part in every for time in part.first],
        [time for part in every for time in part.second],
        sum(part.disturbed for part in every),
    )


def disturbed(row: Row) -> bool:
    """Whether the hypervisor or other processes took too much of the time of this row's process."""
    stolen = row.number("stolen_share") or 0.0
    switches = row.number("involuntary_switches_per_s") or 0.0
    return stolen > MOST_STOLEN or switches > MOST_SWITCHES
