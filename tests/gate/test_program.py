"""The levels that do not depend on the clock, on the real program."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

from gate import baseline, revisions
from gate.findings import GOOD
from gate.program import Program

DATASETS = Path(__file__).resolve().parents[2] / "datasets"
MESH = "tiny-terrain"


def test_the_program_against_itself_is_good_at_every_level(bench: Path, tmp_path: Path) -> None:
    """Its runs have the counters and the memory, and callgrind finds the function in which level 2 counts."""
    meshes = tmp_path / "meshes"
    subprocess.run(
        [sys.executable, DATASETS / "fetch.py", MESH, "--cache", meshes, "--bench", bench],
        check=True, capture_output=True,
    )  # fmt: skip
    base, head = (Program(name, name, bench, meshes, DATASETS / "manifest.json") for name in ("base", "head"))
    options = revisions.Options(tmp_path, (0, 1, 2, 3), solvers=("mmp", "ich"), meshes=(MESH,))
    run = revisions.verify(base, options)
    file = tmp_path / baseline.FOLDER / baseline.FILE
    file.parent.mkdir(parents=True)
    file.write_text(baseline.as_csv(baseline.counters_of(run)))
    if run.context["build_type"] != "Release":  # valgrind does not run programs with sanitizers
        options = replace(options, levels=(0, 1, 3))
    verdict = revisions.compare(base, head, tmp_path, options)
    assert verdict.exit_code == GOOD and verdict.findings == []
    assert all(level.skipped or level.compared == 2 for level in verdict.levels)
