"""Makes the helpers of this folder and the package importable."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from python_package import Arrays, find_package, rough_ground, write_obj  # noqa: E402  (needs the path above)

find_package()


@pytest.fixture(scope="session")
def ground() -> Arrays:
    return rough_ground(12)


@pytest.fixture
def mesh(ground: Arrays) -> Any:
    return pytest.importorskip("geodesic_bench").Mesh(*ground)


@pytest.fixture(scope="session")
def file(ground: Arrays, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The ground as a mesh file."""
    file = tmp_path_factory.mktemp("ground") / "ground.obj"
    write_obj(file, *ground)
    return file
