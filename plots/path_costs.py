"""Paths from one source: their costs, and their excess over the shortest paths."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from plots import style
from plots.dots import sentences as in_lines
from plots.drawing import Drawing
from plots.logarithmic import logarithmic
from plots.measures import ERROR, columns, count, percent
from plots.ratios import fastest_exact, mean, number
from results.reader import ResultError, Row, Run, Source
from results.table import BLANK, Field, Table

COUNTS = (1, 10, 100, 1000)
"""Numbers of paths whose costs are in the table."""
MOST = 10_000
"""Largest number of paths in the figure."""
SHORTEST = 1e-9
"""Relative excess over the exact distance below which a path is the shortest, as in the schema."""


@dataclass(frozen=True)
class Paths:
    """The numbers in `paths` of a row; times are in milliseconds."""

    targets: int
    alone_time: float
    first_time: float
    further_time: float
    max_excess: float
    mean_excess: float
    shortest: int
    off_surface: int
    failed: int

    def cost(self, paths: int) -> float:
        """Returns the time of so many paths from one source, without preparation: by a query for each
        path or by one solve for all, whichever takes less."""
        return min(paths * self.alone_time, self.first_time + (paths - 1) * self.further_time)


ByMesh = dict[str, dict[Source, Paths]]
"""Paths of a solver, by mesh and source."""


def paths_of(row: Row) -> Paths | None:
    """Returns the row's numbers on paths, or None if it has none."""
    found = {key: row.number(f"paths.{key}") for key in Paths.__annotations__}
    if found["targets"] is None:
        return None
    return Paths(**{key: value or 0 for key, value in found.items()})  # type: ignore[arg-type]


def measured(run: Run) -> dict[str, ByMesh]:
    """Returns the paths of each solver. @raises ResultError for a run without paths"""
    by_solver: dict[str, ByMesh] = {}
    for solver in columns(run):
        for mesh in run.meshes:
            found: dict[Source, Paths] = {}
            for row in run.cell(mesh, solver):  # only the first repetition has paths, or all have the same
                if (paths := paths_of(row)) is not None:
                    found.setdefault(row.source, paths)
            if found:
                by_solver.setdefault(solver, {})[mesh] = found
    if not by_solver:
        raise ResultError(f"{run.file}: no paths were measured; run --path-targets 100")
    return by_solver


def base_of(run: Run, by_solver: dict[str, ByMesh]) -> str:
    """Returns the solver that costs are compared with: the fastest exact one with paths.

    @raises ResultError if there is none"""
    base = fastest_exact(run, but=[solver for solver in columns(run) if solver not in by_solver])
    if base not in by_solver or not run.solvers[base].exact:
        raise ResultError(f"{run.file}: no exact solver has paths")
    return base


def over_base(own: ByMesh, base: ByMesh, paths: int) -> float | None:
    """Returns the ratio of the costs of so many paths: the geometric mean over meshes of the means over
    the sources that both solvers have; None if there are none."""
    ratios = [
        mean([own[mesh][source].cost(paths) / base[mesh][source].cost(paths) for source in both])
        for mesh in own
        if (both := [source for source in own[mesh] if source in base.get(mesh, ())])
    ]
    return mean(ratios) if ratios else None


@dataclass(frozen=True)
class Lengths:
    """Numbers on the lengths of many paths."""

    targets: int
    mean_excess: float
    """Mean over the paths that lead over the surface; `max_excess` is their largest."""
    max_excess: float
    shortest: float
    """Share of the shortest paths among all."""
    off_surface: int
    failed: int

    @property
    def share(self) -> str:
        return percent(self.shortest) if self.shortest else "none"


def _all(costs: ByMesh) -> list[Paths]:
    return [paths for each in costs.values() for paths in each.values()]


def _lengths(many: list[Paths]) -> Lengths:
    targets, shortest, off_surface, failed = (
        sum(getattr(paths, key) for paths in many)
        for key in ("targets", "shortest", "off_surface", "failed")
    )
    sound = [paths.targets - paths.off_surface - paths.failed for paths in many]
    total = sum(s * paths.mean_excess for s, paths in zip(sound, many, strict=True))
    return Lengths(
        targets, total / max(1, sum(sound)), max(paths.max_excess for paths in many),
        shortest / max(1, targets), off_surface, failed,
    )  # fmt: skip


def table(run: Run) -> Table:
    """Returns a row per solver, over all meshes. @raises ResultError for the reasons of base_of()"""
    by_solver = measured(run)
    base = base_of(run, by_solver)
    rows = []
    for solver, costs_of_solver in by_solver.items():
        costs = [over_base(costs_of_solver, by_solver[base], n) for n in COUNTS]
        rows.append([
            Field(solver), *[BLANK if c is None else Field(number(c), c) for c in costs],
            *_fields(_lengths(_all(costs_of_solver))),
        ])  # fmt: skip
    return Table(
        name="path_costs",
        title="Paths from one source",
        header=["Solver", *[f"{n:,} {'path' if n == 1 else 'paths'} / {base}" for n in COUNTS], *HEADER],
        text_columns=1,
        rows=rows,
        remarks=[
            "Time of this number of paths from one source over that of the base, without preparation: by a query for "
            "each, which stops at its target, or by one solve, whichever takes less. Geometric means over meshes and "
            "sources.",
            REMARK,
        ],
    )


HEADER = ["Mean excess", "Largest excess", "Shortest", "Off the surface", "Failed"]
REMARK = (
    "Excess: the length of a path beyond the exact distance, relative to it. Shortest: the share of paths with an "
    f"excess below {SHORTEST:g}. Off the surface: paths with a piece that lies on no face. Failed: the solver gave "
    "up, or the path ends elsewhere. The excess is that of all other paths."
)


def _fields(lengths: Lengths) -> list[Field]:
    lost = [Field(count(n), n) for n in (lengths.off_surface, lengths.failed)]
    if lengths.off_surface + lengths.failed == lengths.targets:
        return [BLANK, BLANK, BLANK, *lost]
    excess = [Field(ERROR.show(one), one) for one in (lengths.mean_excess, lengths.max_excess)]
    return [*excess, Field(lengths.share, lengths.shortest), *lost]


def by_mesh(run: Run) -> Table:
    """Returns a row per mesh and solver. @raises ResultError for the reasons of measured()"""
    by_solver = measured(run)
    rows = []
    for mesh in run.meshes:
        for solver in (solver for solver in by_solver if mesh in by_solver[solver]):
            by_source = list(by_solver[solver][mesh].values())
            times = [
                float(np.mean([getattr(paths, key) for paths in by_source]))
                for key in ("alone_time", "first_time", "further_time")
            ]
            rows.append([
                Field(run.meshes[mesh].label), Field(solver),
                *[Field(number(time), time) for time in times], *_fields(_lengths(by_source)),
            ])  # fmt: skip
    return Table(
        name="path_numbers",
        title="Paths from one source, by mesh",
        header=["Mesh", "Solver", "One alone (ms)", "First (ms)", "Each further (ms)", *HEADER],
        text_columns=2,
        rows=rows,
        remarks=[
            "One alone: a query for one target, which stops there, and its path. First: a solve for all vertices and "
            "one path. Each further: one more path after that. Means over sources, without preparation.",
            REMARK,
        ],
    )


def break_even(costs: ByMesh, base: ByMesh) -> int | None:
    """Returns the number of paths, at most MOST, from which the base takes less time; None if there is none,
    or if the base takes less time for one path too."""
    def dearer(paths: int) -> bool:
        ratio = over_base(costs, base, paths)
        return ratio is not None and ratio > 1

    if dearer(1) or not dearer(MOST):
        return None
    low, high = 1, MOST
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if dearer(middle) else (middle, high)
    return high


def sentences(run: Run) -> list[str]:
    """Returns sentences on costs and lengths of paths. @raises ResultError for the reasons of base_of()"""
    found = measured(run)
    base = base_of(run, found)
    said = []
    lengths = {solver: _lengths(_all(of)) for solver, of in found.items()}
    right = [solver for solver, of in lengths.items() if of.shortest == 1]
    if right:
        said.append(f"All paths of {', '.join(right)} are the shortest ones and lead over the surface.")
    for solver, of in lengths.items():
        if solver in right:
            continue
        lost = [f"{n:,} {what}"
                for n, what in ((of.off_surface, "leave the surface"), (of.failed, "fail")) if n]  # fmt: skip
        said.append(
            f"Of {of.targets:,} paths of {solver}, {of.share} {'are' if of.shortest else 'is'} the shortest; they are "
            f"{percent(of.mean_excess)} longer in the mean, and {percent(of.max_excess)} at most"
            + (f"; {' and '.join(lost)}." if lost else ".")
        )
        if (n := break_even(found[solver], found[base])) is not None:
            said.append(f"From {n:,} paths on {base} takes less time than {solver}.")
    return said


def figure(run: Run) -> Drawing:
    """@raises ResultError for the reasons of base_of()"""
    found = measured(run)
    base = base_of(run, found)
    looks = style.solver_styles(run.solvers)
    lengths = {solver: _lengths(_all(of)) for solver, of in found.items()}
    longer = {solver: of for solver, of in lengths.items() if of.max_excess > SHORTEST}
    picture = style.new_figure(max(3.4 + 0.11 * len(found), 2.4 + 0.3 * len(longer)), width=9)
    panels = picture.subplots(1, 2 if longer else 1, squeeze=False, width_ratios=[3, 2] if longer else None)[0]
    _draw_costs(panels[0], found, base, looks)
    if longer:
        _draw_lengths(panels[1], longer, looks)
    style.legend_above(picture, [
        Line2D([], [], label=style.plain(s), color=looks[s].color, linestyle=looks[s].line) for s in found
    ], columns=6)  # fmt: skip
    return Drawing(
        title="Paths from one source",
        caption=in_lines(
            f"On {len(run.meshes)} meshes. Left: the time of a number of paths from one source over that of {base}, "
            "without preparation: by a query for each, which stops at its target, or by one solve, whichever takes "
            "less; geometric means over meshes and sources."
            + (" Right: excess of paths over the exact distance, for solvers with longer paths. Filled: the mean; hollow: "
               "the largest of all paths on the surface; the number is the share of paths that are shortest."
               if longer else ""),
        ),
        figure=picture,
    )  # fmt: skip


def _draw_costs(
    axes: Axes, found: dict[str, ByMesh], base: str, looks: dict[str, style.SolverStyle]
) -> None:  # fmt: skip
    numbers = np.unique(np.geomspace(1, MOST, 60).round().astype(int)).tolist()
    for solver, of in found.items():
        line = [over_base(of, found[base], n) for n in numbers]
        if None not in line:
            axes.plot(numbers, line, color=looks[solver].color, linestyle=looks[solver].line)
    logarithmic(axes.xaxis, axes.yaxis)
    axes.set_title(f"time, over {style.plain(base)}'s", fontsize=9.5)
    axes.set_xlabel("paths from one source")
    axes.grid()


def _draw_lengths(axes: Axes, longer: dict[str, Lengths], looks: dict[str, style.SolverStyle]) -> None:
    for place, (solver, of) in enumerate(longer.items()):
        average, largest = of.mean_excess, of.max_excess
        color = looks[solver].color
        axes.plot([average, largest], [place, place], color=color, linewidth=0.8)
        axes.plot([average], [place], color=color, marker="o")
        axes.plot([largest], [place], color=color, marker="o", markerfacecolor="white")
        axes.annotate(f"shortest: {of.share}", (largest, place), xytext=(0, 7),
                      textcoords="offset points", ha="right", fontsize=8)  # fmt: skip
    axes.set_yticks(range(len(longer)), [style.plain(solver) for solver in longer])
    axes.set_ylim(len(longer) - 0.5, -0.6)
    logarithmic(axes.xaxis)
    axes.set_title("excess over the exact distance", fontsize=9.5)
    axes.grid(axis="x")
