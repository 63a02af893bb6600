"""Running time split into window propagation, trimming and queue maintenance, as in the thesis's Figure 5.9."""

from __future__ import annotations

from dataclasses import dataclass

from matplotlib.axes import Axes
from matplotlib.patches import Patch

from plots import style
from plots.dots import sentences, reach
from plots.models import ordered_meshes, titled
from plots.drawing import Drawing
from plots.measures import (
    TIME, Measure, TimeUnit, columns, failure, measured_solvers, median_of, time_unit,
)  # fmt: skip
from results.reader import Mesh, ResultError, Run
from results.statistics import Estimate

MODELS = 2
PHASES = {
    "propagation": ("window propagation", "#0072B2", ""),
    "trimming": ("window trimming", "#F0E442", "////"),
    "queue": ("queue maintenance", "#CC79A7", "...."),
}
"""Name, colour and hatch of each phase, by its key in a row's `phase_seconds`."""
ABSENT = "no phase times, or far beyond the others"
APART = 0.1
"""A bar is not drawn if the sum of its phases differs by more than this share from the timed solve."""
REST = ("rest", "white", "")
OVERHEAD = "timer_overhead"


def phase_measure(key: str) -> Measure:
    return Measure(f"phase_seconds.{key}", key, str)


@dataclass(frozen=True)
class Split:
    """Times of one solver on one mesh in seconds: of a timed solve, and of the phases of another solve."""

    solver: str
    seconds: Estimate
    phases: dict[str, float]
    overhead: float

    @property
    def time(self) -> float:
        return self.seconds.value

    @property
    def together(self) -> float:
        """Sum of the phases over the time of the timed solve."""
        return sum(self.phases.values()) / self.time

    @property
    def overhead_share(self) -> float:
        """Share of the timers in the solve with timers."""
        return self.overhead / (self.overhead + sum(self.phases.values()))

    def parts(self) -> list[tuple[tuple[str, str, str], float]]:
        shown = {key: time / max(1, self.together) for key, time in self.phases.items()}
        rest = max(0, self.time - sum(shown.values()))
        return [(PHASES[key], value) for key, value in shown.items()] + [(REST, rest)]


def split(run: Run, mesh: str, solver: str) -> Split | None:
    """Returns medians over sources, or None if the solver has no phase times on the mesh."""

    def middle(measure: Measure) -> float | None:
        median = median_of(run, mesh, solver, measure)
        return median.value if median else None

    time = median_of(run, mesh, solver, TIME)
    phases = {key: middle(phase_measure(key)) for key in PHASES}
    known = {key: value for key, value in phases.items() if value is not None}
    if not time or not time.value or len(known) < len(PHASES) or not sum(known.values()):
        return None
    return Split(solver, time, known, middle(phase_measure(OVERHEAD)) or 0)


def splits(run: Run, mesh: str) -> list[Split]:
    """Returns the splits whose phases add up to the timed solve, without those far slower than the thesis's."""
    splits_of = (split(run, mesh, solver) for solver in measured_solvers(run))
    found = [one for one in splits_of if one and abs(one.together - 1) <= APART]
    limit = reach({one.solver: [one.time] for one in found})
    return [one for one in found if one.time <= limit]


def chosen_meshes(run: Run) -> list[Mesh]:
    """Returns MODELS meshes: the thesis's models first, then by number of splits, then by size."""

    def merit(mesh: Mesh) -> tuple[bool, int, int]:
        return mesh.thesis_model is not None, len(splits(run, mesh.name)), mesh.vertices

    with_phases = [mesh for mesh in ordered_meshes(run) if splits(run, mesh.name)]
    return sorted(with_phases, key=merit, reverse=True)[:MODELS]


def figure(run: Run) -> Drawing:
    """@raises ResultError if there are no phase times"""
    chosen = chosen_meshes(run)
    if not chosen:
        raise ResultError(f"{run.file}: no verified cell has phase_seconds that add up to its time")
    drawn = {mesh.name: splits(run, mesh.name) for mesh in chosen}
    most = max(map(len, drawn.values()))
    picture = style.new_figure(1.2 + len(chosen) * (0.55 + 0.26 * most))
    panels = picture.subplots(len(chosen), 1, squeeze=False)[:, 0]
    unit = time_unit([one.time for found in drawn.values() for one in found])
    for axes, mesh in zip(panels, chosen, strict=True):
        _draw(axes, mesh, drawn[mesh.name], unit)
    panels[-1].set_xlabel(f"CPU time of one solve ({unit.name})")
    kinds = [*PHASES.values(), REST]
    handles = [
        Patch(facecolor=color, hatch=hatch, edgecolor=style.INK, linewidth=0.6, label=name)
        for name, color, hatch in kinds
    ]
    style.legend_above(picture, handles)
    return Drawing(
        title=titled(run, "Statistics of running time", "Figure 5.9"),
        caption=_caption(run, drawn),
        figure=picture,
    )


def _draw(axes: Axes, mesh: Mesh, splits: list[Split], unit: TimeUnit) -> None:
    longest = unit.scale * max(one.seconds.high for one in splits)
    for place, one in enumerate(splits):
        left = 0.0
        for (_, color, hatch), time in one.parts():
            width = unit.scale * time
            axes.barh(
                place, width, 0.68, left, color=color, hatch=hatch, edgecolor=style.INK,
                linewidth=0.6,
            )  # fmt: skip
            left += width
        bars = [[unit.scale * length for length in lengths] for lengths in style.bars([one.seconds])]
        axes.errorbar([unit.scale * one.time], [place], xerr=bars, color=style.INK, elinewidth=1, capsize=2)
        right = max(left, unit.scale * one.seconds.high)
        axes.text(right + 0.01 * longest, place, unit.text(one.time), va="center", fontsize=9)
    axes.set_yticks(range(len(splits)), [style.plain(one.solver) for one in splits])
    axes.set_ylim(len(splits) - 0.45, -0.55)
    axes.set_xlim(0, 1.14 * longest)
    axes.tick_params(axis="y", length=0)
    axes.grid(axis="x")
    axes.set_title(f"{style.plain(mesh.label)}, {mesh.vertices:,} vertices", loc="left")


def _caption(run: Run, drawn: dict[str, list[Split]]) -> str:
    shares = [one.overhead_share for found in drawn.values() for one in found]
    apart, absent = [], []
    for mesh, found in drawn.items():
        not_drawn = [s for s in columns(run) if s not in [one.solver for one in found]]
        for solver in not_drawn:
            one = split(run, mesh, solver)
            if one and abs(one.together - 1) > APART:
                apart.append(f"{solver} on {mesh} ({one.together - 1:+.0%})")
            else:
                failed = failure(run, mesh, solver)
                absent.append(f"{solver} on {mesh} ({failed.text if failed else ABSENT})")
    return sentences(
        "The length of a bar is the CPU time of a timed solve, the median over sources and repetitions with its "
        "95% bootstrap interval. "
        "The phases come from a separate solve with timers; the cost of the timers "
        f"({min(shares):.0%} to {max(shares):.0%} of that solve) is subtracted. Rest is the time of the "
        "timed solve minus the phases.",
        f"Not drawn, since the phases differ by more than {APART:.0%} from the timed solve: {', '.join(apart)}."
        if apart
        else "",
        f"Without phases: {', '.join(absent)}." if absent else "",
    )
