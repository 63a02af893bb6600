#!/usr/bin/env python3
"""Draws what a solve by regions is predicted to take on many threads, beside PVTP's published times.

Reads the JSON of `geodesic-microbench --benchmark_filter=predicted_threads`
(`--benchmark_out=FILE --benchmark_out_format=json`).
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from matplotlib.figure import Figure  # noqa: E402

from plots import style  # noqa: E402

PVTP = {4: (1 / 3, 1 / 2.5), 8: (1 / 5, 1 / 4)}
"""Du, He, Fang, Meng, Xin 2021: 2.5 to 3 times as fast on 4 threads as on one, 4 to 5 times on 8."""

Curve = dict[int, float]
"""Time divided by that of the serial solver, by number of threads."""


def predictions(file: Path) -> dict[int, Curve]:
    """Returns the medians over repetitions, by the number of cells on a side of the terrain.

    @raises ValueError for a file without predictions"""
    samples: dict[int, dict[int, list[float]]] = {}
    try:
        rows = json.loads(file.read_text(encoding="utf-8"))["benchmarks"]
    except (ValueError, KeyError, TypeError):
        raise ValueError(f"{file}: not the JSON of geodesic-microbench") from None
    for row in rows:
        name, _, cells = row["run_name"].partition("/")
        if name != "predicted_threads" or row["run_type"] != "iteration":
            continue
        curve = samples.setdefault(int(cells), {})
        for key, value in row.items():
            if key.startswith("threads_"):
                curve.setdefault(int(key.removeprefix("threads_")), []).append(value)
    if not samples:
        raise ValueError(f"{file}: no benchmark predicted_threads")
    return {
        cells: {threads: statistics.median(values) for threads, values in sorted(curve.items())}
        for cells, curve in sorted(samples.items())
    }


def draw(curves: dict[int, Curve], file: Path) -> None:
    figure = Figure(figsize=(style.WIDTH * 0.7, 3.2), layout="constrained")
    axes = figure.subplots()
    for (cells, curve), line in zip(curves.items(), ((0, (1, 1.5)), (0, (5, 2)), style.SOLID)):
        label = f"edge-based, predicted: {(cells + 1) ** 2:,} vertices"
        axes.plot(list(curve), list(curve.values()), color=style.INK, linestyle=line, label=label)
    low, high = zip(*PVTP.values())
    axes.vlines(list(PVTP), low, high, color=style.ISOLINE, linewidth=3, label="PVTP, published")
    threads = sorted({n for curve in curves.values() for n in curve})
    axes.plot(threads, [1 / n for n in threads], color=style.PALE, linewidth=0.7, label="1 / threads")
    axes.set_xscale("log", base=2)
    axes.set_yscale("log", base=2)
    axes.set_xticks(threads, [str(n) for n in threads])
    shares = [1, 0.5, 0.25, 0.125, 1 / 16]
    axes.set_yticks(shares, [f"{share:.3g}" for share in shares])
    axes.set_ylim(1 / 20, 1.6)
    axes.minorticks_off()
    axes.grid(True)
    axes.set_xlabel("threads")
    axes.set_ylabel("time / time on one thread")
    axes.legend(loc="upper right")
    figure.savefig(file, dpi=style.DPI)


def main(words: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("benchmark", type=Path, help="JSON of geodesic-microbench")
    parser.add_argument("picture", type=Path, help="file to write: .png, .pdf or .svg")
    options = parser.parse_args(words)
    try:
        draw(predictions(options.benchmark), options.picture)
    except (OSError, ValueError) as error:
        print(f"draw_threads.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
