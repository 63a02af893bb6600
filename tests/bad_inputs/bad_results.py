"""Bad result files. geodesic-bench and the scripts of plots/ read them."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from case import Case

ROOT = Path(__file__).resolve().parents[2]
GOLDEN = ROOT / "tests" / "plots" / "golden" / "run" / "run.json"
GOOD: dict[str, Any] = json.loads(GOLDEN.read_text(encoding="utf-8"))

Change = Callable[[dict[str, Any]], object]


def changed(change: Change) -> str:
    data = copy.deepcopy(GOOD)
    change(data)
    return json.dumps(data)


def ours(data: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = data["context"]["geodesic_bench"]
    return found


CUT = GOLDEN.read_text(encoding="utf-8")[:5000]
COMMON = "have no cell in common"
LESS = changed(lambda data: data.update(benchmarks=data["benchmarks"][:1]))
OTHER = changed(lambda data: data.update(benchmarks=data["benchmarks"][-1:]))
OTHER_MESH = changed(lambda data: ours(data)["meshes"][0].update(sha256=64 * "f"))

CASES = [
    # tests/results/test_results.py has what else the reader refuses. Every command reads with it.
    *(Case(f"{command}: cut", command, [f"geodesic-bench {script}: ", "run.json: not JSON, perhaps truncated"],
           files={"run.json": CUT})
      for command, script in (("geodesic-bench compare . .", "compare"), ("check_run.py .", "check"))),
    Case("geodesic-bench compare: runs without a common cell", "geodesic-bench compare a b",
         ["nothing to compare", COMMON], files={"a": LESS, "b": OTHER}),
    Case("geodesic-bench compare: another mesh", f"geodesic-bench compare '{GOLDEN}' b",
         ["is another file in b"], files={"b": OTHER_MESH}),
    Case("report.py: a file in place of its folder", f"report.py '{GOLDEN}'",
         ["geodesic-bench report: ", "run.json: no such folder"]),
    Case("run_all.sh check: nothing there", "run_all.sh check --no-install --run nowhere",
         ["run_all.sh: --run: no such folder: ", "/nowhere"]),
]  # fmt: skip
