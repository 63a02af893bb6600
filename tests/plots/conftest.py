"""The golden run and copies of it that a test may break; makes the helpers here importable."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from results import Run, read_run

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

GOLDEN = HERE / "golden"

Change = Callable[[dict[str, Any]], object]


@pytest.fixture
def golden_tables() -> Path:
    return GOLDEN / "tables"


@pytest.fixture
def golden_folder() -> Path:
    return GOLDEN / "run"


@pytest.fixture
def golden_run(golden_folder: Path) -> Run:
    return read_run(golden_folder)


@pytest.fixture
def changed(golden_folder: Path, tmp_path: Path) -> Callable[[Change], Path]:
    """changed(f) is the folder of a copy of the golden run on which f was called."""

    def make(change: Change) -> Path:
        data = json.loads((golden_folder / "run.json").read_text())
        change(data)
        (tmp_path / "run.json").write_text(json.dumps(data))
        return tmp_path

    return make
