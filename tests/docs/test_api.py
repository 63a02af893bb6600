"""Doxygen makes the API documentation of every header without a warning."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from pages import ROOT

DOXYGEN = shutil.which("doxygen")

pytestmark = pytest.mark.skipif(DOXYGEN is None, reason="doxygen is not installed")

Ended = subprocess.CompletedProcess[str]


def doxygen(out: Path, *settings: str) -> Ended:
    """Runs Doxygen as the target docs does, with another output folder."""
    words = [(ROOT / "docs" / "Doxyfile").read_text("utf-8"), f'OUTPUT_DIRECTORY = "{out}"', *settings]
    return subprocess.run(
        [str(DOXYGEN), "-"], cwd=ROOT, input="\n".join(words), capture_output=True, text=True
    )


def test_every_header_is_documented_without_a_warning(tmp_path: Path) -> None:
    ended = doxygen(tmp_path)
    assert (ended.returncode, ended.stderr) == (0, "")
    classes = (tmp_path / "html" / "annotated.html").read_text("utf-8")
    described = dict(re.findall(r'>(\w+)</a></td><td class="desc">([^<]*)', classes))
    for name in ["Solver", "QueryIn", "Mesh", "Recording", "Description", "Window"]:
        assert described[name], f"{name} has no brief description"
    contract = (tmp_path / "html" / "solver_8h.html").read_text("utf-8")
    assert "The contract between solvers and their users" in contract


def test_a_comment_that_is_wrong_is_an_error(tmp_path: Path) -> None:
    header = tmp_path / "wrong.h"
    header.write_text("// A file.\n#pragma once\n\n/// Halves.\n/// @param y a number\nint half(int x);\n")
    ended = doxygen(tmp_path / "out", f'INPUT = "{header}"')
    assert ended.returncode != 0
    assert "wrong.h:5: " in ended.stderr and "'y'" in ended.stderr
