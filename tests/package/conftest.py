"""Makes the helpers beside this file importable; the tree installed, once for all tests."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from installed import ROOT, Installed, install  # noqa: E402  (needs the path above)


@pytest.fixture(scope="session")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Installed:
    program = os.environ.get("GEODESIC_BENCH")
    if program is None:
        pytest.skip("GEODESIC_BENCH names no program; ./run_tests.sh sets it")
    folder = tmp_path_factory.mktemp("package")
    return install(Path(program).resolve().parent, folder / "a prefix")


@pytest.fixture(scope="session")
def my_solver(installed: Installed, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The plug-in of examples/solver."""
    build = installed.build(ROOT / "examples" / "solver", tmp_path_factory.mktemp("solver"))
    return build / "libmy-solver.so"
