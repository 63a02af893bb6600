"""Makes the helpers beside this file and the package importable."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from python_package import Arrays, find_package, rough_ground  # noqa: E402  (needs the path above)

find_package()


@pytest.fixture(scope="session")
def ground() -> Arrays:
    return rough_ground(12)
