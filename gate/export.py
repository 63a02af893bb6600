"""`geodesic-bench export`: a run in the format of another tool (docs/regression-gate.md)."""

from __future__ import annotations

import csv
import io
import json
import statistics
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from results import console

if __name__ == "__main__":
    console.prepare("geodesic-bench export")  # before imports that may fail

from results.console import Parser, complain
from results.reader import ResultError, Run, read_run

from gate.measured import COUNTERS, MEMORY, Measured, measured, programs

CSV_COLUMNS = [
    "name", "solver", "mesh", "source", "outcome", "error_message", "repetition_index",
    "real_time", "cpu_time", "time_unit", "mesh_time", "prepare_time", "window_propagations",
    "windows_created", "valid_windows", "reinsertions", "window_limit", "peak_wavefront",
    "strip_depth", "strip_b", "wavefront_sd", "wavefront_sd_edges", "window_bytes",
    "space_thesis_mb", "space_mb", "solver_peak_bytes", "process_peak_bytes",
    "unreachable_vertices", "max_relative_error", "reference", "program", "stolen_share",
    "involuntary_switches_per_s", "threads", "renew_time", "mean_relative_error",
    "rms_relative_error", "p99_relative_error", "unreachable_mismatches",
]  # fmt: skip


def cells(run: Run) -> Iterator[tuple[str, Measured]]:
    """Yields the name and the measurements of every cell. With several programs, names end in @PROGRAM."""
    names: list[str | None] = [*programs(run)]
    for program in names or [None]:
        for cell, one in measured(run, program).items():
            yield (str(cell) if program is None else f"{cell}@{program}"), one


def unit(key: str) -> str:
    return {MEMORY: "bytes", "strip_depth": "faces"}.get(key, "windows")


def to_github_action_benchmark(run: Run) -> str:
    """Returns the array for the action's `customSmallerIsBetter`. It cannot hold failed cells."""
    rows: list[dict[str, Any]] = []
    for name, one in cells(run):
        if times := one.times if one.ok else []:
            key = "real_time" if (one.number("threads") or 1) > 1 else "cpu_time"
            time = {"name": f"{name} {key}", "unit": "ms", "value": statistics.median(times)}
            rows.append({**time, "range": f"{min(times):g} to {max(times):g}"})
            for key, value in one.numbers((*COUNTERS, MEMORY)).items():
                rows.append({"name": f"{name} {key}", "unit": unit(key), "value": value})
    return json.dumps(rows, indent=2) + "\n"


def to_csv(run: Run) -> str:
    """Returns one line per repetition. A failed repetition has its outcome."""
    text = io.StringIO()
    lines = csv.writer(text, lineterminator="\n")
    lines.writerow(CSV_COLUMNS)
    lines.writerows([row.data.get(key, "") for key in CSV_COLUMNS] for row in run.rows)
    return text.getvalue()


FORMATS: dict[str, Callable[[Run], str]] = {
    "csv": to_csv,
    "github-action-benchmark": to_github_action_benchmark,
}


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser(
        __doc__,
        "geodesic-bench export --to csv results/runs/mine > mine.csv",
        "geodesic-bench export --to github-action-benchmark results/runs/mine",
    )
    parser.add_argument("--to", choices=FORMATS, required=True, help="format of the output")
    parser.add_argument("result", type=Path, help="a result file or run folder")
    options = parser.parse_args(arguments)
    try:
        run = read_run(options.result)
        print(FORMATS[options.to](run), end="")
    except (ResultError, OSError) as error:
        return complain(error)
    states = [one.ok for _, one in cells(run)]
    if not all(states):
        failed = f"{states.count(False)} of {len(states)} cells failed and have no numbers"
        print(f"geodesic-bench export: {failed}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
