"""Published distances: the program of the page accepts right ones and refuses wrong ones, in any rounding."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from results import fingerprints

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "contributed-results.md"
RANDOM = np.random.default_rng(7)
DISTANCES = np.concatenate([[0.0, np.inf], RANDOM.uniform(0, 3, 20000)])


@pytest.fixture
def program(tmp_path: Path) -> Path:
    """The program of the page, in a folder with the fingerprints of one mesh."""
    code = re.search(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert code
    published = {"a": {"sources": {"0": fingerprints.fingerprint(DISTANCES)}}}
    (tmp_path / "fingerprints.json").write_text(
        json.dumps({"steps": fingerprints.STEPS, "meshes": published})
    )
    (tmp_path / "program.py").write_text(code[1])
    return tmp_path / "program.py"


def are_right(program: Path, distances: NDArray[np.float64], digits: int = 17) -> bool:
    file = program.parent / "distances.txt"
    file.write_text("".join(f"{d:.{digits}g}\n" for d in distances))
    ended = subprocess.run(
        [sys.executable, program, program.parent / "fingerprints.json", "a", "0", file],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert ended.stderr == ""
    return ended.returncode == 0


def test_rounding_below_the_margin_passes(program: Path) -> None:
    margin = fingerprints.fingerprint(DISTANCES)["margin"]
    error = 0.9 * margin / (fingerprints.STEPS + 1)
    assert error > 1e-9
    assert are_right(program, DISTANCES)
    assert are_right(program, DISTANCES * (1 + error * RANDOM.choice([-1, 1], len(DISTANCES))))
    assert are_right(program, DISTANCES, digits=12)


@pytest.mark.parametrize("error", [1e-6, 1e-4, 1e-2])
def test_errors_all_over_the_mesh_are_found(program: Path, error: float) -> None:
    assert not are_right(program, DISTANCES * (1 + error))


def test_one_wrong_or_missing_vertex_is_found(program: Path) -> None:
    for vertex, wrong in [(0, np.inf), (1, 2.0), (500, DISTANCES[500] + 0.01)]:
        distances = DISTANCES.copy()
        distances[vertex] = wrong
        assert not are_right(program, distances)
    assert not are_right(program, DISTANCES[:-1])


def test_what_is_published_is_of_the_meshes_of_the_manifest() -> None:
    manifest = json.loads((ROOT / "datasets" / "manifest.json").read_text())
    sums = {mesh["name"]: mesh["sha256"] for mesh in manifest["meshes"]}
    published = json.loads(fingerprints.FILE.read_text())["meshes"]
    assert list(published) == manifest["corpora"]["real"]
    assert {name: mesh["sha256"] for name, mesh in published.items()} == {
        name: sums[name] for name in published
    }
