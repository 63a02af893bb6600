"""Writes results/fingerprints.json, with which a program in any language can check its geodesic distances
on public meshes, without this project's programs (docs/contributed-results.md).

A distance d becomes the integer floor(steps * d / scale + offset), one per vertex, -1 for an unreachable
vertex. The file has the SHA-256 of these integers in decimal, with a line feed after each. `scale` is about
the largest distance. `offset` is chosen so that all distances are as far as possible from a change of their
integer, and `margin` is how far they are: a program whose relative error is below margin / (steps + 1)
computes the same integers.
"""

from __future__ import annotations

import hashlib
import json
import math
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from results import console

if __name__ == "__main__":
    console.prepare(place="--output")  # before imports that may fail

import numpy as np
from numpy.typing import NDArray

from results.console import ROOT

FILE = ROOT / "results" / "fingerprints.json"
SOLVERS = ("edge-based", "fwp-ch")
"""Two solvers that share no propagation code. Their numbers must be equal."""
STEPS = 1000
OFFSETS = np.arange(1, 256) / 256
LEAST_MARGIN = 1e-6


class FingerprintError(Exception):
    """An error whose message is one line."""


def steps_of(distances: NDArray[np.float64], scale: float, offset: float) -> list[int]:
    return [math.floor(STEPS * d / scale + offset) if math.isfinite(d) else -1 for d in distances]


def sha256_of(numbers: Sequence[int]) -> str:
    return hashlib.sha256("".join(f"{number}\n" for number in numbers).encode()).hexdigest()


def fingerprint(distances: NDArray[np.float64]) -> dict[str, Any]:
    """@raises FingerprintError when no offset has at least the margin LEAST_MARGIN"""
    finite = distances[np.isfinite(distances)]
    scale = float(f"{finite.max():.6g}")
    places = STEPS * finite / scale
    margins = [np.abs(places + offset - np.round(places + offset)).min() for offset in OFFSETS]
    best = int(np.argmax(margins))
    if margins[best] < LEAST_MARGIN:
        raise FingerprintError("distances lie too near to where the published numbers change")
    offset = float(OFFSETS[best])
    return {
        "scale": scale, "offset": offset, "margin": float(f"{margins[best] * 0.99:.2g}"),
        "sha256": sha256_of(steps_of(distances, scale, offset)),
    }  # fmt: skip


def run(bench: Path, *words: str) -> str:
    """Returns the output of a command of geodesic-bench. @raises FingerprintError when it fails"""
    ended = subprocess.run([bench, *words], capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        raise FingerprintError(ended.stderr.strip().splitlines()[-1] if ended.stderr else "failed")
    return ended.stdout


def distances(bench: Path, mesh: str, solver: str, source: int) -> NDArray[np.float64]:
    words = ["solve", mesh, "--solver", solver, "--source", str(source), "--output", "-"]
    return np.array([float(line) for line in run(bench, *words).split()])


def of_mesh(bench: Path, mesh: dict[str, Any]) -> dict[str, Any]:
    """@param mesh entry of the manifest"""
    found = {}
    for source in (0, mesh["vertices"] // 2):
        of = [distances(bench, mesh["name"], solver, source) for solver in SOLVERS]
        one = fingerprint(of[0])
        if sha256_of(steps_of(of[1], one["scale"], one["offset"])) != one["sha256"]:
            raise FingerprintError(f"{mesh['name']}, source {source}: {' and '.join(SOLVERS)} differ")
        found[str(source)] = one
    return {"sha256": mesh["sha256"], "vertices": mesh["vertices"], "sources": found}


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.Parser(__doc__, "python3 -m results.fingerprints --corpus real")
    parser.add_argument("--corpus", default="real", metavar="NAME", help="of the manifest; default: real")
    parser.add_argument(
        "--bench", type=Path, metavar="FILE", help="geodesic-bench; default: that of build/release"
    )  # fmt: skip
    parser.add_argument(
        "-o", "--output", type=Path, default=FILE, metavar="FILE", help=f"default: {FILE.name}"
    )
    options = parser.parse_args(arguments)
    try:
        manifest = json.loads((ROOT / "datasets" / "manifest.json").read_text(encoding="utf-8"))
        meshes = {mesh["name"]: mesh for mesh in manifest["meshes"]}
        if options.corpus not in manifest["corpora"]:
            raise FingerprintError(f"no corpus {options.corpus!r} in datasets/manifest.json")
        bench = options.bench or Path(console.bench())
        found = {}
        for name in manifest["corpora"][options.corpus]:
            found[name] = of_mesh(bench, meshes[name])
            console.say(name)
        data = {"steps": STEPS, "meshes": found}
        options.output.write_text(json.dumps(data, indent=2) + "\n", encoding="utf-8")
        console.say(str(options.output))
    except (FingerprintError, OSError) as error:
        return console.complain(error)
    return 0


if __name__ == "__main__":
    sys.exit(main())
