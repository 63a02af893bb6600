"""Makes the helpers of this folder importable. Provides a World in which the gate runs."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from gate_world import World  # noqa: E402  (needs the path above)


@pytest.fixture
def world(tmp_path: Path) -> World:
    return World(tmp_path)
