"""The list of planted faults (tools/planted_faults.toml) can be used. Nothing is planted."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "tools" / "planted_faults.py"

Ended = subprocess.CompletedProcess[str]
SOUND: dict[str, object] = {
    "name": "a fault",
    "file": "tools/planted_faults.py",
    "old": "LONGEST = 1200",
    "new": "LONGEST = 12",
    "found_by": ["pytest tests/scripts/test_planted_faults.py"],
}


def check(*words: str | Path) -> Ended:
    return subprocess.run([sys.executable, SCRIPT, "--check", *words], capture_output=True, text=True)


def test_every_fault_of_the_list_can_be_planted_and_its_tests_are_there() -> None:
    assert check().stderr == ""


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({}, ""),
        ({"old": "no such text"}, "a fault: its text occurs 0 times in tools/planted_faults.py, not once"),
        ({"old": "LONGEST"}, "a fault: its text occurs 3 times in tools/planted_faults.py, not once"),
        ({"new": SOUND["old"]}, "a fault: it changes nothing, or no test is named"),
        ({"new": "LONGEST = ("}, "a fault: not Python any more"),
        ({"file": "tools/none.py"}, "a fault: there is no file tools/none.py"),
        ({"found_by": ["ctest no_tests"]}, "a fault: there is no test 'ctest no_tests'"),
        ({"found_by": ["pytest tests/none.py"]}, "a fault: there is no test 'pytest tests/none.py'"),
        ({"found_by": ["verify nobody"]}, "a fault: there is no test 'verify nobody'"),
    ],
)
def test_a_fault_that_cannot_be_planted_is_named(change: dict[str, object], says: str, tmp_path: Path) -> None:
    faults = tmp_path / "faults.toml"
    entries = (f"{key} = {value!r}" for key, value in {**SOUND, **change}.items())
    faults.write_text("\n".join(["[[fault]]", *entries]))
    ended = check("--faults", faults)
    assert ended.returncode == (1 if says else 0)
    assert ended.stderr.startswith(f"planted_faults.py: {says}" if says else "")
    assert ended.stderr.count("\n") == bool(says)


def test_a_fault_that_is_not_in_the_list_is_named() -> None:
    ended = check("no such fault")
    assert ended.returncode == 1
    assert ended.stderr.startswith("planted_faults.py: no fault named 'no such fault'")
