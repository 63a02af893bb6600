"""Makes the helpers of this folder importable. Installs the tree once for all tests."""

from __future__ import annotations

import fcntl
import os
import shutil
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from installed import ROOT, Installed, install  # noqa: E402  (needs the path above)

Once = Callable[[str, Callable[[Path], object]], Path]


@pytest.fixture(scope="session")
def once(tmp_path_factory: pytest.TempPathFactory) -> Once:
    """once(NAME, make) returns a folder that `make` fills in one process of pytest-xdist. The other
    processes wait for it. Tests must not change the folder."""
    base = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        base = base.parent

    def folder_of(name: str, make: Callable[[Path], object]) -> Path:
        folder, made = base / name, base / f"{name}.made"
        with (base / f"{name}.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not made.exists():
                shutil.rmtree(folder, ignore_errors=True)
                folder.mkdir()
                make(folder)
                made.touch()
        return folder

    return folder_of


@pytest.fixture(scope="session")
def installed(once: Once, bench: Path) -> Installed:
    build = bench.parent
    prefix = once("package", lambda folder: install(build, folder / "a prefix")) / "a prefix"
    return Installed.from_build(build, prefix)


@pytest.fixture(scope="session")
def my_solver(installed: Installed, once: Once) -> Path:
    """The plug-in of examples/solver."""
    source = ROOT / "examples" / "solver"
    return once("solver", lambda build: installed.build(source, build)) / "libmy-solver.so"


@pytest.fixture(scope="session")
def library(installed: Installed, once: Once) -> Path:
    """The build folder of examples/library."""
    return once("library", lambda build: installed.build(ROOT / "examples" / "library", build))
