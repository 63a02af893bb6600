#!/usr/bin/python3
"""One picture of a run: each solver's time over that of the edge-based one, and its windows.

Left, geometric mean of the paired time ratios on each mesh, a mark a mesh; right, window
propagations over the window limit (docs/metrics.md). A hollow mark is a stand-in for a model of the
thesis. Numbers: run.json.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from pathlib import Path
from statistics import geometric_mean
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from measures import EDGE_BASED, LIMIT_SOLVER
from published import THESIS_SOLVERS
from results import Mesh, ResultError, Row, Run, newest_run, read_run

KINDS: dict[str, dict[str, Any]] = {
    "the thesis's model": {"marker": "o", "color": "0.2"},
    "stand-in for one": {"marker": "o", "color": "0.2", "markerfacecolor": "none"},
    "other mesh": {"marker": ".", "color": "0.6"},
}
"""How the mark of a mesh is drawn, by what the mesh is to the thesis: readable in grey."""


def kind(mesh: Mesh) -> str:
    model, stand_in, other = KINDS
    return other if mesh.thesis_model is None else stand_in if mesh.stand_in else model


def paired(run: Run, mesh: str, solver: str, key: str, base: str, base_key: str) -> list[float]:
    """Ratios of the same source and repetition, where both solvers have the number."""

    def by_cell(name: str, number: str) -> dict[tuple[int, int], float]:
        def place(row: Row) -> tuple[int, int]:
            return row.source, row.repetition

        return {place(r): r.numbers[number] for r in run.cell(mesh, name) if number in r.numbers}

    ours, theirs = by_cell(solver, key), by_cell(base, base_key)
    return [ours[place] / theirs[place] for place in ours if theirs.get(place, 0) > 0]


def draw_ratios(axes: Axes, run: Run, key: str, base: str, base_key: str, label: str) -> None:
    """@raises ResultError when no solver can be compared with the base."""
    solvers = [s for s in THESIS_SOLVERS if s in run.solvers]
    for place, solver in enumerate(solvers):
        means = {
            name: geometric_mean(ratios)
            for name in run.meshes
            if (ratios := paired(run, name, solver, key, base, base_key))
        }
        if not means:
            continue
        for name, mean in means.items():
            axes.plot([mean], [place], linestyle="", **KINDS[kind(run.meshes[name])])
        mean = geometric_mean(means.values())
        axes.plot([mean], [place], "|", color="tab:red", markersize=20, markeredgewidth=2.5)
        axes.annotate(
            f"{mean:.2f}", (mean, place), xytext=(0, 12), textcoords="offset points",
            ha="center", color="tab:red",
        )  # fmt: skip
    if not axes.lines:
        raise ResultError(f"{run.file}: no verified cell of {base} to compare with; nothing to draw")
    axes.set_yticks(range(len(solvers)), solvers)
    axes.set_ylim(-0.6, len(solvers) - 0.3)
    axes.axvline(1, color="0.8", zorder=0)
    axes.set_xlabel(label)
    axes.spines[["top", "right"]].set_visible(False)


def draw(run: Run, file: Path) -> None:
    figure, (times, windows) = plt.subplots(1, 2, figsize=(9, 3.2), layout="constrained")
    draw_ratios(times, run, "cpu_time", EDGE_BASED, "cpu_time", "time / time of edge-based")
    draw_ratios(
        windows, run, "window_propagations", LIMIT_SOLVER, "window_limit",
        "window propagations / window limit",
    )  # fmt: skip
    windows.set_yticklabels([])
    times.set_xlim(left=0)
    counts = Counter(map(kind, run.meshes.values()))
    marks = [
        Line2D([], [], linestyle="", label=f"{name} ({counts[name]})", **style)
        for name, style in KINDS.items()
        if counts[name]
    ]
    mean = Line2D([], [], linestyle="", label="geometric mean", marker="|", color="tab:red")
    figure.suptitle(" ")  # room for the legend
    figure.legend(handles=[*marks, mean], loc="upper center", ncols=4, frameon=False)
    figure.savefig(file, dpi=150)
    plt.close(figure)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--run", type=Path, metavar="DIR", help="run folder (default: the newest)")
    parser.add_argument("--out", type=Path, metavar="FILE", help="default: RUN/overview.png")
    options = parser.parse_args()
    try:
        folder = options.run or newest_run()
        file = options.out or folder / "overview.png"
        draw(read_run(folder), file)
    except (ResultError, OSError) as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return 1
    print(file)
    return 0


if __name__ == "__main__":
    sys.exit(main())
