"""Makes the helpers beside this file importable; a world to run the gate in."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from gate_world import World, instant_solve_ms  # noqa: E402  (needs the path above)

from gate import machine  # noqa: E402
from gate.program import Program  # noqa: E402


@pytest.fixture
def world(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> World:
    """The machine that tests run on is busy: it is taken to be quiet."""
    monkeypatch.setattr(machine, "disturbance", lambda before, after: "")
    monkeypatch.setattr(Program, "solve_ms", instant_solve_ms)
    return World(tmp_path)
