"""Runs of many meshes, in columns, of several processors and of several programs are drawn, or refused."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from synthetic import changed_rows

from plots import catalogue, dots
from plots.ratios import over_each_mesh
from results.reader import ResultError, Run, read_run, run_of
from results.table import Table


def crowd(golden_folder: Path, meshes: int) -> Run:
    """Returns the golden run with the horse under many names. On the n-th mesh, mmp takes n times as long."""
    data = json.loads((golden_folder / "run.json").read_text())
    ours = data["context"]["geodesic_bench"]
    [horse] = [mesh for mesh in ours["meshes"] if mesh["name"] == "horse"]
    rows = [row for row in data["benchmarks"] if row["mesh"] == "horse"]
    names = [f"horse-{number}" for number in range(1, meshes + 1)]
    ours["meshes"] = [horse | {"name": n, "vertices": 10 * i + 10} for i, n in enumerate(names)]
    ours["sources"] = {name: ours["sources"]["horse"] for name in names}
    ours["skipped"] = []
    data["benchmarks"] = [
        row | {"mesh": name, "cpu_time": row["cpu_time"] * (number if row["solver"] == "mmp" else 1)}
        for number, name in enumerate(names, 1)
        for row in rows
    ]  # fmt: skip
    return run_of(golden_folder, data)


def test_a_run_of_many_meshes_has_the_tables_and_figures_of_a_run_of_few(
    golden_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(dots, "MOST_ROWS", 6)
    drawn, left_out = catalogue.draw(crowd(golden_folder, 13))
    few, others = catalogue.draw(crowd(golden_folder, 4))
    assert drawn.keys() == few.keys() and left_out.keys() == others.keys()
    table, figure = drawn["summary_by_mesh"], drawn["speedup"]
    assert isinstance(table, Table) and len(table.rows) == 1 + 13
    assert not isinstance(figure, Table)
    labels = [label.get_text().split() for label in figure.figure.axes[0].get_yticklabels()]
    assert [words[0] for words in labels if words[0] != "geometric"] == [
        "horse-1", "horse-2", "horse-3", "7", "horse-11", "horse-12", "horse-13",
    ]  # fmt: skip


def test_ratios_over_each_mesh_are_those_of_its_pairs(golden_folder: Path) -> None:
    found = over_each_mesh(crowd(golden_folder, 9), "edge-based")["mmp"]
    one = crowd(golden_folder, 1)
    pairs = {
        (row.source, row.repetition): row.time for row in one.cell("horse-1", "edge-based") if row.ok
    }
    logs = [
        np.log(row.time / pairs[row.source, row.repetition])
        for row in one.cell("horse-1", "mmp")
        if (row.source, row.repetition) in pairs
    ]
    assert np.allclose(found, np.exp(np.mean(logs)) * np.arange(1, 10), rtol=1e-12)


def test_seconds_of_several_processors_are_refused_and_ratios_drawn(golden_folder: Path) -> None:
    run = crowd(golden_folder, 2)
    rows = [row.data | {"processor": "Abacus" if row.mesh == "horse-1" else "Babbage"} for row in run.rows]
    run = run_of(golden_folder, {"context": run.context, "benchmarks": rows})
    drawn, left_out = catalogue.draw(run, ["summary", "overview", "every_solver", "time_over_vertices"])
    assert list(drawn) == ["summary", "overview"]
    assert left_out == dict.fromkeys(["every_solver", "time_over_vertices"], (
        f"{run.file}: times in seconds of several processors, Abacus, Babbage: choose meshes of one with --meshes"
    ))  # fmt: skip
    of_one, _ = catalogue.draw(run.of_meshes(["horse-2"]), ["every_solver"])
    assert list(of_one) == ["every_solver"]


def test_tables_of_a_run_in_columns_are_those_of_the_run_in_json(stored: Path, golden_run: Run) -> None:
    drawn, left_out = catalogue.draw(read_run(stored), list(catalogue.TABLES))
    expected, others = catalogue.draw(golden_run, list(catalogue.TABLES))
    assert drawn == expected and left_out.keys() == others.keys()


def test_a_run_of_several_programs_is_refused(golden_run: Run) -> None:
    programs = iter(["base", "head"])
    run = changed_rows(golden_run, lambda row: row | {"program": next(programs, "head")})
    with pytest.raises(ResultError, match="several programs"):
        catalogue.draw(run)
