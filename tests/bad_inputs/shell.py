"""Types and paths of the shell that runs the commands, and a check of what the machine permits."""

from __future__ import annotations

import os
import subprocess
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

from bad_results import GOLDEN

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BENCH = Path(os.environ.get("GEODESIC_BENCH") or ROOT / "build" / "release" / "geodesic-bench")
SYSTEM_PATH = "/usr/sbin:/usr/bin:/sbin:/bin"
ANSWERS = [
    "geodesic-bench generate terrain --columns 8 --rows 8 --gain 0.4 -o {0}.off",
    "geodesic-bench solve {0}.off --solver mmp --source 0 --output {0}.txt",
    f"plots strip_depth --run '{GOLDEN.parent}' --out {{0}}",
]
"""Commands that write the same bytes in every environment. `{0}` is the name of their files."""

Ended = subprocess.CompletedProcess[str]
Bash = Callable[..., Ended]


@cache
def permitted(word: str) -> bool:
    """Returns whether a command of bin/ works on this machine."""
    probes = {
        "unprivileged": "touch f; chmod 000 f; ! unprivileged cat f && unprivileged true",
        "with-disk": "with-disk size=8k true",
        "without-python": "without-python true",
    }
    with tempfile.TemporaryDirectory() as folder:
        path = f"{HERE / 'bin'}:{SYSTEM_PATH}"
        probe = ["bash", "-c", probes[word]]
        ended = subprocess.run(probe, cwd=folder, env={"PATH": path}, capture_output=True)
    return ended.returncode == 0
