#!/usr/bin/env python3
"""Compares two builds of geodesic-microbench, run alternately: see README.md.

Reads Google Benchmark's JSON files of either side, in the order of their runs, and prints for each
benchmark the least CPU time of both, their ratio, and the ratio in either half of the runs.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path

Times = dict[str, float]


def least_times(files: Sequence[Path]) -> Times:
    """Least CPU time of each benchmark over files and repetitions, in nanoseconds."""
    scale = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
    least: Times = {}
    for file in files:
        for row in json.loads(file.read_text(encoding="utf-8"))["benchmarks"]:
            if row["run_type"] == "iteration":
                time = row["cpu_time"] * scale[row["time_unit"]]
                name = row["run_name"]
                least[name] = min(time, least.get(name, time))
    return least


def compare(before: Sequence[Path], after: Sequence[Path]) -> list[str]:
    """Returns the lines of the table."""
    middle = len(before) // 2
    parts_of_runs = (slice(middle), slice(middle, None))
    halves = [(least_times(before[part]), least_times(after[part])) for part in parts_of_runs]
    old, new = least_times(before), least_times(after)
    width = max((len(name) for name in old), default=0)
    lines = [f"{'benchmark':{width}}  {'before ns':>12}  {'after ns':>12}   ratio   in the halves"]
    for name in old:
        if name not in new:
            continue
        parts = "  ".join(f"{b[name] / a[name]:.3f}" for a, b in halves if name in a and name in b)
        ratio = new[name] / old[name]
        lines.append(f"{name:{width}}  {old[name]:12.2f}  {new[name]:12.2f}   {ratio:.3f}   {parts}")
    return lines


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("before", nargs="+", type=Path, help="files of the build before")
    parser.add_argument("--with", dest="after", nargs="+", type=Path, required=True)
    flags = parser.parse_args()
    if len(flags.before) != len(flags.after):
        print("compare_benchmarks.py: both builds need the same number of files, one a run", file=sys.stderr)
        return 1
    try:
        print("\n".join(compare(sorted(flags.before), sorted(flags.after))))
    except (OSError, ValueError, KeyError) as error:
        print(f"compare_benchmarks.py: cannot compare: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
