"""Columns contain the same rows as JSON. Errors name damaged columns. Runs of many meshes are drawn."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from plots import catalogue, dots
from plots.ratios import over_each_mesh
from results import merge, outcomes
from results.columns import Columns
from results.reader import ResultError, Run, read_run, run_of
from results.table import Table

Change = Callable[[dict[str, Any]], object]


@pytest.fixture
def stored(golden_folder: Path, tmp_path: Path) -> Path:
    """The golden run with its rows as columns. The names of its rows are those of geodesic-bench."""
    data = json.loads((golden_folder / "run.json").read_text())
    return merge.write(data["context"], Columns.of(data["benchmarks"]), tmp_path, 0).parent


def test_a_run_in_columns_is_the_run_in_json(stored: Path, golden_run: Run) -> None:
    run = read_run(stored)
    assert golden_run.columns.whole
    assert [row.data for row in run.rows] == [row.data for row in golden_run.rows]
    assert list(run.rows) == list(golden_run.rows)
    for mesh in golden_run.meshes:
        for solver in golden_run.solvers:
            assert run.cell(mesh, solver) == golden_run.cell(mesh, solver)
    drawn, left_out = catalogue.draw(run, list(catalogue.TABLES))
    expected, others = catalogue.draw(golden_run, list(catalogue.TABLES))
    assert drawn == expected and left_out.keys() == others.keys()
    assert outcomes.failures(run) == outcomes.failures(golden_run)
    assert outcomes.largest_errors(run) == outcomes.largest_errors(golden_run)


def test_a_text_inside_an_object_is_read_and_checked(golden_folder: Path) -> None:
    data = json.loads((golden_folder / "run.json").read_text())
    errors = {"mean": 0.1, "max": 0.2, "pair_mean": 0.1, "pair_max": 0.2, "reference": "mmp"}
    row = next(row for row in data["benchmarks"] if row["outcome"] == "ok")
    row |= {"further": {"sources": 2, "time": 1.0, "pair_time": 1.0}, "further_errors": errors}
    run = run_of(Path("run.json"), data)
    assert {"further_errors": errors}.items() <= next(one for one in run.rows if one.number("further.sources")).data.items()
    row["further_errors"]["reference"] = "two\nlines"
    with pytest.raises(ResultError, match="reference"):
        run_of(Path("run.json"), data)


def arrays(change: Change) -> Callable[[Path], None]:
    def apply(folder: Path) -> None:
        with np.load(folder / "rows.npz") as file:
            found = {key: file[key] for key in file.files}
        change(found)
        np.savez(folder / "rows.npz", **found)

    return apply


def negative(found: dict[str, Any]) -> None:
    found["real_time"][3] = -1.0


def far(found: dict[str, Any]) -> None:
    found["mesh"][0] = 99


def truncated(folder: Path) -> None:
    file = folder / "rows.npz"
    file.write_bytes(file.read_bytes()[:-100])


@pytest.mark.parametrize(
    ("damage", "words"),
    [
        (truncated, "not arrays of numpy"),
        (lambda folder: (folder / "rows.npz").unlink(), "no such file; run.json has its rows there"),
        (arrays(lambda a: a.update(windows=a["source"])), "windows: no column of a result file"),
        (arrays(lambda a: a.update(source=a["source"][1:])), "source: not"),
        (arrays(lambda a: a.update(source=a["source"].astype("f8"))), "source: not"),
        (arrays(lambda a: a.update(outcome=np.array([{}], object))), "not arrays of numpy"),
        (arrays(far), "mesh: a text that run.json does not have"),
        (arrays(negative), "has rows that are not to the schema"),
        (arrays(lambda a: a.pop("cpu_time")), "has rows that are not to the schema"),
    ],
)  # fmt: skip
def test_damaged_columns_are_named(
    stored: Path, damage: Callable[[Path], object], words: str
) -> None:
    damage(stored)
    with pytest.raises(ResultError, match="rows.npz") as caught:
        read_run(stored)
    assert words in str(caught.value) and "\n" not in str(caught.value)


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
