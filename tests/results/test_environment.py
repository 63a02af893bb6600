"""The differences of the environments of runs."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest
from results import environment
from results.reader import Run, run_of

GOLDEN = Path(__file__).resolve().parents[1] / "plots" / "golden" / "run" / "run.json"
HERE = {
    "started": "2026-01-02T03:04:05Z", "processor": "Abacus", "microcode": "0x1", "kernel": "Linux 6.1",
    "libraries": "benchmark 1.7.1, glibc 2.36", "cores": "0-1", "load": 0.1,
}  # fmt: skip


def run_in(*environments: dict[str, Any], **ours: Any) -> Run:
    data = copy.deepcopy(json.loads(GOLDEN.read_text("utf-8")))
    data["context"]["geodesic_bench"] |= ours
    if environments:
        data["context"]["geodesic_bench"]["environments"] = list(environments)
    return run_of(Path("run.json"), data)


def test_one_line_says_that_environments_agree() -> None:
    (line,) = environment.differences_of_runs(run_in(HERE), run_in(HERE | {"load": 0.4}))
    assert line == (
        "the environments agree: processor, microcode, kernel, governor, libraries, cores, limit of cores,"
        " compiler, compiler flags, build type, load 0.1, threads"
    )


@pytest.mark.parametrize(
    ("change", "line"),
    [
        ({"microcode": "0x2"}, "different microcode: 0x1 (base) / 0x2 (head)"),
        ({"kernel": "Linux 6.12"}, "different kernel: Linux 6.1 (base) / Linux 6.12 (head)"),
        ({"governor": "powersave"}, "different governor: none (base) / powersave (head)"),
        ({"libraries": "glibc 2.41"}, "different libraries: benchmark 1.7.1, glibc 2.36 (base) / glibc 2.41 (head)"),
        ({"cores": "1"}, "different cores: 0-1 (base) / 1 (head)"),
        ({"core_limit": 1.5}, "different limit of cores: none (base) / 1.5 (head)"),
        ({"load": 2.25}, "different load: 0.1 (base) / 2.2 (head)"),
    ],
)
def test_each_difference_of_the_machine_is_a_line(change: dict[str, Any], line: str) -> None:
    assert environment.differences_of_runs(run_in(HERE), run_in(HERE | change)) == [line]


def test_differences_of_processors_builds_and_threads_are_lines() -> None:
    other = run_in(HERE, processor="Babbage", compiler="Clang 19")
    other.ours["solvers"][0]["threads"] = 2
    found = environment.differences_of_runs(run_in(HERE), other)
    assert [line.split(":")[0] for line in found] == [
        "different processor", "different compiler", "different threads"
    ]  # fmt: skip


def test_what_an_older_file_does_not_say_is_named_and_is_no_difference() -> None:
    assert environment.differences_of_runs(run_in(), run_in(HERE)) == [
        "only one of the two says its microcode, kernel, governor, libraries, cores, limit of cores, load"
    ]


def test_environments_of_one_run_are_compared_with_the_first() -> None:
    later = HERE | {"started": "2026-01-02T04:04:05Z", "load": 3.0}
    other = HERE | {"kernel": "Linux 6.12"}
    assert environment.within(run_in(HERE, later)) == []
    assert environment.within(run_in(HERE, later, other, HERE)) == ["different kernel: Linux 6.1 / Linux 6.12"]
    assert environment.distinct([HERE, later, other, HERE]) == [HERE, other]
    assert environment.load(run_in(HERE, later)) == 3.0
