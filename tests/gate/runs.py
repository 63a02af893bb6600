"""Small result files, made from the golden run: interleaved, separate, slower by a known factor."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from results.reader import Run, run_of

GOLDEN = Path(__file__).resolve().parents[1] / "plots" / "golden" / "run" / "run.json"
MESHES = ["horse", "rocker-arm", "flat-grid"]

Data = dict[str, Any]


def row(solver: str, mesh: str, repetition: int, milliseconds: float, **more: Any) -> Data:
    """Returns a row. Only the first repetition has counters and memory, as in an interleaved run."""
    name = f"{solver}/{mesh}/src:0"
    counted = {"window_propagations": 1000, "solver_peak_bytes": 1_000_000}
    return {
        "name": name, "run_name": name, "run_type": "iteration", "repetitions": 15, "threads": 1,
        "repetition_index": repetition, "iterations": 1, "real_time": milliseconds,
        "cpu_time": milliseconds, "time_unit": "ms", "solver": solver, "mesh": mesh, "source": 0,
        "outcome": "ok", "max_relative_error": 1e-15, "reference": "mmp",
        **(counted if repetition == 0 else {}), **more,
    }  # fmt: skip


def failed(solver: str, mesh: str, outcome: str, **more: Any) -> Data:
    data = row(solver, mesh, 0, 0.0, outcome=outcome, error_occurred=True,
               error_message="vertex 7 is off", **more)  # fmt: skip
    for key in ("window_propagations", "solver_peak_bytes", "max_relative_error", "reference"):
        del data[key]
    return data


def times(ratio: float, spread: float, seed: int, count: int = 15) -> list[float]:
    """Returns times of about 20 ms times `ratio`. They have the same drift for every seed."""
    drift = 20 * np.exp(np.linspace(0, 0.3, count))
    noise = np.exp(np.random.default_rng(seed).normal(0, spread, count))
    return [float(t) for t in drift * ratio * noise]


def file_of(rows: Sequence[Data], solvers: Sequence[str], **ours: Any) -> Data:
    data: Data = copy.deepcopy(json.loads(GOLDEN.read_text("utf-8")))
    context = data["context"]["geodesic_bench"]
    like = context["solvers"][0]
    context["solvers"] = [{**like, "name": name} for name in solvers]
    context["sources"] = {mesh["name"]: [0] for mesh in context["meshes"]}
    context["skipped"] = []
    context.update(ours)
    data["benchmarks"] = list(rows)
    return data


def run(data: Data, name: str = "run.json") -> Run:
    return run_of(Path(name), data)


def of_solvers(
    ratios: dict[str, float | list[float]], spread: float = 0.01, pairs: int = 15,
    change: Callable[[list[Data]], object] = len,
) -> Data:
    """Returns an interleaved run. A ratio is a number for all meshes, or a list with one for each mesh."""
    rows = []
    for index, mesh in enumerate(MESHES):
        for number, (solver, ratio) in enumerate(ratios.items()):
            here = ratio if isinstance(ratio, float) else ratio[index]
            for repetition, ms in enumerate(times(here, spread, 10 * index + number, pairs)):
                rows.append(row(solver, mesh, repetition, ms))
    change(rows)
    return file_of(rows, list(ratios), interleaved=True)


def of_programs(ratio: float, spread: float = 0.02, seed: int = 0, pairs: int = 15) -> Data:
    """Returns a run of one solver on every mesh. The head takes `ratio` times the base's time."""
    rows = []
    for index, mesh in enumerate(MESHES):
        for name, factor in (("base", 1.0), ("head", ratio)):
            of = 100 * seed + 10 * index + (name == "head")
            for repetition, ms in enumerate(times(factor, spread, of, pairs)):
                rows.append(row("mmp", mesh, repetition, ms, program=name))
    build: Data = {"path": "p", "sha256": 64 * "0", "revision": "unknown", "modified": False,
                   "compiler": "GNU", "compiler_flags": "-O3", "build_type": "Release"}  # fmt: skip
    programs = [{"name": name, **build} for name in ("base", "head")]
    return file_of(rows, ["mmp"], interleaved=True, programs=programs)


def separate(ratio: float, spread: float = 0.02, seed: int = 0, count: int = 5) -> Data:
    """Returns an ordinary run of one solver."""
    rows = [
        row("mmp", mesh, repetition, ms)
        for index, mesh in enumerate(MESHES)
        for repetition, ms in enumerate(times(ratio, spread, 100 * seed + index, count))
    ]
    return file_of(rows, ["mmp"])
