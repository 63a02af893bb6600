"""The check of a contributed result. Each error is a line. A valid result passes."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from gate import check_result
from results import checksum, merge
from results.columns import Columns
from results.reader import Cell, read_run

ROOT = Path(__file__).resolve().parents[2]
GOLDEN = ROOT / "tests" / "plots" / "golden" / "run" / "run.json"
Data = dict[str, Any]


def write(file: Path, data: Data) -> Path:
    """Writes the data with the correct checksum."""
    data["context"]["geodesic_bench"]["checksum"] = checksum.computed(json.dumps(data))
    file.write_text(json.dumps(data, indent=1))
    return file


@pytest.fixture
def result() -> Data:
    """A result that passes."""
    data: Data = json.loads(GOLDEN.read_text())
    data["benchmarks"] = [row for row in data["benchmarks"] if row["mesh"] == "horse"]
    ours(data)["meshes"] = [mesh for mesh in ours(data)["meshes"] if mesh["name"] == "horse"]
    ours(data)["sources"] = {"horse": ours(data)["sources"]["horse"]}
    ours(data)["skipped"] = [one for one in ours(data)["skipped"] if one["mesh"] == "horse"]
    manifest = json.loads((ROOT / "datasets" / "manifest.json").read_text())
    sums = {mesh["name"]: mesh["sha256"] for mesh in manifest["meshes"]}
    for mesh in data["context"]["geodesic_bench"]["meshes"]:
        mesh["sha256"] = sums[mesh["name"]]
    for row in rows_of(data, "dijkstra"):
        row |= {"reference": "mmp", "max_relative_error": 0.1}
    return data


def rows_of(data: Data, solver: str) -> list[Data]:
    found = [row for row in data["benchmarks"] if row["solver"] == solver and row["outcome"] == "ok"]
    assert found
    return found


Check = Callable[[Path], tuple[int, str]]


@pytest.fixture
def check(capsys: pytest.CaptureFixture[str]) -> Check:
    """check(FILE) returns the exit code and the output."""
    return lambda file: (check_result.main([str(file)]), capsys.readouterr().out)


def test_a_result_that_was_written_by_the_program_passes(result: Data, tmp_path: Path, check: Check) -> None:
    code, said = check(write(tmp_path / "run.json", result))
    assert code == 0 and "cells: " in said and "0123456789, Some processor, 2026-01-02" in said


def test_every_contributed_result_passes() -> None:
    files = sorted((ROOT / "results" / "contributed").glob("*.json.gz"))
    assert not files or check_result.main([str(file) for file in files]) == 0


def ours(data: Data) -> Data:
    found: Data = data["context"]["geodesic_bench"]
    return found


def another_mesh(data: Data) -> None:
    ours(data)["meshes"][0]["sha256"] = "1" * 64


def without_a_row(data: Data) -> None:
    gone = data["benchmarks"][0]["name"]
    data["benchmarks"] = [row for row in data["benchmarks"] if row["name"] != gone]


def unverified(data: Data) -> None:
    del rows_of(data, "mmp")[0]["reference"]


def faster_than_light(data: Data) -> None:
    for row in rows_of(data, "edge-based"):
        row["cpu_time"] = row["real_time"] = 1e-6


def uneven(data: Data) -> None:
    rows_of(data, "mmp")[0]["window_propagations"] += 1


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda data: ours(data).update(modified=True), "the sources were modified"),
        (lambda data: ours(data).update(revision="unknown"), "the revision is unknown"),
        (lambda data: ours(data).update(build_type="Debug"), "the build type is Debug, not Release"),
        (lambda data: ours(data).update(processor="unknown"), "the processor is unknown"),
        (another_mesh, "horse: is another file than the mesh of that name"),
        (without_a_row, "missing: the run has no row for this cell"),
        (unverified, "mmp/horse/src:0, repetition 0: has a time and no verified distances"),
        (lambda data: rows_of(data, "mmp")[0].update(max_relative_error=1e-6),
         "an error of 1e-06 of an exact solver"),
        (lambda data: rows_of(data, "ich")[0].update(unreachable_mismatches=3),
         "reaches other vertices than its reference"),
        (lambda data: rows_of(data, "ich")[0].update(cpu_time=1e9), "ms of the processor within"),
        (faster_than_light, "ns for the propagation of a window"),
        (uneven, "mmp/horse/src:0: counters differ between repetitions"),
        (lambda data: data.pop("benchmarks"), "'benchmarks' is a required property"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_a_line_and_an_exit_code(
    result: Data, tmp_path: Path, check: Check, change: Callable[[Data], None], said: str
) -> None:
    change(result)
    file = write(tmp_path / "theirs.json", result)
    code, lines = check(file)
    assert code == 1
    assert any(line.startswith(f"FAILED: {file}: ") and said in line for line in lines.splitlines()), lines


def test_a_number_that_was_changed_afterwards_is_found(result: Data, tmp_path: Path, check: Check) -> None:
    file = write(tmp_path / "run.json", result)
    time = rows_of(result, "edge-based")[0]["cpu_time"]
    text = file.read_text()
    assert text.count(str(time)) >= 1
    file.write_text(text.replace(str(time), str(time * 0.9), 1))
    code, said = check(file)
    assert code == 1 and "the checksum is another one" in said


def test_a_row_of_columns_that_was_changed_afterwards_is_found(
    result: Data, tmp_path: Path, check: Check
) -> None:
    file = merge.write(result["context"], Columns.of(result["benchmarks"]), tmp_path, 0)
    assert check(file)[0] == 0
    run = read_run(file)
    run.columns.arrays["real_time"] *= 1.0625
    run.columns.without("processor", run.ours["processor"]).save(tmp_path / "rows.npz")
    code, said = check(file)
    assert code == 1 and "rows.npz has another checksum, or none" in said


def test_counters_far_from_those_of_this_revision_are_found(
    result: Data, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, check: Check
) -> None:
    row = rows_of(result, "mmp")[0]
    cell = Cell("mmp", row["mesh"], row["source"])
    known = {cell: {"window_propagations": 3 * row["window_propagations"]}}
    monkeypatch.setattr("gate.baseline.read", lambda _: known)
    for day, found in (("2026-01-01", 1), (result["context"]["geodesic_bench"]["started"][:10], 0)):
        monkeypatch.setattr("gate.baseline.changed", lambda _, day=day: {"mmp": day})
        code, said = check(write(tmp_path / "run.json", result))
        assert code == found and ("; this revision counts " in said) == bool(found)
