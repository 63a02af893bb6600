"""The solvers of the thesis are right on every case of the robustness corpus."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import fetch
import pytest
from fetch_world import BENCH, COMMITTED
from fetching.program import ROOT

SOLVERS = ["mmp", "fwp-mmp", "ich", "fwp-ch", "edge-based"]
SUITE = ROOT / "harness" / "suites" / "robustness.json"


@pytest.mark.skipif(not BENCH.exists(), reason=f"no program at {BENCH}")
def test_every_case_is_right(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cases = COMMITTED["corpora"]["robustness"]
    assert fetch.main([*cases, "--cache", str(tmp_path), "--bench", str(BENCH)]) == 0
    monkeypatch.setenv("GEODESIC_DATASETS", str(tmp_path))
    command: list[str | Path] = [BENCH, "run", SUITE, "--solvers", ",".join(SOLVERS), "--sources", "2"]
    out = tmp_path / "run"
    ended = subprocess.run([*command, "--out", out], capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    run = json.loads((out / "run.json").read_text())
    ours = run["context"]["geodesic_bench"]
    assert [mesh["name"] for mesh in ours["meshes"]] == cases and not ours["skipped"]
    for mesh in COMMITTED["meshes"]:
        if mesh["name"] in cases:
            single, random = mesh["sources"][:2], "random:4"
            assert ours["sources"][mesh["name"]] in ([*single, random], [*single, random, "boundary"])
    rows = run["benchmarks"]
    assert {row["reference"] for row in rows} == {"closed-form", "brute force"}
    assert len(rows) == len(SOLVERS) * sum(map(len, ours["sources"].values()))
    assert {row["outcome"] for row in rows} == {"ok"}
