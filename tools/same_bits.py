#!/usr/bin/python3
"""Whether two builds of geodesic-bench give the same distances to the last bit, and the same counters.

    tools/same_bits.py build/release/geodesic-bench 'qemu-aarch64 -L ROOT build/aarch64/geodesic-bench' \\
        --meshes horse,terrain --solvers edge-based,mmp

Each program may be a command of several words. The source is vertex 0 of every mesh. Times, memory,
phases and the name of the instruction set are not compared. Exit codes: 0 the same, 2 not the same,
1 an error.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

OWN = {
    "cpu_time_s", "real_time_s", "prepare_time_s", "phase_seconds", "instruction_set",
    "process_peak_bytes", "solver_peak_bytes",
}  # fmt: skip


def answer(program: str, mesh: str, solver: str, folder: str) -> dict[str, Any]:
    """Returns the output of `solve` without the keys OWN, and the SHA-256 of its distances.

    @raises RuntimeError when `solve` fails"""
    file = Path(folder) / "distances.npy"
    words = ["solve", mesh, "--solver", solver, "--source", "0", "--counters", "--output", str(file)]
    ended = subprocess.run([*shlex.split(program), *words], capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        raise RuntimeError(f"{program}: {solver} on {mesh}: {ended.stderr.strip() or ended.returncode}")
    printed = json.loads(ended.stdout)
    found = {key: value for key, value in printed.items() if key not in OWN}
    return found | {"distances": hashlib.sha256(file.read_bytes()).hexdigest()}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("first")
    parser.add_argument("second")
    parser.add_argument("--meshes", required=True, help="names or files, separated by commas")
    parser.add_argument("--solvers", required=True, help="names, separated by commas")
    words = parser.parse_args()
    same = different = 0
    with tempfile.TemporaryDirectory() as folder:
        for mesh in words.meshes.split(","):
            for solver in words.solvers.split(","):
                try:
                    one, other = (answer(p, mesh, solver, folder) for p in (words.first, words.second))
                except (OSError, ValueError, RuntimeError) as error:
                    print(f"same_bits.py: {error}", file=sys.stderr)
                    return 1
                keys = [key for key in one if one[key] != other.get(key)]
                same += not keys
                different += bool(keys)
                if keys:
                    print(f"{solver} on {mesh}: {', '.join(keys)} differ")
    print(f"{same} answers the same to the last bit, {different} not")
    return 2 if different else 0


if __name__ == "__main__":
    sys.exit(main())
