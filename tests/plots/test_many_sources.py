"""Sets of sources: in columns, in a run, and drawn."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import synthetic
from synthetic import mesh, solver

from plots import catalogue, many_sources
from results.columns import Columns
from results.pairs import all_times, paired, ratios
from results.reader import Cell, ResultError, Run, Source

SIZES = {"random:8": 8, "random:64": 64, "boundary": 40}
SOLVERS = {"e": "exact", "heat": "unbounded"}
SEVERAL: list[Source] = [0, *SIZES]


def row(solver: str, mesh: str, source: Source, time: float, error: float) -> dict[str, Any]:
    name = f"{solver}/{mesh}/src:{source}"
    return {"name": name, "run_name": name, "run_type": "iteration", "time_unit": "ms",
            "solver": solver, "mesh": mesh, "source": source, "outcome": "ok", "processor": "P",
            "cpu_time": time, "real_time": time, "threads": 1, "repetition_index": 0,
            "max_relative_error": 2 * error, "mean_relative_error": error}  # fmt: skip


def run_of(sources: Sequence[Source], folder: Path = Path()) -> Run:
    """Returns a run on mesh m. `e` takes 1, 2, 3, ... ms from the sources in order, `heat` half of that."""
    rows = [
        row(name, "m", source, (i + 1) / (1 if name == "e" else 2), 0 if name == "e" else 0.1)
        for i, source in enumerate(sources)
        for name in SOLVERS
    ]
    sets = {s: {"vertices": n, "file": f"sources/{s}.json"} for s, n in SIZES.items() if s in sources}
    context = {"source_sets": {"m": sets}} if sets else {}
    run = synthetic.run_of([solver(*each) for each in SOLVERS.items()], [mesh("m")], rows, **context)
    return replace(run, file=folder / "run.json")


def test_columns_keep_vertices_and_sets_apart() -> None:
    sources: list[Source] = [7, "boundary", 0, "random:8", "boundary"]
    rows = [row("e", "m", source, 1, 0) for source in sources]
    columns = Columns.of(rows)
    assert [columns.source(i) for i in range(5)] == sources
    assert columns.cells(columns.has("solver")) == 4
    assert [columns.data(i) for i in range(5)] == rows
    again = Columns.together([columns.take(np.array([3, 2])), columns])
    assert [again.source(i) for i in range(4)] == ["random:8", 0, 7, "boundary"]


@pytest.mark.parametrize("source", [-1, 1.5, True, None, ["random:8"]])
def test_a_source_is_a_vertex_or_a_name(source: Any) -> None:
    with pytest.raises((ValueError, TypeError)):
        Columns.of([row("e", "m", "random:8", 1, 0), row("e", "m", source, 1, 0)])


def test_columns_are_stored_with_their_sets(tmp_path: Path) -> None:
    columns = Columns.of([row("e", "m", 7, 1, 0), row("e", "m", "boundary", 1, 0)])
    columns.save(tmp_path / "rows.npz")
    assert Columns.load(tmp_path / "rows.npz", 2, columns.texts).source(1) == "boundary"
    with pytest.raises(ResultError, match="a set that run.json does not have"):
        Columns.load(tmp_path / "rows.npz", 2, columns.texts | {"source": []})


def test_cells_are_in_order_with_sets_last() -> None:
    sources: list[Source] = ["random:8", 10, "boundary", 9]
    cells = sorted(Cell("e", "m", source) for source in sources)
    assert [cell.source for cell in cells] == [9, 10, "boundary", "random:8"]


def test_a_run_knows_the_vertices_of_a_set(tmp_path: Path) -> None:
    run = run_of(SEVERAL, tmp_path)
    assert [run.set_size("m", source) for source in SEVERAL] == [1, 8, 64, 40]
    (tmp_path / "sources").mkdir()
    (tmp_path / "sources" / "boundary.json").write_text(json.dumps([3, 1, 4]), encoding="utf-8")
    assert run.source_vertices("m", "boundary") == [3, 1, 4]
    assert run.source_vertices("m", 5) == [5]
    with pytest.raises(ResultError, match="no such file"):
        run.source_vertices("m", "random:8")


def test_other_figures_show_single_vertices_where_there_are_any() -> None:
    assert run_of(SEVERAL).of_single_sources.sources == {"m": [0]}
    assert len(all_times(run_of(SEVERAL).of_single_sources).seconds) == 1
    only_sets = run_of(list(SIZES))
    assert only_sets.of_single_sources is only_sets
    assert len(all_times(only_sets).seconds) == 3


def test_ratios_are_in_the_order_of_the_run() -> None:
    assert ratios(run_of(SEVERAL), "m", "heat", "e") == [[0.5], [0.5], [0.5], [0.5]]
    above = {(source, 0): float(i + 1) for i, source in enumerate(SEVERAL)}
    assert paired(above, dict.fromkeys(reversed(above), 1.0)) == [[1.0], [2.0], [3.0], [4.0]]


def test_a_time_of_zero_has_no_ratio() -> None:
    assert paired({(0, 0): 0.0, (0, 1): 3.0, (1, 0): 4.0}, {(0, 0): 1.0, (0, 1): 0.0, (1, 0): 2.0}) == [[2.0]]


def test_the_figure_shows_times_over_the_base_from_one_source() -> None:
    points = many_sources.points(run_of(SEVERAL), "heat", "e")
    assert [point.sources for point in points] == [1, 8, 64]
    assert [point.time.value for point in points] == pytest.approx([0.5, 1, 1.5])
    assert {point.mean for point in points} == {0.1} and {point.largest for point in points} == {0.2}
    drawing = many_sources.figure(run_of(SEVERAL))
    times, means, _ = drawing.figure.axes
    assert len(times.collections) == 2 and not means.collections  # the intervals of times
    assert len(times.lines) == 2 and len(means.lines) == 1  # the exact one has no error


def test_a_number_of_sources_without_an_answer_is_left_out() -> None:
    run = run_of(SEVERAL)
    there = ~((run.columns.arrays["source"] == run.columns.arrays["source"][3]) & run.columns.where("solver", "heat"))
    some = replace(run, columns=run.columns.take(there))
    assert [p.sources for p in many_sources.points(some, "heat", "e")] == [1, 64]


def test_the_table_has_every_set_over_the_base_from_the_same_sources() -> None:
    table = many_sources.table(run_of(SEVERAL))
    texts = [[cell.text for cell in cells] for cells in table.rows]
    assert ["m", "boundary", "40", "heat", "0.500 [0.500, 0.500]", "2.0e-01", "1.0e-01"] in texts
    assert len(texts) == 8


def test_mean_errors_are_of_solvers_that_are_not_exact_by_the_number_of_sources() -> None:
    table = many_sources.errors(run_of(SEVERAL))
    assert table.header == ["Sources", "heat"]
    assert [[cell.text for cell in row] for row in table.rows] == [["1", "10%"], ["8", "10%"], ["64", "10%"]]


def test_without_sets_the_reason_names_the_option() -> None:
    _, why = catalogue.draw(run_of([0, 1]), ["many_sources"])
    assert "--source-sets" in why["many_sources"]
    one = run_of([0, "boundary"])
    with pytest.raises(ResultError, match="no two numbers of sources"):
        many_sources.figure(one)
