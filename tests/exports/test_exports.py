"""Exports have the shapes that other tools document, and Google Benchmark's own tool reads them."""

from __future__ import annotations

import csv
import io
import json
import os
import statistics
import subprocess
from pathlib import Path

import jsonschema
import pytest

ROOT = Path(__file__).resolve().parents[2]
GOLDEN = ROOT / "tests" / "plots" / "golden" / "run" / "run.json"
ACTION = "github-action-benchmark"
COMPARE = Path("/usr/share/benchmark/compare.py")
PYTHON = "/usr/bin/python3"
"""Debian's, which has what its compare.py imports."""

NUMBER = {"type": "number"}
CUSTOM_SMALLER_IS_BETTER = {
    "type": "array",
    "minItems": 1,
    "items": {
        "type": "object",
        "required": ["name", "unit", "value"],
        "additionalProperties": False,
        "properties": {
            "name": {"type": "string", "minLength": 1},
            "unit": {"type": "string"},
            "value": NUMBER,
            "range": {"type": "string"},
            "extra": {"type": "string"},
        },
    },
}
@pytest.fixture
def bench() -> str:
    program = os.environ.get("GEODESIC_BENCH")
    if program is None:
        pytest.skip("GEODESIC_BENCH names no program; ./run_tests.sh sets it")
    return program


def export(bench: str, to: str, file: Path = GOLDEN) -> str:
    ended = subprocess.run(
        [bench, "export", "--to", to, str(file)], capture_output=True, text=True, check=True
    )
    return ended.stdout


def cells(outcome: str | None = None) -> set[str]:
    rows = json.loads(GOLDEN.read_text())["benchmarks"]
    return {r["run_name"] for r in rows if outcome is None or r["outcome"] == outcome}


def test_shape_is_the_documented_one(bench: str) -> None:
    jsonschema.validate(json.loads(export(bench, ACTION)), CUSTOM_SMALLER_IS_BETTER)


def test_numbers_are_those_of_the_run(bench: str) -> None:
    rows = [
        row
        for row in json.loads(GOLDEN.read_text())["benchmarks"]
        if row["outcome"] == "ok" and "window_propagations" in row
    ]
    name, counted = rows[0]["run_name"], rows[0]["window_propagations"]
    times = sorted(row["cpu_time"] for row in rows if row["run_name"] == name)
    custom = {row["name"]: row for row in json.loads(export(bench, ACTION))}
    assert custom[f"{name} cpu_time"]["value"] == statistics.median(times)
    assert custom[f"{name} window_propagations"]["value"] == counted
    assert custom[f"{name} window_propagations"]["unit"] == "windows"


def test_csv_has_a_line_a_repetition_and_keeps_failed_cells(bench: str) -> None:
    lines = list(csv.DictReader(io.StringIO(export(bench, "csv"))))
    rows = json.loads(GOLDEN.read_text())["benchmarks"]
    assert [line["outcome"] for line in lines] == [row["outcome"] for row in rows]
    assert [line["error_message"] for line in lines] == [r.get("error_message", "") for r in rows]


def test_failed_cells_are_counted_where_they_cannot_be_shown(bench: str) -> None:
    failed = len(cells()) - len(cells("ok"))
    assert failed > 0
    ended = subprocess.run(
        [bench, "export", "--to", ACTION, str(GOLDEN)], capture_output=True, text=True
    )
    assert f"{failed} of {len(cells())} cells failed and have no numbers" in ended.stderr
    assert {row["name"].rsplit(" ", 1)[0] for row in json.loads(ended.stdout)} == cells("ok")


@pytest.mark.skipif(not COMPARE.exists(), reason="libbenchmark-tools is not installed")
def test_google_benchmarks_own_tool_compares_two_of_our_files(tmp_path: Path) -> None:
    files = []
    for factor in (1, 2):
        data = json.loads(GOLDEN.read_text())
        data["benchmarks"] = [row for row in data["benchmarks"] if row["outcome"] == "ok"]
        for row in data["benchmarks"]:
            row["real_time"] *= factor
            row["cpu_time"] *= factor
        files.append(tmp_path / f"{factor}.json")
        files[-1].write_text(json.dumps(data))
    ended = subprocess.run(
        [PYTHON, str(COMPARE), "--no-color", "benchmarks", *map(str, files)],
        capture_output=True, text=True,
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    name = sorted(cells("ok"))[0]
    line = next(line for line in ended.stdout.splitlines() if line.startswith(name))
    assert line.split()[1:3] == ["+1.0000", "+1.0000"]


def test_command_compares_runs_and_exits_by_what_it_finds(bench: str, tmp_path: Path) -> None:
    data = json.loads(GOLDEN.read_text())
    for row in data["benchmarks"]:
        if "window_propagations" in row:
            row["window_propagations"] *= 2
        if row["outcome"] == "wrong answer":
            row["outcome"] = "crashed"
    new = tmp_path / "run.json"
    new.write_text(json.dumps(data))

    def compare(*words: str) -> subprocess.CompletedProcess[str]:
        command = [bench, "compare", str(GOLDEN), *words]
        return subprocess.run(command, capture_output=True, text=True)

    assert compare(str(tmp_path)).returncode == 0
    ended = compare(str(new), "--fail-on", "counters=1%,memory=2%", "--format", "json")
    assert ended.returncode == 3
    assert "window_propagations" in json.loads(ended.stdout)["failures"][0]
    ended = compare(str(new), "--fail-on", "speed=1%")
    assert ended.returncode == 1 and "no kind of limit named 'speed'" in ended.stderr
