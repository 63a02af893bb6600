"""Every command spells its output in the same way: `-o, --output FILE` for a file, `--out DIR` for a folder."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BENCH = Path(os.environ.get("GEODESIC_BENCH") or ROOT / "build" / "release" / "geodesic-bench")
MODULES = [["-m", "plots"], ["-m", "results.fingerprints"], ["peers/build.py"]]
OPTION = re.compile(r"^ +((?:-\w,? ?)?[^-\n]*--out[a-z-]*.*)", re.MULTILINE)
ALLOWED = re.compile(r"-o(, ?| FILE\S*, )--output FILE\S*|--out DIR")


def help_of(command: list[str]) -> str:
    return subprocess.run(
        [*command, "--help"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout


def outputs(text: str) -> list[str]:
    """Returns the lines of a help that begin with an option for the output, without an example's."""
    return [line for line in OPTION.findall(text) if line.startswith("-")]


@pytest.mark.skipif(not BENCH.exists(), reason=f"no program at {BENCH}")
def test_commands() -> None:
    lists = re.split(r"ommands:\n", help_of([str(BENCH)]))[1:]
    names = [name for each in lists for name in re.findall(r"^  ([a-z-]+) ", each, re.MULTILINE)]
    found = {name: outputs(help_of([str(BENCH), name])) for name in names}
    assert {name: line for name in names for line in found[name] if not ALLOWED.match(line)} == {}
    for name in ("solve", "mesh", "generate", "view", "publish"):
        assert any(line.startswith("-o") for line in found[name]), name
    for name in ("solve", "run", "verify", "rank", "merge"):
        assert any(line.startswith("--out DIR") for line in found[name]), name


@pytest.mark.parametrize("words", MODULES, ids=[words[-1] for words in MODULES])
def test_modules(words: list[str]) -> None:
    found = outputs(help_of([sys.executable, *words]))
    assert found and all(ALLOWED.match(line) for line in found)
