"""Every measured figure of README.md and docs/ has the command that makes it."""

from __future__ import annotations

import subprocess
import sys

import pytest
from pages import ROOT

sys.path.insert(0, str(ROOT / "tools"))
import claims

MEASURED = "## Times\n\n    build/release/geodesic-bench rank --solver mmp\n\n| mmp | 0.438 | 4.9% | 1,024 bytes |\n"


def test_the_list_of_figures_without_a_command_is_empty() -> None:
    ended = subprocess.run([ROOT / "tools" / "claims.py"], capture_output=True, text=True)
    assert (ended.returncode, ended.stdout) == (0, "every figure has a command\n")


@pytest.mark.parametrize("sentence", [
    "It takes 12 s.", "Errors are 0.5% in the mean.", "It is 2.3 times as fast.", "1,024 bytes a vertex.",
    "It took 0.91 of the time.", "It takes 3 to 10 ms.",
])  # fmt: skip
def test_a_figure_without_a_command_in_its_section_is_listed(sentence: str) -> None:
    (line,) = claims.unbacked({"README.md": f"# A\n\nSee `./run_all.sh --help`.\n\n## B\n\n{sentence}\n"})
    assert line.startswith("README.md:7: no command makes ")


@pytest.mark.parametrize("text", [
    "It takes 12 s: `./run_all.sh --corpus tiny`.", "Distances within 1e-12 of `0.01`.", "A 95% interval.",
    "Debian 12.5 and section 6.2.2, Table 5.2.", "Three of 29 meshes, 48,485 vertices.",
])  # fmt: skip
def test_definitions_names_and_figures_with_a_command_are_not_listed(text: str) -> None:
    assert claims.unbacked({"README.md": f"## B\n\n{text}\n"}) == []


@pytest.mark.parametrize(("figure", "is_there"), [
    ("0.44 of the time", True), ("2.3 times", True), ("4.9%", True), ("5%", True), ("1,024 bytes", True),
    ("0.43 of the time", False), ("2.4 times", False), ("4.8%", False), ("0.049 s", True),
])  # fmt: skip
def test_a_linked_section_must_have_the_figure(figure: str, is_there: bool) -> None:
    readme = f"## B\n\nIt takes {figure} ([measured](docs/a.md#times)).\n"
    assert (claims.unbacked({"README.md": readme, "docs/a.md": MEASURED}) == []) == is_there
    assert claims.unbacked({"README.md": readme, "docs/a.md": "## Times\n\n12\n"}) != []


def test_figures_of_a_made_table_are_backed_and_may_be_linked() -> None:
    table = "## Times\n\n<!-- Made by x: y -->\n| 0.438 |\n\nrun: `./run_all.sh --corpus tiny`\n<!-- End -->\n"
    readme = "## B\n\nIt is 2.3 times as fast ([all](docs/a.md)).\n"
    assert claims.unbacked({"README.md": readme, "docs/a.md": table}) == []
