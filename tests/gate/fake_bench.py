#!/usr/bin/python3
"""Stands in for geodesic-bench: answers `list` and `run` from a description in JSON.

The description is the file `<program>.json`: {"solvers": {name: facts}}. Facts may contain "propagations",
"peak_bytes", "outcome" and "cpu_ms" (a list has one time for each pair of `run --program`).
"""

import json
import sys
from pathlib import Path
from typing import Any

SOLVER = ["family", "paper", "independent_oracle", "remarks"]
MESH = {"vertices": 9, "faces": 9, "mean_edge_length": 1.0, "thesis_model": None, "stand_in": False,
        "sha256": "00"}  # fmt: skip


def world_of(program: str) -> Any:
    return json.loads(Path(f"{program}.json").read_text())


WORLD = world_of(sys.argv[0])


def value_of(name: str, absent: str = "") -> str:
    return sys.argv[sys.argv.index(name) + 1] if name in sys.argv else absent


def row(world: Any, solver: str, mesh: str, pair: int = 0) -> dict[str, Any]:
    facts = world["solvers"][solver]
    common = {"solver": solver, "mesh": mesh, "source": 0, "repetition_index": pair}
    if facts.get("outcome", "ok") != "ok":
        return {**common, "outcome": facts["outcome"], "error_message": "vertex 7 is off"}
    times = facts["cpu_ms"]
    return {
        **common,
        "outcome": "ok",
        "cpu_time": times[pair % len(times)] if isinstance(times, list) else times,
        "involuntary_switches_per_s": world.get("switches", 0.0),
        "max_relative_error": 1e-15,
        "window_propagations": facts["propagations"],
        "strip_depth": 9,
        "solver_peak_bytes": facts["peak_bytes"],
    }


def rows() -> list[dict[str, Any]]:
    solvers = value_of("--solvers").split(",")
    programs = [word for word in sys.argv if word.startswith(("base=", "head="))]
    if not programs:
        return [row(WORLD, solver, mesh) for mesh in WORLD["meshes"] for solver in solvers]
    found = []
    for cell in value_of("--cells").split(","):
        solver, mesh, _ = cell.split("/")
        for pair in range(int(value_of("--repetitions"))):
            for word in programs:
                name, _, path = word.partition("=")
                found.append({**row(world_of(path), solver, mesh, pair), "program": name})
    return found


def main() -> int:
    if sys.argv[1] == "list":
        by_name = WORLD.get("by_name_only", [])
        solvers = [
            {"name": name, "independent_oracle": False, "by_name_only": name in by_name}
            for name in WORLD["solvers"]
        ]
        print(json.dumps({"solvers": [*solvers, {"name": "cgal", "independent_oracle": True}]}))
    elif sys.argv[1] == "run":
        found = rows()
        context = {
            "compiler": WORLD["compiler"], "compiler_flags": "-O3", "processor": "fake",
            "meshes": [{"name": mesh, **MESH} for mesh in WORLD["meshes"]],
            "solvers": [
                {"name": name, "exactness": "exact", **dict.fromkeys(SOLVER, "")}
                for name in WORLD["solvers"]
            ],
            "sources": {mesh: [0] for mesh in WORLD["meshes"]},
            "skipped": [],
        }  # fmt: skip
        out = Path(value_of("--out"))
        out.mkdir(parents=True)
        data = {"context": {"geodesic_bench": context}, "benchmarks": found}
        (out / "run.json").write_text(json.dumps(data))
        return 2 if any(r["outcome"] == "wrong answer" for r in found) else 0
    return 0


sys.exit(main())
