"""A solver that new_solver.sh makes outside the tree builds against an installed copy and is right."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest
from installed import ROOT, Installed

RIVALS = {"template": "mmp", "mmp": "mmp"}
"""Solver whose distances the new solver must have, by the start of the new solver. The test of
docs/adding-a-solver.md has the other starts."""


@pytest.mark.parametrize("start", RIVALS)
def test_a_new_solver_builds_is_listed_runs_and_is_right(
    installed: Installed, tmp_path: Path, start: str
) -> None:
    name = f"my-{start}"
    project = tmp_path / "a project"
    subprocess.run(
        [ROOT / "new_solver.sh", name, "--from", start, "--outside", project],
        check=True, stdout=subprocess.DEVNULL,
    )  # fmt: skip
    plugin = installed.build(project, project / "build") / f"lib{name}.so"

    listed = installed.bench(tmp_path, "--plugin", plugin, "list", "--json")
    described = {solver["name"]: solver for solver in json.loads(listed.stdout)["solvers"]}
    assert described[name]["by_name_only"]

    mesh = tmp_path / "cone.ply"
    installed.bench(tmp_path, "generate", "saddle-cone", "--rings=10", "-o", mesh)
    run = installed.bench(
        tmp_path, "--plugin", plugin, "run", "--meshes", mesh, "--sources", "1",
        "--repetitions", "1", "--solvers", f"{name},{RIVALS[start]}", "--out", "run",
    )  # fmt: skip
    assert run.returncode == 0, run.stderr

    # One property only: conformance_tests check all properties of the solvers that were copied.
    verified = installed.bench(
        tmp_path, "--plugin", plugin, "verify", "--solver", name, "--property",
        "distances-equal-the-reference",
    )  # fmt: skip
    assert verified.returncode == 0, verified.stdout + verified.stderr
    assert f"{name}: 1 hold, 0 fail, " in verified.stdout.splitlines()[-1]
