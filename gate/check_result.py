"""`geodesic-bench check-result`: checks whether a result file can be contributed.

Checks that its checksums are right, that its machine and revision are stated, that the distances of every
time were verified, and that its numbers are plausible compared with each other, the manifest and the
counters of this revision. Nothing is measured again. A failure of a solver is a valid result.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from results import console

if __name__ == "__main__":
    console.prepare("geodesic-bench check-result")  # before imports that may fail

from gate import baseline
from gate.findings import GateError
from gate.measured import Measured
from results import checksum, outcomes
from results.console import ROOT
from results.reader import Cell, ResultError, Row, Run, read_run
from results.text import read_text

LARGEST_ERROR = 1e-9
"""Largest relative error of an exact solver. geodesic-bench accepts a thousandth of it, but the errors
of a row are relative to distances that may be nearly 0."""
NANOSECONDS = (0.2, 1e5)
"""Least and largest plausible time for the propagation of a window, in nanoseconds."""
CPU_OVER_WALL = 1.1
"""Largest plausible ratio of CPU time to wall time per thread. The two clocks differ slightly."""
COUNTS_APART, FEW = 2.0, 100
"""Counters of another revision may differ by the factor COUNTS_APART. Counters up to FEW are not compared."""


def known() -> tuple[baseline.Counters, dict[str, dict[str, Any]]]:
    """Returns the counters of this revision, and the meshes of the manifest by name.

    @raises GateError, OSError"""
    meshes = json.loads((ROOT / "datasets" / "manifest.json").read_text(encoding="utf-8"))["meshes"]
    return baseline.read(ROOT), {mesh["name"]: mesh for mesh in meshes}


def problems(run: Run, counters: baseline.Counters, manifest: Mapping[str, Mapping[str, Any]]) -> Iterator[str]:
    """Yields one line per problem of a run. `known` returns the counters and the manifest."""
    yield from _sums(run)
    yield from _origin(run)
    yield from _meshes(run, manifest)
    yield from [*outcomes.missing(run), *outcomes.parts_missing(run)]
    for row in run.rows:
        if row.ok:
            yield from (f"{row.cell}, repetition {row.repetition}: {why}" for why in _row(run, row))
    yield from _counters(run, counters)


def _sums(run: Run) -> Iterator[str]:
    text = read_text(run.file)
    stated = checksum.stated(text)
    if stated is None:
        yield "no checksum: runs have one that this program measured or merged"
    elif stated != checksum.computed(text):
        yield "the checksum is another one: the file was changed after it was written"
    if run.rows_file and run.stored.get("sha256") != checksum.of_file(run.rows_file):
        yield f"{run.rows_file.name} has another checksum, or none: merge the shards again"


def _origin(run: Run) -> Iterator[str]:
    ours = run.ours
    if ours["revision"] == "unknown":
        yield "the revision is unknown: build it in a checkout"
    if ours["modified"] is not False:
        yield "the sources were modified, or nobody knows: commit, and measure that revision"
    if ours["build_type"] != "Release":
        yield f"the build type is {ours['build_type']}, not Release"
    if "unknown" in run.processors:
        yield "the processor is unknown: rows need the name of the one that measured them"
    if run.shard:
        yield "a shard of a run: merge all of them first"


def _meshes(run: Run, manifest: Mapping[str, Mapping[str, Any]]) -> Iterator[str]:
    for mesh in run.ours["meshes"]:
        name = mesh["name"]
        listed = manifest.get(name)
        if listed is None and "licence" not in mesh:
            yield (f"{name}: is not in datasets/manifest.json: geodesic-bench publish --licence '{name}=TEXT'"
                   " says under which licence it can be had")  # fmt: skip
        elif listed and listed["sha256"] != mesh["sha256"]:
            yield (f"{name}: is another file than the mesh of that name in datasets/manifest.json:"
                   " rename it, and measure it again")  # fmt: skip


def _row(run: Run, row: Row) -> Iterator[str]:
    number, solver = row.number, run.solvers[row.solver]
    error = number("max_relative_error")
    if row.reference is None or error is None:
        yield "has a time and no verified distances"
    elif (number("unreachable_mismatches") or 0) > 0:
        yield "reaches other vertices than its reference"
    elif solver.exactness == "bounded" and error > float(solver.error_bound or 0) * (1 + 1e-12):
        yield f"an error of {error:.2g}, above the bound of {solver.error_bound:g}"
    elif solver.exact and error > LARGEST_ERROR:
        yield f"an error of {error:.2g} of an exact solver"
    cpu, wall = number("cpu_time") or 0.0, number("real_time") or 0.0
    if not (cpu > 0 and wall > 0):
        yield "a time that is not positive"
    elif cpu > CPU_OVER_WALL * wall * max(1.0, number("threads") or 1):
        yield f"{cpu:g} ms of the processor within {wall:g} ms"
    if windows := number("window_propagations"):
        each = 1e6 * row.time / windows
        if not NANOSECONDS[0] <= each <= NANOSECONDS[1]:
            yield f"{each:.3g} ns for the propagation of a window"


def _counters(run: Run, known: baseline.Counters) -> Iterator[str]:
    cells: dict[Cell, dict[str, int]] = {}
    for row in run.rows:
        counted = Measured(row.cell, [row]).counters()
        if counted and cells.setdefault(row.cell, counted) != counted:
            yield f"{row.cell}: counters differ between repetitions"
    changed = baseline.changed(ROOT)
    for cell, counted in cells.items():
        if run.ours["started"][:10] <= changed.get(cell.solver, ""):
            continue  # it counted otherwise
        for name, count in known.get(cell, {}).items():
            there = counted.get(name, 0)
            least, most = sorted([count, there])
            if most > FEW and most > COUNTS_APART * least:
                yield f"{cell}: {name} is {there:,}; this revision counts {count:,}"


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.Parser(__doc__, "geodesic-bench check-result results/contributed/*.json.gz")
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE", help="run.json of a run, by any name")
    options = parser.parse_args(arguments)
    failed = 0
    try:
        counters, manifest = known()
    except (OSError, GateError) as error:
        return console.complain(error)
    for file in options.files:
        try:
            run = read_run(file)
            found = list(problems(run, counters, manifest))
        except (ResultError, OSError) as error:
            found, run = [str(error).removeprefix(f"{file}: ")], None
        for line in outcomes.first(found):
            console.say(f"FAILED: {file}: {line}")
        if found or run is None:
            failed += 1
            continue
        console.say(f"{file}: cells: {outcomes.verified(run)} verified, {len({row.cell for row in run.without_a_time})} "
                    f"without a time; {run.ours['revision'][:10]}, {', '.join(run.processors)}, "
                    f"{run.ours['started'][:10]}")  # fmt: skip
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
