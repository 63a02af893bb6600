"""Means of the run beside those of the thesis's Table 5.2: time, order of the solvers, windows."""

from __future__ import annotations

from dataclasses import dataclass
from statistics import geometric_mean as mean

from plots.measures import COUNTING, interval
from plots.models import groups_of_thesis, relation
from plots.ratios import BY_KEY, Ratio
from results import published
from results.published import THESIS_SOLVERS
from results.reader import Mesh, ResultError, Run
from results.statistics import Estimate, geometric_mean
from results.table import BLANK, Field, Table, estimate_field, without_empty_columns

SPEED, WINDOWS = BY_KEY["speed-up"], BY_KEY["propagations over the limit"]


@dataclass(frozen=True)
class Pair:
    """Geometric means over the models that have both numbers."""

    estimate: Estimate
    """Ours, with its interval."""
    thesis: float
    models: int

    @property
    def ours(self) -> float:
        return self.estimate.value


def compare(run: Run, meshes: list[Mesh], ratio: Ratio) -> dict[str, Pair]:
    """Returns the pairs of the solvers that have the ratio here and in the thesis on at least one model."""
    pairs = {}
    for solver in THESIS_SOLVERS:
        both = [
            (sample, thesis)
            for mesh in meshes
            if (sample := ratio.measured(run, mesh.name, solver))
            and (thesis := ratio.published(str(mesh.thesis_model), solver)) is not None
        ]
        if both:
            samples, thesis_of = zip(*both, strict=True)
            pairs[solver] = Pair(geometric_mean(samples), mean(thesis_of), len(both))
    return pairs


def table(run: Run) -> Table:
    """@raises ResultError if no mesh is or stands for a model of the thesis, or no cell can be compared"""
    groups = groups_of_thesis(run)
    rows = [row for words, meshes in groups.items() for row in _rows(run, words, meshes)]
    if not rows:
        raise ResultError(f"{run.file}: no verified cell that the thesis has a number for")
    listed = [
        f"{mesh.name} ({relation(mesh)})" for meshes in groups.values() for mesh in meshes
    ]
    return without_empty_columns(Table(
        name="table_thesis",
        title="Means of Table 5.2, ours and the thesis's",
        header=[
            "Meshes", "Solver", SPEED.label, f"{SPEED.label}, published", "Place",
            "Place, published", WINDOWS.label, f"{WINDOWS.label}, published", "Difference",
        ],
        text_columns=2,
        rows=rows,
        remarks=[
            f"Geometric means over {', '.join(listed)}, if both numbers exist, with 95% bootstrap intervals of "
            "our times; places are by time. "
            "Stand-ins are other meshes than the thesis measured: what is published "
            "is context only.",
            "Ratios of time differ from the thesis's for reasons of the programs: here edge-based takes several "
            "windows at a time by vector instructions, where the processor has them; docs/performance.md has its "
            "time without them, and what else differs. They grow with the size of a mesh: a mesh that is smaller than "
            "the model it stands for understates them.",
            f"Published: {published.citation()}, Table 5.2, measured on {published.machine()}. "
            f"{COUNTING}",
        ],
    ))  # fmt: skip


def _rows(run: Run, group: str, meshes: list[Mesh]) -> list[list[Field]]:
    speed, windows = compare(run, meshes, SPEED), compare(run, meshes, WINDOWS)
    rows: list[list[Field]] = []
    for solver in [one for one in THESIS_SOLVERS if one in speed or one in windows]:
        fewest = min(pairs[solver].models for pairs in (speed, windows) if solver in pairs)
        note = f"{solver}: on {fewest} of {len(meshes)} models." if fewest < len(meshes) else ""
        fields = [Field("" if rows else group, group), Field(solver, note=note)]
        fields += _means(speed.get(solver), spread=True)
        for side in ("ours", "thesis"):
            order = sorted(speed, key=lambda one: float(getattr(speed[one], side)))
            place = order.index(solver) + 1 if solver in speed else None
            fields.append(BLANK if place is None else Field(str(place), place))
        fields += _means(windows.get(solver))
        change = windows[solver].ours / windows[solver].thesis - 1 if solver in windows else None
        fields.append(BLANK if change is None else Field(f"{change:+.1%}", change))
        rows.append(fields)
    return rows


def _means(pair: Pair | None, *, spread: bool = False) -> list[Field]:
    """@param spread whether the interval is printed; CSV always has it"""
    if pair is None:
        return [BLANK, BLANK]
    shown = interval(pair.estimate, _two_decimals) if spread else _two_decimals(pair.ours)
    return [estimate_field(pair.estimate, shown), Field(_two_decimals(pair.thesis), pair.thesis)]


def _two_decimals(value: float) -> str:
    return f"{value:.2f}"
