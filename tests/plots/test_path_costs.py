"""Costs and lengths of paths: numbers, sentences and the figure."""

from __future__ import annotations

import pytest
from synthetic import changed_rows
from test_figures import LONGER, PATHS, with_paths

from plots import path_costs
from plots.path_costs import ByMesh, Paths
from results.reader import ResultError, Run


def paths(alone: float = 1, first: float = 1, further: float = 1, **others: float) -> Paths:
    known = {"targets": 10, "max_excess": 0, "mean_excess": 0, "shortest": 10, "off_surface": 0, "failed": 0}
    return Paths(alone_time=alone, first_time=first, further_time=further, **(known | others))  # type: ignore[arg-type]


def test_paths_cost_a_query_each_or_one_solve_for_all_as_takes_less() -> None:
    of = paths(alone=2, first=10, further=0.5)
    assert [of.cost(n) for n in (1, 5, 6, 101)] == [2, 10, 12, 60]


def test_costs_are_means_over_the_sources_that_both_have_and_then_over_meshes() -> None:
    base: ByMesh = {"m": {0: paths(), 5: paths()}, "n": {3: paths(), 4: paths(first=9, alone=9)}}
    of: ByMesh = {"m": {0: paths(first=2, alone=2), 5: paths(first=8, alone=8)},
          "n": {3: paths(first=16, alone=16), 6: paths(first=99, alone=99)}, "o": {0: paths()}}
    assert path_costs.over_base(of, base, 1) == pytest.approx(8)
    assert path_costs.over_base({"o": {0: paths()}}, base, 1) is None


def test_the_base_takes_less_time_from_a_number_of_paths_on() -> None:
    base: ByMesh = {"m": {0: paths(alone=100, first=100, further=0)}}
    assert path_costs.break_even({"m": {0: paths(alone=11, first=11, further=1)}}, base) == 91
    assert path_costs.break_even({"m": {0: paths(alone=11, first=11, further=0.001)}}, base) is None
    assert path_costs.break_even({"m": {0: paths(alone=200, first=200, further=9)}}, base) is None


def test_words_say_who_is_right_and_how_far_the_others_are_off(golden_run: Run) -> None:
    said = path_costs.sentences(with_paths(golden_run))
    assert said[0].startswith("All paths of ") and "edge-based" in said[0]
    assert any(s.startswith("Of ") and "of dijkstra, 40% are the shortest; they are 0.1% longer in the mean, and 4% at most." in s
               for s in said)  # fmt: skip
    assert "From 23 paths on edge-based takes less time than dijkstra." not in said  # its first path costs as much


def test_paths_that_leave_the_surface_or_fail_are_counted_and_have_no_length(golden_run: Run) -> None:
    lost = PATHS | {"shortest": 0, "off_surface": 99, "failed": 1}
    run = changed_rows(golden_run, lambda row: row | {"paths": lost if row["solver"] == "mmp" else PATHS}
                       if row["outcome"] == "ok" else row)  # fmt: skip
    row = next(row for row in path_costs.table(run).rows if row[0].text == "mmp")
    texts = [cell.text for cell in row]
    assert texts[5:8] == ["", "", ""] and texts[8] != "0" and texts[9] != "0"
    assert any("leave the surface and" in sentence and sentence.endswith(" fail.") for sentence in path_costs.sentences(run))


def test_the_figure_shows_lengths_of_solvers_only_whose_paths_are_longer(golden_run: Run) -> None:
    _, lengths = path_costs.figure(with_paths(golden_run)).figure.axes
    assert [tick.get_text() for tick in lengths.get_yticklabels()] == ["dijkstra"]
    exact = changed_rows(golden_run, lambda row: row | {"paths": PATHS} if row["outcome"] == "ok" else row)
    assert len(path_costs.figure(exact).figure.axes) == 1


def test_without_an_exact_solver_there_is_nothing_to_compare_with(golden_run: Run) -> None:
    run = changed_rows(golden_run, lambda row: row | {"paths": LONGER} if row["solver"] == "dijkstra" else row)
    with pytest.raises(ResultError, match="no exact solver has paths"):
        path_costs.table(run)
    with pytest.raises(ResultError, match="run --path-targets"):
        path_costs.table(golden_run)
