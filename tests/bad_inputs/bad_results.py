"""Bad result files. geodesic-bench and the scripts of plots/ read them."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable, Iterator
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


def every_row(**values: object) -> Change:
    return lambda data: [row.update(values) for row in data["benchmarks"]]


FILES = {
    "cut": GOLDEN.read_text(encoding="utf-8")[:5000],
    "another JSON": '{"name": "geodesic"}',
    "a list": "[]",
    "of an older version": changed(lambda data: ours(data).update(schema_version=1)),
    "without rows": changed(lambda data: data.update(benchmarks=[])),
    "without times": changed(lambda data: [r.pop("cpu_time", None) for r in data["benchmarks"]]),
    "with a word for a time": changed(every_row(cpu_time="fast")),
    "of Google Benchmark alone": changed(lambda data: data["context"].pop("geodesic_bench")),
    "nested 100,000 deep": 100_000 * "[" + 100_000 * "]",
}
SAYS = {
    "cut": "not JSON, perhaps truncated",
    "another JSON": "'context' is a required property",
    "a list": "[] is not of type 'object'",
    "of an older version": "schema_version: 1 is not one of [2, 3]",
    "without rows": "benchmarks: []",
    "without times": "benchmarks[0]: 'cpu_time' is",
    "with a word for a time": "benchmarks[0].cpu_time: 'fast' is not of type 'number'",
    "of Google Benchmark alone": "'geodesic_bench' is a requi",
    "nested 100,000 deep": "nested too deep for a result file",
}


def refused() -> Iterator[Case]:
    for what, text in FILES.items():
        files = {"run.json": text}
        for command, script in (("geodesic-bench compare . .", "compare"), ("check_run.py .", "check")):
            yield Case(f"{command}: {what}", command, [f"geodesic-bench {script}: ", "run.json", SAYS[what]],
                       files=files)  # fmt: skip


COMMON = "have no cell in common"
LESS = changed(lambda data: data.update(benchmarks=data["benchmarks"][:1]))
OTHER = changed(lambda data: data.update(benchmarks=data["benchmarks"][-1:]))
OTHER_MESH = changed(lambda data: ours(data)["meshes"][0].update(sha256=64 * "f"))
UNKNOWN_MESH = changed(lambda data: data["benchmarks"][0].update(mesh="dale"))
NOT_A_NUMBER = changed(lambda data: data["benchmarks"][0].update(cpu_time=float("nan")))

CASES = [
    *refused(),
    Case("geodesic-bench compare: runs without a common cell", "geodesic-bench compare a b",
         ["nothing to compare", COMMON], files={"a": LESS, "b": OTHER}),
    Case("geodesic-bench compare: another mesh", f"geodesic-bench compare '{GOLDEN}' b",
         ["is another file in b"], files={"b": OTHER_MESH}),
    Case("geodesic-bench compare: a run that was interrupted", "geodesic-bench compare . .",
         ["run.json: no such file; was the run interrupted?"]),
    Case("check_run.py: a run that was interrupted", "check_run.py .",
         ["run.json: no such file; was the run interrupted?"]),
    Case("check_run.py: a row of an unknown mesh", "check_run.py .",
         ["benchmarks[0].mesh: 'dale' is not among the context's meshes"],
         files={"run.json": UNKNOWN_MESH}),
    Case("check_run.py: NaN", "check_run.py .", ["benchmarks[0].cpu_time: nan is not a finite"],
         files={"run.json": NOT_A_NUMBER}),
    Case("plots strip_depth: cut", "plots strip_depth --run .", ["run.json: not JSON, perhaps truncated"],
         files={"run.json": FILES["cut"]}),
    Case("report.py: a file in place of its folder", f"report.py '{GOLDEN}'",
         ["geodesic-bench report: ", "run.json: no such folder"]),
    Case("run_all.sh check: nothing there", "run_all.sh check --no-install --run nowhere",
         ["run_all.sh: --run: no such folder: ", "/nowhere"]),
]  # fmt: skip
