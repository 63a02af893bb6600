"""Makes the helpers of this folder importable. Provides a checkout in which tests follow pages."""

from __future__ import annotations

import os
import shlex
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.with_name("package"))]

from installed import WARNINGS  # noqa: E402  (needs the path above)
from pages import ROOT, Checkout, copy_checkout  # noqa: E402

BENCH = Path(os.environ.get("GEODESIC_BENCH") or ROOT / "build" / "release" / "geodesic-bench")

PROGRAM = """#!/bin/bash
# Built elsewhere, the program knows another manifest than that of this checkout, and needs a solver
# of this checkout as a plug-in (build_solver.py).
plugin=() manifest=()
if [[ -f {plugin} ]]; then plugin=(--plugin {plugin}); fi
if [[ " $* " != *" --manifest "* ]]; then manifest=(--manifest {manifest}); fi
case $1 in
  list | solve | run | rank | verify) exec {bench} "${{plugin[@]}}" "$@" "${{manifest[@]}}" ;;
  *) exec {bench} "$@" ;;
esac
"""


@pytest.fixture
def checkout(tmp_path: Path) -> Checkout:
    """A copy of this checkout whose build/release/geodesic-bench is the program under test."""
    if not BENCH.exists():
        pytest.skip(f"no program at {BENCH}")
    folder = tmp_path / "geodesic bench"
    copy_checkout(folder)
    program = folder / "build" / "release" / "geodesic-bench"
    program.parent.mkdir(parents=True)
    program.with_name("python").symlink_to(BENCH.resolve().with_name("python"))
    words = {
        "bench": BENCH.resolve(),
        "manifest": folder / "datasets" / "manifest.json",
        "plugin": program.with_name("plugin.so"),
    }
    program.write_text(PROGRAM.format(**{k: shlex.quote(str(v)) for k, v in words.items()}))
    program.chmod(0o755)
    own = {
        "GEODESIC_DATASETS": str(folder / "datasets" / "cache"),
        "GEODESIC_BENCH": str(program),
        "GEODESIC_BUILD": str(BENCH.resolve().parent),
        "GEODESIC_PYTHON": sys.executable,
        "CXXFLAGS": WARNINGS,
    }
    inherited = {k: v for k, v in os.environ.items() if k != "GEODESIC_DATASETS_MIRROR"}
    return Checkout(folder, inherited | own)
