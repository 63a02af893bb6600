#!/usr/bin/python3
"""Stands in for geodesic-bench: answers `list`, `run` and `solve` from a description in JSON.

It lies beside the program as `<program>.json`: {"solvers": {name: facts}}, where facts may hold
"propagations", "peak_bytes", "outcome" and "cpu_ms" (for `solve` a list, one a solve).
"""

import json
import sys
from pathlib import Path

WORLD = json.loads(Path(f"{sys.argv[0]}.json").read_text())
MESHES = WORLD["meshes"]


def value_of(name: str) -> str:
    return sys.argv[sys.argv.index(name) + 1]


def row(solver: str, mesh: str) -> dict[str, object]:
    facts = WORLD["solvers"][solver]
    common = {"solver": solver, "mesh": mesh, "source": 0, "repetition_index": 0}
    if facts.get("outcome", "ok") != "ok":
        return {**common, "outcome": facts["outcome"], "error_message": "vertex 7 is off"}
    return {
        **common,
        "outcome": "ok",
        "cpu_time": facts["cpu_ms"],
        "max_relative_error": 1e-15,
        "window_propagations": facts["propagations"],
        "strip_depth": 9,
        "solver_peak_bytes": facts["peak_bytes"],
    }


def main() -> int:
    command = sys.argv[1]
    if command == "list":
        by_name = WORLD.get("by_name_only", [])
        solvers = [
            {"name": name, "independent_oracle": False, "by_name_only": name in by_name}
            for name in WORLD["solvers"]
        ]
        print(json.dumps({"solvers": [*solvers, {"name": "cgal", "independent_oracle": True}]}))
    elif command == "run":
        solvers_wanted = value_of("--solvers").split(",")
        rows = [row(solver, mesh) for mesh in MESHES for solver in solvers_wanted]
        context = {"compiler": WORLD["compiler"], "compiler_flags": "-O3", "processor": "fake"}
        out = Path(value_of("--out"))
        out.mkdir(parents=True)
        data = {"context": {"geodesic_bench": context}, "benchmarks": rows}
        (out / "run.json").write_text(json.dumps(data))
        return 2 if any(r["outcome"] == "wrong answer" for r in rows) else 0
    elif command == "solve":
        times = WORLD["solvers"][value_of("--solver")]["cpu_ms"]
        assert len(times) == sys.argv.count("--source")
        print(json.dumps({"solves": [{"cpu_time_s": ms / 1e3} for ms in times]}))
    return 0


sys.exit(main())
