"""Runs the gate on two fake programs and a baseline of their values."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from gate import baseline, revisions
from gate.program import Program
from gate.verdict import Verdict

FAKE = Path(__file__).parent / "fake_bench.py"
WORLD: dict[str, Any] = {
    "compiler": "GNU 12.2.0",
    "meshes": ["cube", "hill"],
    "solvers": {
        "mmp": {"propagations": 10_000, "peak_bytes": 10_000_000, "cpu_ms": 50.0},
        "ich": {"propagations": 20_000, "peak_bytes": 1_000_000, "cpu_ms": 30.0},
    },
}


Change = Callable[[dict[str, Any]], object]


def fact(solver: str, key: str, value: object) -> Change:
    def change(world: dict[str, Any]) -> None:
        world["solvers"][solver][key] = value

    return change


def first(verdict: Verdict) -> str:
    return verdict.findings[0].text


def unchanged(_: dict[str, Any]) -> None:
    """Changes nothing."""


class World:
    """gate(head=change, ...) compares a changed head with a base. Other keywords are revisions.Options."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.options = revisions.Options(out=folder / "out", levels=(0, 1, 3))
        self.keep_baseline()

    def program(self, name: str, change: Change = unchanged) -> Program:
        world = json.loads(json.dumps(WORLD))
        change(world)
        path = self.folder / f"{name}-bench"
        shutil.copy(FAKE, path)
        path.chmod(0o755)
        path.with_name(f"{path.name}.json").write_text(json.dumps(world))
        return Program(name, name, path, self.folder, self.folder / "manifest.json")

    def keep_baseline(self, change: Change = unchanged) -> None:
        program = self.program("baseline", change)
        run = revisions.verify(program, replace(self.options, out=self.folder / "for-the-baseline"))
        file = self.folder / baseline.FOLDER / baseline.FILE
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(baseline.as_csv(baseline.counters_of(run)))

    def gate(self, head: Change = unchanged, base: Change = unchanged, **options: Any) -> Verdict:
        programs = self.program("base", base), self.program("head", head)
        return revisions.compare(*programs, self.folder, replace(self.options, **options))
