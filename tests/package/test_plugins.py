"""Plug-ins built against an installed copy: their solvers, and the reasons of refusals.
tests/bad_inputs/bad_plugins.py has files that are not plug-ins."""

from __future__ import annotations

import hashlib
import json
import re
import shlex
import shutil
from collections.abc import Callable
from pathlib import Path

import jsonschema
import pytest
from installed import ROOT, Installed

EXAMPLE = (ROOT / "examples" / "solver" / "my_solver.cpp").read_text()
TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
STRIP = (
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
    "f 1 2 5\nf 1 5 4\nf 2 3 5\nf 3 6 5\n"
)
"""A strip of two squares. A straight line across it crosses two edges."""
SOURCES = {
    "wrong": EXAMPLE.replace('"my-solver"', '"wrong"').replace("upper_bound", "exact"),
    "undefined": "namespace a { int missing(int); }\nint called = a::missing(1);\n",
    "other-contract": EXAMPLE,
    "other-sizes": EXAMPLE,
}
CHANGED_HEADERS = {
    "other-contract": ("contract.h", r"kContract = (\d+);", r"kContract = 1000 + \1;"),
    "other-sizes": ("query.h", r"struct QueryIn {", "struct QueryIn {\n  double added = 0;"),
}


def changed_headers(
    installed: Installed, folder: Path, name: str, pattern: str, replacement: str
) -> Path:
    shutil.copytree(installed.include, folder)
    header = folder / "solvers" / "core" / name
    text, count = re.subn(pattern, replacement, header.read_text())
    assert count == 1, f"{name} has no {pattern}"
    header.write_text(text)
    return folder


def build_plugins(installed: Installed, source: Path) -> None:
    lines = [
        "cmake_minimum_required(VERSION 3.25)",
        "project(Plugins LANGUAGES CXX)",
        "find_package(GeodesicBench REQUIRED)",
    ]
    for name, text in SOURCES.items():
        (source / f"{name}.cpp").write_text(text)
        lines.append(f"geodesic_add_solver({name} {name}.cpp)")
    for name, change in CHANGED_HEADERS.items():
        folder = changed_headers(installed, source / f"{name}-headers", *change)
        lines.append(f'target_include_directories({name} BEFORE PRIVATE "{folder}")')
    (source / "CMakeLists.txt").write_text("\n".join(lines) + "\n")
    installed.build(source, source / "build")


@pytest.fixture(scope="session")
def plugins(installed: Installed, once: Callable[[str, Callable[[Path], object]], Path]) -> Path:
    """A folder with libNAME.so for every name in SOURCES."""
    return once("plugins", lambda folder: build_plugins(installed, folder)) / "build"


@pytest.fixture
def tetrahedron(tmp_path: Path) -> Path:
    file = tmp_path / "tetrahedron.obj"
    file.write_text(TETRAHEDRON)
    return file


def refusal(installed: Installed, folder: Path, *words: str | Path) -> str:
    ended = installed.bench(folder, *words)
    assert ended.returncode == 1
    assert ended.stdout == ""
    lines = ended.stderr.splitlines()
    assert len(lines) == 1, ended.stderr
    return lines[0]


def test_solver_is_listed_beside_those_of_the_program(
    installed: Installed, my_solver: Path, tmp_path: Path
) -> None:
    def names(*words: str | Path) -> set[str]:
        listed = installed.bench(tmp_path, *words, "list", "--json")
        assert listed.returncode == 0, listed.stderr
        return {solver["name"] for solver in json.loads(listed.stdout)["solvers"]}

    assert names("--plugin", my_solver) == names() | {"my-solver"}


def test_option_stands_before_the_command_or_after_it(
    installed: Installed, my_solver: Path, tmp_path: Path, tetrahedron: Path
) -> None:
    plugin: list[str | Path] = ["--plugin", my_solver]
    solve: list[str | Path] = ["solve", tetrahedron, "--solver", "my-solver", "--source", "0"]
    for words in (plugin + solve, solve + plugin):
        ended = installed.bench(tmp_path, *words, "--output", "d.txt")
        assert ended.returncode == 0, ended.stderr
        assert (tmp_path / "d.txt").read_text().split() == ["0", "1", "1", "1"]


def test_run_measures_the_solver_and_records_the_plugin(
    installed: Installed, my_solver: Path, tmp_path: Path, tetrahedron: Path
) -> None:
    # It runs in the folder of the plug-in. The processes of cells get an absolute path.
    ended = installed.bench(
        my_solver.parent, "--plugin", my_solver.name, "run", "--meshes", tetrahedron, "--solvers",
        "my-solver", "--sources", "1", "--repetitions", "1", "--min-time", "0.001",
        "--out", tmp_path / "run",
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    run = json.loads((tmp_path / "run" / "run.json").read_text())
    jsonschema.validate(run, json.loads((ROOT / "results" / "run.schema.json").read_text()))
    assert [(row["solver"], row["outcome"]) for row in run["benchmarks"]] == [("my-solver", "ok")]
    assert run["context"]["geodesic_bench"]["plugins"] == [
        {
            "file": str(my_solver.resolve()),
            "sha256": hashlib.sha256(my_solver.read_bytes()).hexdigest(),
            "solvers": ["my-solver"],
        }
    ]


def test_verify_asks_the_solver_in_processes_of_their_own(
    installed: Installed, my_solver: Path, tmp_path: Path, tetrahedron: Path
) -> None:
    ended = installed.bench(
        tmp_path, "--plugin", my_solver, "verify", "--solver", "my-solver", "--property",
        "distances-equal-the-reference", "--meshes", tetrahedron,
    )  # fmt: skip
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert "holds        distances-equal-the-reference on tetrahedron" in ended.stdout
    assert "my-solver: 1 hold, 0 fail" in ended.stdout


def test_verify_prints_a_command_that_loads_the_plugin(
    installed: Installed, plugins: Path, tmp_path: Path
) -> None:
    plugin = plugins / "libwrong.so"
    (tmp_path / "strip.obj").write_text(STRIP)
    ended = installed.bench(
        tmp_path, "--plugin", plugin, "verify", "--solver", "wrong", "--property",
        "distances-equal-the-reference", "--meshes", "strip.obj",
    )  # fmt: skip
    assert ended.returncode == 2, ended.stdout + ended.stderr
    (line,) = re.findall(r"reproduce it +(.+)", ended.stdout)
    program, *words = shlex.split(line)
    assert (program, words[:2]) == (str(installed.program), ["--plugin", str(plugin.resolve())])
    again = installed.bench(tmp_path, *words)
    assert again.returncode == 2, again.stdout + again.stderr
    assert "first wrong: vertex" in again.stdout


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("undefined", ["a::missing(int)", "build it again"]),
        ("other-contract", ["built against contract 1011", "has contract ", "build it again"]),
        ("other-sizes", ["built against contract ", "has contract ", "build it again"]),
    ],
)
def test_refused(
    installed: Installed, plugins: Path, tmp_path: Path, name: str, words: list[str]
) -> None:
    file = plugins / f"lib{name}.so"
    line = refusal(installed, tmp_path, "--plugin", file, "list")
    assert line.startswith(f"geodesic-bench: plug-in '{file}': ")
    for word in words:
        assert word in line


def test_refused_when_loaded_already(
    installed: Installed, my_solver: Path, tmp_path: Path
) -> None:
    link = tmp_path / "link.so"
    link.symlink_to(my_solver)
    line = refusal(installed, tmp_path, "--plugin", my_solver, "--plugin", link, "list")
    assert "loaded already" in line
    copy = shutil.copy(my_solver, tmp_path / "copy.so")
    line = refusal(installed, tmp_path, "--plugin", my_solver, "--plugin", copy, "list")
    assert "'my-solver'" in line and "another name" in line
