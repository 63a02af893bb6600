"""docs/contract.md names a test for each promise, and these tests exist."""

from __future__ import annotations

import re

import pytest
from pages import ROOT

CASE = re.compile(r"^TEST(?:_[FP])?\((\w+), (\w+)\)", re.MULTILINE)
OF_CTEST = re.compile(r"add_test\(NAME (\w+)\.(\w+)")
NAMED = re.compile(r"`([A-Z]\w+)\.(\*|\w+)`")


def existing() -> set[tuple[str, str]]:
    found = set()
    for pattern, files in [(CASE, "*_test.cpp"), (OF_CTEST, "CMakeLists.txt")]:
        for file in (ROOT / "tests").rglob(files):
            found |= set(pattern.findall(file.read_text("utf-8")))
    return found | {(suite, "*") for suite, _ in found}


TESTS = existing()
NAMES = NAMED.findall((ROOT / "docs" / "contract.md").read_text("utf-8"))


def test_the_page_names_tests() -> None:
    assert len(NAMES) > 30


@pytest.mark.parametrize("name", sorted(set(NAMES)), ids=".".join)
def test_a_test_that_the_page_names_exists(name: tuple[str, str]) -> None:
    assert name in TESTS


def test_no_test_of_conformance_is_left_out() -> None:
    """Every suite that runs for every solver holds a promise, so the page has it."""
    suites = set()
    for file in (ROOT / "tests" / "conformance").glob("*_test.cpp"):
        suites |= set(re.findall(r"^FOR_EVERY_SOLVER\((\w+)\)", file.read_text("utf-8"), re.M))
    assert suites and suites <= {suite for suite, _ in NAMES}
