"""Exports have the shapes that other tools document, and Google Benchmark's own tool reads them."""

from __future__ import annotations

import csv
import io
import json
import statistics
import subprocess
from pathlib import Path
from typing import Any

import pytest

from gate import export

GOLDEN = Path(__file__).resolve().parents[1] / "plots" / "golden" / "run" / "run.json"
ROWS = json.loads(GOLDEN.read_text())["benchmarks"]
ACTION = "github-action-benchmark"
COMPARE = Path("/usr/share/benchmark/compare.py")
PYTHON = "/usr/bin/python3"
"""Debian's Python. It has the modules that Debian's compare.py imports."""


def cells(outcome: str | None = None) -> set[str]:
    return {row["run_name"] for row in ROWS if outcome is None or row["outcome"] == outcome}


def test_action_gets_the_numbers_of_the_run_in_the_documented_shape(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert export.main(["--to", ACTION, str(GOLDEN)]) == 0
    printed = capsys.readouterr()
    rows: list[dict[str, Any]] = json.loads(printed.out)
    for row in rows:
        assert row.keys() - {"range"} == {"name", "unit", "value"}
        assert row["name"] and isinstance(row["value"], int | float)
        assert all(isinstance(row[key], str) for key in row.keys() - {"value"})
    custom = {row["name"]: row for row in rows}
    like = next(row for row in ROWS if row["outcome"] == "ok" and "window_propagations" in row)
    name = like["run_name"]
    times = [row["cpu_time"] for row in ROWS if row["run_name"] == name]
    assert custom[f"{name} cpu_time"]["value"] == statistics.median(times)
    assert custom[f"{name} window_propagations"]["value"] == like["window_propagations"]
    assert custom[f"{name} window_propagations"]["unit"] == "windows"

    failed = len(cells()) - len(cells("ok"))
    assert failed > 0
    assert f"{failed} of {len(cells())} cells failed and have no numbers" in printed.err
    assert {name.rsplit(" ", 1)[0] for name in custom} == cells("ok")


def test_csv_has_a_line_a_repetition_and_keeps_failed_cells(capsys: pytest.CaptureFixture[str]) -> None:
    assert export.main(["--to", "csv", str(GOLDEN)]) == 0
    lines = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    assert [line["outcome"] for line in lines] == [row["outcome"] for row in ROWS]
    assert [line["error_message"] for line in lines] == [r.get("error_message", "") for r in ROWS]


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


def test_the_program_exports_and_compares_and_exits_by_what_it_finds(bench: Path, tmp_path: Path) -> None:
    data = json.loads(GOLDEN.read_text())
    for row in data["benchmarks"]:
        if "window_propagations" in row:
            row["window_propagations"] *= 2
        if row["outcome"] == "wrong answer":
            row["outcome"] = "crashed"
    new = tmp_path / "run.json"
    new.write_text(json.dumps(data))

    def call(*words: object) -> subprocess.CompletedProcess[str]:
        return subprocess.run([bench, *map(str, words)], capture_output=True, text=True)

    assert call("export", "--to", "csv", GOLDEN).stdout.count("\n") == 1 + len(ROWS)
    assert call("compare", GOLDEN, tmp_path).returncode == 0
    ended = call("compare", GOLDEN, new, "--fail-on", "counters=1%,memory=2%", "--format", "json")
    assert ended.returncode == 3
    assert "window_propagations" in json.loads(ended.stdout)["failures"][0]
    ended = call("compare", GOLDEN, new, "--fail-on", "speed=1%")
    assert ended.returncode == 1 and "no kind of limit named 'speed'" in ended.stderr
