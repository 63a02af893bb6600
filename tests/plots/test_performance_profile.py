"""Performance profiles: shares of questions, by the error level of the answers."""

from __future__ import annotations

from typing import Any

import pytest
import synthetic
from synthetic import Data, mesh, solver

from plots import performance_profile
from results.reader import ResultError, Run

MESHES = [f"mesh-{i}" for i in range(4)]


def row(of: str, on: str, time: float, error: float = 0, **more: Any) -> Data:
    return synthetic.row(of, on, cpu_time=time, max_relative_error=error, **more)


def run_of(rows: list[Data]) -> Run:
    return synthetic.run_of(map(solver, ("a", "b", "exact", "near")), map(mesh, MESHES), rows)


def profile_of(rows: list[Data], level: float) -> tuple[dict[str, list[float]], int]:
    return performance_profile.factors(performance_profile.answers(run_of(rows)), level)


def test_factors_are_over_the_fastest_answer_to_the_same_question() -> None:
    rows = [row("a", "mesh-0", 1), row("b", "mesh-0", 2), row("a", "mesh-1", 8), row("b", "mesh-1", 2)]
    assert profile_of(rows, 0) == ({"a": [1, 4], "b": [1, 2]}, 2)


def test_preparation_is_part_of_a_first_answer() -> None:
    rows = [row("a", "mesh-0", 1, prepare_time=9.0), row("b", "mesh-0", 5)]
    assert profile_of(rows, 0) == ({"a": [pytest.approx(2)], "b": [1]}, 1)


def test_answers_count_and_compete_only_at_a_level_that_they_keep() -> None:
    rows = [row("exact", m, 10) for m in MESHES] + [row("near", m, 1, 1e-3) for m in MESHES]
    assert profile_of(rows, 1e-6) == ({"exact": [1, 1, 1, 1]}, 4)
    assert profile_of(rows, 1e-2) == ({"exact": [10] * 4, "near": [1] * 4}, 4)


def test_a_question_without_an_answer_is_a_share_that_is_missed() -> None:
    rows = [row("a", m, 1) for m in MESHES] + [row("b", m, 3) for m in MESHES[:2]]
    axes = performance_profile.figure(run_of(rows)).figure.axes[0]
    ends = {line.get_color(): line.get_ydata()[-1] for line in axes.lines}
    assert sorted(ends.values()) == [0.5, 1]


def test_of_few_questions_nothing_is_drawn() -> None:
    with pytest.raises(ResultError, match="no 4 questions"):
        performance_profile.figure(run_of([row("a", "mesh-0", 1), row("b", "mesh-0", 2)]))
