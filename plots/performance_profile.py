"""Performance profiles (Dolan, More 2002, "Benchmarking optimization software with performance
profiles"): the share of questions that each solver answers within a factor of the fastest time."""

from __future__ import annotations

from statistics import median
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from plots import style
from plots.dots import sentences
from plots.drawing import Drawing
from plots.logarithmic import logarithmic
from plots.measures import ERROR, columns
from results.pairs import first
from results.reader import ResultError, Run, Source

LEVELS = {"largest error at most 1e-6": 1e-6, "at most 1%": 1e-2, "any error": np.inf}
"""Levels of the panels: an answer counts if its largest relative error is at most the level."""
LEAST_QUESTIONS = 4
MOST_FACTOR = 1000.0
MARKS = 5
"""Approximate number of marks on a line."""

Question = tuple[str, Source]
"""A mesh and a source."""
Answers = dict[str, dict[Question, tuple[float, float]]]
"""Seconds of a first answer and its largest relative error, by solver and question."""


def answers(run: Run) -> Answers:
    found: Answers = {}
    for solver in columns(run):
        for mesh in run.meshes:
            rows: dict[Source, list[tuple[float, float]]] = {}
            for row in run.cell(mesh, solver):
                if row.number("cpu_time") is not None and (seconds := first(row)) > 0:
                    error = row.number(ERROR.key) or 0.0
                    rows.setdefault(row.source, []).append((seconds, error))
            for source, answered in rows.items():
                times, errors = zip(*answered, strict=True)
                found.setdefault(solver, {})[mesh, source] = (median(times), max(errors))
    return found


def factors(found: Answers, level: float) -> tuple[dict[str, list[float]], int]:
    """Returns, by solver and in rising order, the times of the answers that keep the level over those of
    the fastest solver, and the number of questions that have such an answer."""
    kept = {
        solver: {question: seconds for question, (seconds, error) in by.items() if error <= level}
        for solver, by in found.items()
    }
    fastest: dict[Question, float] = {}
    for by in kept.values():
        for question, seconds in by.items():
            fastest[question] = min(seconds, fastest.get(question, np.inf))
    return {
        solver: sorted(seconds / fastest[question] for question, seconds in by.items())
        for solver, by in kept.items()
        if by
    }, len(fastest)


def figure(run: Run) -> Drawing:
    """@raises ResultError for a run of fewer than LEAST_QUESTIONS questions, or of one solver"""
    found = answers(run)
    questions = {question for by in found.values() for question in by}
    if len(found) < 2 or len(questions) < LEAST_QUESTIONS:
        raise ResultError(f"{run.file}: no {LEAST_QUESTIONS} questions with answers of two solvers")
    looks = style.solver_styles(run.solvers)
    picture = style.new_figure(3.4 + 0.11 * len(found), width=9)
    panels = picture.subplots(1, len(LEVELS), sharey=True)
    best = []
    for axes, (title, level) in zip(panels, LEVELS.items(), strict=True):
        profile, count = factors(found, level)
        _draw(axes, profile, count, looks)
        axes.set_title(title, fontsize=9.5)
        fastest = max(profile, key=lambda solver: sum(f == 1 for f in profile[solver]), default="")
        share = sum(f == 1 for f in profile.get(fastest, [])) / max(count, 1)
        best.append(f"{title}: {fastest} on {share:.0%}")
    panels[0].set_ylabel("share of questions")
    panels[1].set_xlabel("preparation and one solve: time over that of the fastest")
    handles = [
        Line2D([], [], label=style.plain(s), **_line(looks[s])) for s in found
    ]
    style.legend_above(picture, handles, columns=6)
    return Drawing(
        title="Performance profiles",
        caption=sentences(
            f"Of {len(questions)} questions, each a mesh and a source, the share that a solver answers "
            "within a factor of the fastest one (Dolan, More 2002): the height at 1 says how often it "
            "is the fastest, the height at the right how often it answers at all. Time: preparation "
            "and a solve, medians over repetitions. Each panel counts the answers up to a largest relative "
            "error, and compares them only with each other.",
            f"Most often the fastest: {'; '.join(best)}.",
        ),
        figure=picture,
    )


def _line(look: style.SolverStyle) -> dict[str, Any]:
    return {"color": look.color, "linestyle": look.line, "marker": look.marker, "markersize": 4}


def _draw(
    axes: Axes, profile: dict[str, list[float]], count: int, looks: dict[str, style.SolverStyle]
) -> None:
    most = min(max((of[-1] for of in profile.values()), default=2.0) * 1.2, MOST_FACTOR)
    for solver, of in profile.items():
        x = np.array([1.0, *of, most])
        y = np.array([sum(f <= 1 for f in of), *range(1, len(of) + 1), len(of)]) / count
        axes.step(x, y, where="post", markevery=max(1, len(of) // MARKS), **_line(looks[solver]))
    axes.set_ylim(0, 1.02)
    logarithmic(axes.xaxis)
    axes.set_xlim(1, most)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:.0%}")
    axes.grid()
