"""Runs the gate on two fake programs and a baseline of their values."""

from __future__ import annotations

import json
import shutil
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest
from results.pairs import Pairs
from results.reader import Cell

from gate import baseline, levels, revisions
from gate.program import Program
from gate.verdict import Verdict

FAKE = Path(__file__).parent / "fake_bench.py"
WORLD: dict[str, Any] = {
    "compiler": "GNU 12.2.0",
    "meshes": ["cube", "hill"],
    "solvers": {
        "mmp": {"propagations": 10_000, "peak_bytes": 10_000_000, "cpu_ms": 50.0,
                "instructions": 1_000_000},
        "ich": {"propagations": 20_000, "peak_bytes": 1_000_000, "cpu_ms": 30.0,
                "instructions": 1_000_000},
    },
    "objects": {"CMakeFiles": "core", "mmp": "mmp", "chen_han": "ich"},
}  # fmt: skip


Change = Callable[[dict[str, Any]], object]


def fact(solver: str, key: str, value: object) -> Change:
    def change(world: dict[str, Any]) -> None:
        world["solvers"][solver][key] = value

    return change


def with_valgrind(monkeypatch: pytest.MonkeyPatch) -> None:
    """Level 2 counts on the mesh cube. The counts are the facts "instructions"."""
    monkeypatch.setattr("shutil.which", lambda name: name)
    monkeypatch.setattr(levels, "CALLGRIND_MESHES", ("cube",))


def first(verdict: Verdict) -> str:
    return verdict.findings[0].line


def unchanged(_: dict[str, Any]) -> None:
    """Changes nothing."""


@dataclass(frozen=True)
class Simulated(Program):
    """A fake program. `measured` counts what each level measured with it."""

    measured: Counter[str]

    def instructions(self, cell: Cell) -> int:
        self.measured["instruction counts"] += 1
        world = json.loads(self.path.with_name(f"{self.path.name}.json").read_text())
        found = world["solvers"][cell.solver].get("instructions")
        return int(found) if found else super().instructions(cell)

    def measure_pairs(
        self, base: Program, chosen: Sequence[str], cells: Sequence[Cell], pairs: int, out: Path
    ) -> dict[Cell, Pairs]:
        self.measured["timed processes"] += 2 * pairs * len(cells)
        return super().measure_pairs(base, chosen, cells, pairs, out)


class World:
    """gate(head=change, ...) compares a changed head with a base. Other keywords are revisions.Options."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.options = revisions.Options(out=folder / "out", levels=(0, 1, 3))
        self.measured: Counter[str] = Counter()
        self.write_sources()
        self.keep_baseline()

    def program(self, name: str, change: Change = unchanged) -> Program:
        world = json.loads(json.dumps(WORLD))
        change(world)
        path = self.folder / name / "geodesic-bench"
        path.parent.mkdir(exist_ok=True)
        self.write_objects(path.parent, world["objects"])
        shutil.copy(FAKE, path)
        path.chmod(0o755)
        path.with_name(f"{path.name}.json").write_text(json.dumps(world))
        manifest = self.folder / "manifest.json"
        return Simulated(name, name, path, self.folder, manifest, self.measured)

    def write_objects(self, build: Path, objects: dict[str, str]) -> None:
        """Writes one object for each folder of solvers, and one that the build does not list."""
        names = {folder: f"solvers/{folder}/solver.cpp.o" for folder in objects}
        for folder, name in names.items():
            (build / name).parent.mkdir(parents=True, exist_ok=True)
            (build / name).write_text(objects[folder])
        (build / "solvers" / "mmp" / "of-a-file-that-is-gone.cpp.o").write_text(str(build))
        commands = [{"command": f"c++ -o {name} -c solver.cpp"} for name in names.values()]
        (build / "compile_commands.json").write_text(json.dumps(commands))

    def write_sources(self) -> None:
        for folder, solver in {"mmp": "mmp", "chen_han": "ich"}.items():
            file = self.folder / "solvers" / folder / "solver.cpp"
            file.parent.mkdir(parents=True)
            file.write_text(f'const RegisterSolver<S> s{{{{\n    .name = "{solver}",\n}}}};\n')

    def keep_baseline(self, change: Change = unchanged) -> None:
        program = self.program("baseline", change)
        run = revisions.verify(program, replace(self.options, out=self.folder / "for-the-baseline"))
        file = self.folder / baseline.FOLDER / baseline.FILE
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(baseline.as_csv(baseline.counters_of(run)))

    def gate(self, head: Change = unchanged, base: Change = unchanged, **options: Any) -> Verdict:
        programs = self.program("base", base), self.program("head", head)
        return revisions.compare(*programs, self.folder, replace(self.options, **options))
