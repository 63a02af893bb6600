"""Columns contain the same rows as JSON. Errors name damaged columns."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from results import outcomes
from results.reader import ResultError, Run, read_run, run_of

Change = Callable[[dict[str, Any]], object]


def test_a_run_in_columns_is_the_run_in_json(stored: Path, golden_run: Run) -> None:
    run = read_run(stored)
    assert golden_run.columns.whole
    assert [row.data for row in run.rows] == [row.data for row in golden_run.rows]
    assert list(run.rows) == list(golden_run.rows)
    for mesh in golden_run.meshes:
        for solver in golden_run.solvers:
            assert run.cell(mesh, solver) == golden_run.cell(mesh, solver)
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
