"""Either of README's two commands works first, in one build folder, and the other compiles nothing again."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from installed import ROOT, cmake

class Configured:
    """A build folder as README's first command configures it, then as the second one does."""

    def __init__(self, build: Path) -> None:
        cmake("-S", ROOT, "-B", build, "-G", "Ninja")
        self.cache = (build / "CMakeCache.txt").read_text()
        self.program = compile_commands(build)
        cmake("-S", ROOT, "-B", build, "-DGEODESIC_TESTS=ON")
        self.with_tests = compile_commands(build)


def compile_commands(build: Path) -> set[str]:
    listed = json.loads((build / "compile_commands.json").read_text())
    return {each["command"] for each in listed}


def of_tests(commands: set[str]) -> set[str]:
    return {command for command in commands if re.search(" -o (tests|python)/", command)}


@pytest.fixture(scope="module")
def configured(tmp_path_factory: pytest.TempPathFactory) -> Configured:
    return Configured(tmp_path_factory.mktemp("build"))


def test_the_program_is_configured_without_what_only_tests_need(configured: Configured) -> None:
    assert not re.findall(r"(?im)^\w*(?:gtest|mpfi|pybind11)\w*:.*", configured.cache)
    assert configured.program and not of_tests(configured.program)


def test_tests_change_no_compile_command_of_the_program(configured: Configured) -> None:
    assert configured.program < configured.with_tests
    assert configured.with_tests - configured.program == of_tests(configured.with_tests)


def test_as_a_part_of_another_project_the_library_alone_is_configured(tmp_path: Path) -> None:
    own = tmp_path / "own"
    own.mkdir()
    (own / "own.cpp").write_text("#include <geodesic/geodesic.h>\nint main() {}\n")
    (own / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(Own LANGUAGES CXX)\n"
        f'add_subdirectory("{ROOT}" geodesic-bench)\nadd_executable(own own.cpp)\n'
        "target_link_libraries(own PRIVATE GeodesicBench::meshes)\n"
    )
    build = tmp_path / "build"
    cmake("-S", own, "-B", build, "-G", "Ninja", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    listed = json.loads((build / "compile_commands.json").read_text())
    files = {Path(each["file"]).relative_to(ROOT).parts[0] for each in listed if str(ROOT) in each["file"]}
    assert {"solvers"} <= files <= {"solvers", "meshes", "geodesic"}
    assert not [each for each in listed if re.search("/solvers/(variants|cgal)/", each["file"])]
    cache = (build / "CMakeCache.txt").read_text()
    assert not re.findall(r"(?im)^\w*(?:cgal|gtest|mpfi|pybind11|doxygen|benchmark)_\w*:.*", cache)
