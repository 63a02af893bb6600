"""Runs of many meshes: what is said of all of them together, where a line for each would not be read.

Ratios are of the same mesh, source and repetition, so of one processor; a mesh counts once, by the
geometric mean over its sources and repetitions. What is shown is how meshes spread.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from plots import style
from plots.dots import sentences
from plots.drawing import Drawing
from plots.logarithmic import logarithmic, ratio_axis
from plots.measures import EDGE_BASED, baseline, columns, measured_solvers
from results.reader import OK, ResultError, Run
from results.table import BLANK, Cell, Table

MANY = 100
"""Meshes: with more, this module draws a run."""
QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95)
BINS = 24
"""Of the meshes by their vertices, on a logarithmic axis."""
LEAST = 3
"""Meshes of a bin."""

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Times:
    """Of a run, in seconds; NaN where a solver has none."""

    solvers: list[str]
    meshes: list[str]
    mesh_of: NDArray[np.int64]
    """By line: its mesh. A line is a mesh, source and repetition."""
    seconds: Floats
    """Lines x solvers."""

    def by_mesh(self, lines: Floats) -> Floats:
        """Geometric means of the lines of each mesh; NaN where none has a value."""
        known = ~np.isnan(lines)
        count = np.bincount(self.mesh_of[known], minlength=len(self.meshes))
        sums = np.bincount(
            self.mesh_of[known], weights=np.log(lines[known]), minlength=len(self.meshes)
        )
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(np.exp(sums / count))


def times(run: Run) -> Times:
    rows = run.columns.take(run.columns.where("outcome", OK))
    solvers, meshes = rows.texts["solver"], rows.texts["mesh"]
    line = [rows.arrays["mesh"], rows.arrays["source"], rows.arrays["repetition_index"]]
    lines, line_of = np.unique(np.stack(line), axis=1, return_inverse=True)
    several = rows.number("threads") > 1
    milliseconds = np.where(several, rows.number("real_time"), rows.number("cpu_time"))
    seconds = np.full((lines.shape[1], len(solvers)), np.nan)
    seconds[line_of, rows.arrays["solver"]] = np.where(milliseconds > 0, 1e-3 * milliseconds, np.nan)
    return Times(solvers, meshes, lines[0].astype(np.int64), seconds)


def ratios(run: Run, base: str) -> dict[str, Floats]:
    """By solver: of every mesh that has both, the time over that of the base."""
    found = times(run)
    if base not in found.solvers:
        return {}
    below = found.seconds[:, found.solvers.index(base)]
    by_solver = {
        solver: found.by_mesh(found.seconds[:, place] / below)
        for place, solver in enumerate(found.solvers)
    }
    return {
        solver: by_solver[solver][~np.isnan(by_solver[solver])]
        for solver in measured_solvers(run)
        if not np.isnan(by_solver[solver]).all()
    }


def table(run: Run) -> Table:
    """@raises ResultError when nothing has a time"""
    base = baseline(run, EDGE_BASED)
    of = ratios(run, base)
    if not of:
        raise ResultError(f"{run.file}: no solver has a time beside {base}'s")
    order = sorted(columns(run), key=lambda s: _mean(of[s]) if s in of else float("inf"))
    cells = run.columns
    ok = cells.where("outcome", OK)
    errors = cells.number("max_relative_error")
    body = []
    for solver in order:
        own = cells.where("solver", solver)
        values = of.get(solver)
        spread = [BLANK] * (1 + len(QUANTILES))
        if values is not None:
            shown = [_mean(values), *np.quantile(values, QUANTILES)]
            spread = [Cell(_digits(value), float(value)) for value in shown]
        known = errors[own & ok & ~np.isnan(errors)]
        right, failed = cells.cells(own & ok), cells.cells(own & ~ok)
        body.append([
            Cell(solver),
            Cell(f"{right:,}", right),
            Cell(f"{failed:,}", failed),
            Cell("" if values is None else f"{len(values):,}", 0 if values is None else len(values)),
            *spread,
            Cell(f"{known.max():.1e}", float(known.max())) if len(known) else BLANK,
        ])  # fmt: skip
    return Table(
        name="summary",
        title="Results over all meshes",
        header=["Solver", "Cells verified", "Cells without a time", "Meshes", f"Time / {base}",
                *(f"{100 * q:.0f}%" for q in QUANTILES), "Largest error"],
        text_columns=1,
        rows=body,
        remarks=[
            f"{len(run.meshes):,} meshes. Ratios of times are paired by mesh, source and repetition; a "
            "mesh counts once, by its geometric mean. Time: the geometric mean over the meshes that "
            "have both times, whose number stands before it; then quantiles over these meshes. Tables "
            "of fewer meshes have a line for each: python3 -m plots --meshes A,B.",
        ],
    )  # fmt: skip


def overview(run: Run) -> Drawing:
    """How each solver's ratio of time spreads over meshes. @raises ResultError as table does"""
    base = baseline(run, EDGE_BASED)
    of = {solver: values for solver, values in ratios(run, base).items() if solver != base}
    if not of:
        raise ResultError(f"{run.file}: no solver has a time beside {base}'s")
    styles = style.solver_styles(run.solvers)
    picture = style.new_figure(0.9 + 0.34 * len(of))
    axes = picture.subplots()
    order = sorted(of, key=lambda solver: _mean(of[solver]))
    for place, solver in enumerate(order):
        low, first, middle, third, high = np.quantile(of[solver], QUANTILES)
        color = styles[solver].color
        axes.plot([low, high], [place, place], color=color, linewidth=1)
        axes.plot([first, third], [place, place], color=color, linewidth=5, solid_capstyle="butt")
        axes.plot([middle], [place], "o", color="white", markeredgecolor=color, markersize=5)
        axes.plot([_mean(of[solver])], [place], "|", color=style.INK, markersize=14)
        axes.annotate(_digits(_mean(of[solver])), (high, place), (5, 0), va="center",
                      textcoords="offset points", fontsize=8)  # fmt: skip
    axes.set_yticks(range(len(order)), [style.plain(solver) for solver in order])
    axes.set_ylim(len(order) - 0.4, -0.6)
    axes.margins(x=0.08)
    ratio_axis(axes.xaxis)
    axes.set_xlabel(f"time / {style.plain(base)}")
    return Drawing(
        title="Overview",
        caption=sentences(
            f"Each solver's time over that of {base}, on {len(run.meshes):,} meshes: thin lines hold 90% "
            "of the meshes, thick ones 50%, the circle is the median, the bar with the number the "
            "geometric mean. Ratios are paired by mesh, source and repetition; a mesh counts once."
        ),
        figure=picture,
    )


def over_vertices(run: Run) -> Drawing:
    """Times by the meshes' sizes. @raises ResultError when nothing has a time"""
    found = times(run)
    vertices = np.array([run.meshes[mesh].vertices for mesh in found.meshes], float)
    if not len(vertices):
        raise ResultError(f"{run.file}: nothing has a time")
    edges = np.geomspace(vertices.min(), vertices.max() * 1.001, BINS + 1)
    place = np.digitize(vertices, edges) - 1
    styles = style.solver_styles(run.solvers)
    picture = style.new_figure(4.4)
    axes = picture.subplots()
    handles = []
    for solver in measured_solvers(run):
        seconds = found.by_mesh(found.seconds[:, found.solvers.index(solver)])
        at: list[float] = []
        low: list[float] = []
        middle: list[float] = []
        high: list[float] = []
        for one in range(BINS):
            own = (place == one) & ~np.isnan(seconds)
            if own.sum() >= LEAST:
                at.append(float(np.exp(np.log(vertices[own]).mean())))
                quantiles = np.quantile(seconds[own], (0.1, 0.5, 0.9))
                for values, quantile in zip((low, middle, high), quantiles, strict=True):
                    values.append(quantile)
        if not at:
            continue
        look = styles[solver]
        axes.fill_between(at, low, high, color=look.color, alpha=0.12, linewidth=0)
        mark = {"color": look.color, "marker": look.marker, "markersize": 3.5, "linestyle": look.line}
        axes.plot(at, middle, **mark)
        handles.append(Line2D([], [], label=style.plain(solver), **mark))
    for axis in (axes.xaxis, axes.yaxis):
        logarithmic(axis)
    axes.set_xlabel("vertices $n$")
    axes.set_ylabel("time of one solve (s)")
    axes.grid()
    style.legend_above(picture, handles, columns=5)
    return Drawing(
        title="Time against vertices",
        caption=sentences(
            f"Medians over meshes of a size, {len(found.meshes):,} meshes in all; a mesh counts by the "
            "geometric mean over its sources and repetitions. Bands hold 80% of the meshes."
        ),
        figure=picture,
    )


def _mean(values: Floats) -> float:
    return float(np.exp(np.log(values).mean()))


def _digits(value: float) -> str:
    return f"{value:.3f}" if value < 10 else f"{value:,.1f}"
