"""A solver with parameters, `avtp?lambda=32&threads=2`, keeps its name in all figures and tables of a run.
Several threads are timed by real time, and wrong answers show their errors."""

from __future__ import annotations

import csv
import json
import re
from typing import Any

import pytest
from synthetic import Changed

from plots.catalogue import draw
from plots.measures import ERROR, TIME, our_field
from plots.style import solver_styles
from results.reader import SCHEMA, Run, read_run
from results.table import FORMATS, Table

NAME = "avtp?lambda=32&threads=2"
IN_LATEX = r"avtp?lambda=32\&threads=2"


def with_parameters(data: dict[str, Any]) -> None:
    """Changes dijkstra of the golden run into a bounded solver with two threads."""
    solvers = data["context"]["geodesic_bench"]["solvers"]
    dijkstra = next(solver for solver in solvers if solver["name"] == "dijkstra")
    dijkstra |= {"name": NAME, "exactness": "bounded", "error_bound": 0.01, "threads": 2}
    for row in data["benchmarks"]:
        if row["solver"] == "dijkstra":
            name = row["name"].replace("dijkstra", NAME)
            row |= {"solver": NAME, "name": name, "run_name": name, "threads": 2}
            row["real_time"], row["cpu_time"] = 7.0, 14.0


@pytest.fixture
def run(changed: Changed) -> Run:
    return read_run(changed(with_parameters))


def test_the_name_is_in_every_table_of_all_solvers_in_every_format(run: Run) -> None:
    drawn, _ = draw(run)
    tables = {name: table for name, table in drawn.items() if isinstance(table, Table)}
    named = [table for table in tables.values() if NAME in FORMATS[".md"](table)]
    assert {"summary", "performance", "solvers"} <= {table.name for table in named}
    assert f"{NAME} (within 0.01)" in FORMATS[".md"](tables["summary"])
    for table in named:
        assert IN_LATEX in FORMATS[".tex"](table), table.name
        cells = [cell for line in csv.reader(FORMATS[".csv"](table).splitlines()) for cell in line]
        assert any(NAME in cell for cell in cells), table.name


def test_a_wrong_answer_has_no_time_and_shows_its_error(changed: Changed) -> None:
    def make_wrong(data: dict[str, Any]) -> None:
        for row in data["benchmarks"]:
            if row["solver"] == "mmp" and row["mesh"] == "horse":
                row |= {"outcome": "wrong answer", "error_occurred": True, "error_message": "wrong"}
                row["max_relative_error"] = 0.017

    run = read_run(changed(make_wrong))
    assert our_field(run, "horse", "mmp", TIME).text == "wrong answer"
    error = our_field(run, "horse", "mmp", ERROR)
    assert error.text == "1.7e-02" and "wrong" in error.note


def test_names_that_have_no_style_of_their_own_get_different_ones() -> None:
    names = [f"avtp?lambda={number}" for number in range(16)]
    styles = solver_styles(["mmp", *names])
    assert len({(one.color, one.marker) for one in styles.values()}) == len(names) + 1
    assert len({one.color.lower() for one in styles.values()}) == len(names) + 1


def test_settings_of_one_solver_leave_the_others_their_styles() -> None:
    few, many = (solver_styles([*(f"avtp?lambda={n}" for n in range(count)), "heat"])
                 for count in (1, 5))  # fmt: skip
    assert few.items() <= many.items()


def test_the_schema_takes_names_with_parameters_and_no_broken_ones() -> None:
    schema = json.loads(SCHEMA.read_text())
    pattern = re.compile(schema["$defs"]["solver_name"]["pattern"])
    for name in ("mmp", NAME, "steiner?points=1e-5", "heat?flags=authors"):
        assert pattern.search(name), name
    for name in ("avtp?", "avtp&a=1", "avtp?lambda", "avtp?a=1&", "../mmp", "a b", "avtp?a=1/2"):
        assert not pattern.search(name), name
