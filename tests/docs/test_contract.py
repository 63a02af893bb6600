"""docs/contract.md names a test or a property for each promise, and these exist."""

from __future__ import annotations

import re
from fnmatch import fnmatch

import pytest
from pages import ROOT

CASE = re.compile(r"^TEST(?:_[FP])?\((\w+), (\w+)\)", re.MULTILINE)
OF_CTEST = re.compile(r"add_test\(NAME (\w+)\.(\w+)")
NAMED = re.compile(r"`([A-Z]\w+)\.(\*|\w+)(?<!\.txt)`")
PROPERTY = re.compile(r'^      \{"([a-z0-9-]+)",|^.* kDistancesProperty = "([a-z0-9-]+)";$', re.MULTILINE)
NAMED_PROPERTY = re.compile(r"`((?:[a-z0-9]+-){2,}[a-z0-9]+|\*(?:-[a-z0-9]+)+|[a-z0-9]+(?:-[a-z0-9]+)*-\*)`")
"""Name of a property, or a pattern with * at one end."""


def existing() -> set[tuple[str, str]]:
    found = set()
    for pattern, files in [(CASE, "*_test.cpp"), (OF_CTEST, "CMakeLists.txt")]:
        for file in (ROOT / "tests").rglob(files):
            found |= set(pattern.findall(file.read_text("utf-8")))
    return found | {(suite, "*") for suite, _ in found}


def properties() -> set[str]:
    texts = [file.read_text("utf-8") for file in (ROOT / "harness" / "verify").rglob("*.*")]
    return {first or second for text in texts for first, second in PROPERTY.findall(text)}


PAGE = (ROOT / "docs" / "contract.md").read_text("utf-8")
TESTS = existing()
NAMES = NAMED.findall(PAGE)
PROPERTIES = properties()
PATTERNS = NAMED_PROPERTY.findall(PAGE)


def test_no_part_of_an_exact_solver_calls_hypot() -> None:
    """Its last bit differs between libraries of C. Meshes for points in faces are made by meshes/editing."""
    folders = [ROOT / "solvers", ROOT / "meshes" / "editing", ROOT / "examples" / "solver"]
    files = [file for folder in folders for file in folder.rglob("*.*")] + list((ROOT / "meshes").glob("*.*"))
    sources = [file for file in files if file.suffix in (".h", ".cpp")]
    assert len(sources) > 100
    assert [file.name for file in sources if re.search(r"\bhypot\w*\(", file.read_text("utf-8"))] == []


def test_the_page_names_tests_and_properties() -> None:
    assert len(NAMES) > 10
    assert len(PATTERNS) > 40
    assert len(PROPERTIES) > 70


@pytest.mark.parametrize("name", sorted(set(NAMES)), ids=".".join)
def test_a_test_that_the_page_names_exists(name: tuple[str, str]) -> None:
    assert name in TESTS


@pytest.mark.parametrize("pattern", sorted(set(PATTERNS)))
def test_a_property_that_the_page_names_exists(pattern: str) -> None:
    assert any(fnmatch(name, pattern) for name in PROPERTIES)


@pytest.mark.parametrize("name", sorted(PROPERTIES))
def test_no_property_is_left_out(name: str) -> None:
    """Every property checks a promise, so the page must name it."""
    assert any(fnmatch(name, pattern) for pattern in PATTERNS)


def test_no_suite_for_every_solver_is_left_out() -> None:
    """Every suite that runs for every solver checks a promise, so the page must name it."""
    suites = set()
    for file in (ROOT / "tests" / "verify").glob("*_test.cpp"):
        suites |= set(re.findall(r"^FOR_EVERY_SOLVER\((\w+)\)", file.read_text("utf-8"), re.M))
    assert suites and suites <= {suite for suite, _ in NAMES}
