"""Either of README's two commands works first, in one build folder, and the other compiles nothing again."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from installed import ROOT, cmake

Commands = dict[str, str]


class Configured:
    """A build folder as README's first command configures it, then as the second one does."""

    def __init__(self, build: Path) -> None:
        cmake("-S", ROOT, "-B", build, "-G", "Ninja")
        self.cache = (build / "CMakeCache.txt").read_text()
        self.program = compile_commands(build)
        cmake("-S", ROOT, "-B", build, "-DGEODESIC_TESTS=ON")
        self.with_tests = compile_commands(build)


def compile_commands(build: Path) -> Commands:
    listed = json.loads((build / "compile_commands.json").read_text())
    return {each["output"]: each["command"] for each in listed}


@pytest.fixture(scope="module")
def configured(tmp_path_factory: pytest.TempPathFactory) -> Configured:
    return Configured(tmp_path_factory.mktemp("build"))


def test_the_program_is_configured_without_what_only_tests_need(configured: Configured) -> None:
    assert not re.findall(r"(?im)^\w*(?:gtest|mpfi|pybind11)\w*:.*", configured.cache)
    assert not [output for output in configured.program if output.startswith(("tests/", "python/"))]


def test_tests_change_no_compile_command_of_the_program(configured: Configured) -> None:
    assert configured.program.items() <= configured.with_tests.items()
    assert any(output.startswith("tests/") for output in configured.with_tests)
