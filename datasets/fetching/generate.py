"""Generated meshes: what they are made from, and making them with geodesic-bench."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping
from pathlib import Path

from .cache import CHECKOUT
from .errors import Unavailable
from .manifest import Entry

IS_CHECKOUT = (CHECKOUT / "CMakeLists.txt").exists()
"""Otherwise this is PREFIX/share/geodesic-bench of an installed copy."""
DEFAULT_BENCH = (
    CHECKOUT / "build" / "release" / "geodesic-bench"
    if IS_CHECKOUT
    else CHECKOUT.parent.parent / "bin" / "geodesic-bench"
)


def generate(bench: Path, mesh: Entry, inputs: Mapping[str, Path], target: Path) -> None:
    """Writes a generated mesh. `inputs`: the file for each parameter that names one.

    Raises Unavailable when the program is not there, or with the reason that it gives.
    """
    if not os.access(bench, os.X_OK):
        raise Unavailable(
            f"is made by geodesic-bench, which is not at {bench}: "
            "build it (./run_all.sh build) or name it with --bench"
        )
    given = {**inputs, **mesh["parameters"]}
    parameters = [f"--{name}={value}" for name, value in given.items()]
    command = [str(bench), "generate", mesh["generator"], *parameters, "-o", str(target)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or [f"exit code {done.returncode}"]
        raise Unavailable(f"could not be generated: {lines[-1]}")
