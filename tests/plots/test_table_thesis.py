"""The comparison with the thesis: means of the models that have both numbers, separately for stand-ins."""

from __future__ import annotations

import pytest
from synthetic import changed_rows, of_solvers

from plots import table_thesis
from plots.models import of_thesis
from results.reader import ResultError, Run


def texts(run: Run) -> dict[tuple[str, str], list[str]]:
    """Returns the texts from the time column on, by group and solver."""
    rows = table_thesis.table(run).rows
    return {(str(row[0].value), row[1].text): [cell.text for cell in row[2:]] for row in rows}


def change_numbers(run: Run, solver: str, key: str, factor: float) -> Run:
    return changed_rows(
        run,
        lambda row: row | {key: type(row[key])(row[key] * factor)}
        if row["solver"] == solver and key in row
        else row,
    )


def test_another_order_and_a_far_count_are_shown(golden_run: Run) -> None:
    slow = texts(change_numbers(golden_run, "fwp-mmp", "cpu_time", 10))
    places = {solver: row[2:4] for (group, solver), row in slow.items() if group != "stand-ins"}
    assert places["fwp-mmp"] == ["5", "2"] and places["edge-based"] == ["1", "1"]
    many = texts(change_numbers(golden_run, "ich", "window_propagations", 1.2))
    assert many["the thesis's models", "ich"][-1] == "+18.0%"


def test_means_are_over_models_that_have_both_numbers(golden_run: Run) -> None:
    run = changed_rows(
        golden_run, lambda row: None if (row["solver"], row["mesh"]) == ("ich", "rocker-arm") else row
    )
    pairs = table_thesis.compare(run, of_thesis(run), table_thesis.SPEED)
    assert (pairs["ich"].models, pairs["mmp"].models) == (1, 2)
    assert pairs["ich"].thesis == pytest.approx(5.14, abs=0.01)


def test_without_edge_based_there_are_windows_only_and_without_both_nothing(
    golden_run: Run,
) -> None:
    table = table_thesis.table(of_solvers(golden_run, "mmp", "ich"))
    assert [name for name in table.header if "Time" in name] == []
    assert len(table.rows) == 4
    with pytest.raises(ResultError, match="no verified cell that the thesis has a number for"):
        table_thesis.table(of_solvers(golden_run, "dijkstra"))


def test_a_run_without_the_thesis_s_models_has_none(golden_run: Run) -> None:
    with pytest.raises(ResultError, match="no mesh is or stands for a model of the thesis"):
        table_thesis.table(golden_run.of_meshes(["flat-grid"]))
