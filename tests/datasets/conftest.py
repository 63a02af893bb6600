"""Makes datasets/ and the helpers beside this file importable."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "datasets")]

from fetch_world import World  # noqa: E402  (needs the path above)


@pytest.fixture
def world(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> World:
    monkeypatch.setenv("GEODESIC_DATASETS_MIRROR", "")  # restored afterwards
    return World(tmp_path)
