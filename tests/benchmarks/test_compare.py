"""The comparison of two builds' micro-benchmarks takes least times, and says what it cannot do."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

COMPARE = Path(__file__).resolve().parent.parent.parent / "tests" / "benchmarks" / "compare.py"


def write(folder: Path, name: str, times: dict[str, list[float]]) -> str:
    rows = [
        {"run_name": benchmark, "run_type": "iteration", "cpu_time": time, "time_unit": "us"}
        for benchmark, repetitions in times.items()
        for time in repetitions
    ]
    rows.append({"run_name": "a", "run_type": "aggregate", "cpu_time": 0.001, "time_unit": "us"})
    file = folder / name
    file.write_text(json.dumps({"context": {}, "benchmarks": rows}))
    return str(file)


def compare(before: list[str], after: list[str]) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(COMPARE), *before, "--with", *after]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_ratio_is_of_least_times_over_all_turns_and_of_each_half(tmp_path: Path) -> None:
    before = [write(tmp_path, f"b{i}", {"a": [2, 9]}) for i in range(3)]
    before.append(write(tmp_path, "b3", {"a": [1, 5], "gone": [1]}))
    after = [write(tmp_path, f"a{i}", {"a": [7, 3]}) for i in range(4)]
    ended = compare(before, after)
    assert ended.returncode == 0, ended.stderr
    header, row = ended.stdout.splitlines()
    assert header.startswith("benchmark")
    assert row.split() == ["a", "1000.00", "3000.00", "3.000", "1.500", "3.000"]


def test_unequal_turns_and_broken_files_are_errors_of_one_line(tmp_path: Path) -> None:
    one = write(tmp_path, "one", {"a": [1]})
    broken = tmp_path / "broken"
    broken.write_text("{")
    for before, after in (([one], [one, one]), ([one], [str(broken)]), ([one], ["none"])):
        ended = compare(before, after)
        assert ended.returncode == 1 and ended.stdout == ""
        assert ended.stderr.startswith("compare.py: ") and ended.stderr.count("\n") == 1
