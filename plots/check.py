"""Whether every cell of a run is there and verified; exit code 1 and a list of what is not.

A solver that declares that it does not support a mesh, an outcome that the suite expects, and a
solver that was skipped on a mesh for a stated reason, are listed but are no failures. A mesh that
was skipped whole is one, unless --allow-skipped is given. With --plugins-may-fail what the solvers of
plug-ins fail at is a finding about them, and no failure of the run.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

from results import console

if __name__ == "__main__":
    console.prepare("geodesic-bench check")  # before imports that may fail

from results.reader import ResultError, Row, Run, newest_run, read_run

ALLOWED = ("unsupported", "skipped")


def allowed(run: Run) -> list[Row]:
    """Rows without a time that are no failures."""
    expected: dict[str, str] = run.context["geodesic_bench"].get("expected", {})
    return [
        row
        for row in run.rows
        if row.outcome in ALLOWED or row.outcome == expected.get(f"{row.solver}/{row.mesh}")
    ]


def line(row: Row) -> str:
    return f"{row.cell}: {row.outcome}: {row.message}"


def findings(run: Run) -> list[Row]:
    """Failed rows of the solvers that plug-ins brought."""
    theirs = run.of_plugins
    failed = [row for row in run.rows if not row.ok and row.outcome not in ALLOWED]
    return [row for row in failed if run.solvers[row.solver].base in theirs]


def failures(run: Run, harmless: Sequence[Row] = ()) -> list[str]:
    """One line a failed row, apart from those allowed and other harmless ones, or missing cell."""
    accepted = [*allowed(run), *harmless]
    failed = [line(row) for row in run.rows if not row.ok and row not in accepted]
    there = {(row.solver, row.mesh, row.source) for row in run.rows}
    missing = [
        f"{solver}/{mesh}/src:{source}: missing: the run has no row for this cell"
        for mesh in run.meshes
        for solver in run.solvers
        for source in run.sources.get(mesh, [])
        if (solver, mesh, source) not in there and run.skip(mesh, solver) is None
    ]
    return failed + missing + parts_missing(run)


def parts_missing(run: Run) -> list[str]:
    """One line a shard that a merged run lacks."""
    shards = run.ours.get("missing_shards", [])
    of = len(shards) + len(run.ours.get("parts", []))
    return [f"shard {shard}/{of}: missing: it was not merged" for shard in shards]


def skipped(run: Run) -> list[str]:
    """One line a solver, or all solvers, that the run skipped on a mesh."""
    return [f"{skip.mesh}, {skip.solver or 'all solvers'}: {skip.why}" for skip in run.skipped]


def largest_errors(run: Run) -> list[str]:
    """For each exact solver its largest relative error against closed forms, which are the truth,
    and against other solvers: a line for each of the two that there is, with whom and where."""
    lines = []
    for solver in run.solvers.values():
        for truth in (True, False):
            errors = [
                (row.numbers["max_relative_error"], row)
                for row in run.rows
                if row.solver == solver.name
                and row.against_truth == truth
                and "max_relative_error" in row.numbers
            ]
            if errors and solver.exact:
                error, row = max(errors, key=lambda pair: pair[0])
                where = f"{row.mesh}, source {row.source}"
                lines.append(f"{solver.name}: {error:.1e} against {row.reference} ({where})")
    return lines


def cells(rows: list[Row]) -> int:
    """How many cells the rows belong to."""
    return len({(row.solver, row.mesh, row.source) for row in rows})


def checked_against_truth(run: Run) -> str:
    rows = [row for row in run.rows if row.ok and row.against_truth]
    meshes = ", ".join(dict.fromkeys(row.mesh for row in rows)) or "no mesh of the run has one"
    return f"checked against a closed form: {cells(rows)} cells ({meshes})"


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.run_parser(
        __doc__,
        "geodesic-bench check",
        "geodesic-bench check --run results/runs/mine --allow-skipped",
    )
    parser.add_argument(
        "--allow-skipped", action="store_true", help="accept meshes that were skipped whole"
    )
    parser.add_argument(
        "--plugins-may-fail", action="store_true",
        help="list the failures of solvers of plug-ins, and accept them",
    )  # fmt: skip
    options = parser.parse_args(arguments)
    try:
        run = read_run(options.run or newest_run())
    except ResultError as error:
        return console.complain(error)
    for words in skipped(run):
        print(f"NOT MEASURED: {words}")
    for row in allowed(run):
        print(f"without a time: {line(row)}")
    found = findings(run) if options.plugins_may_fail else []
    for row in found:
        print(f"FOUND: {line(row)}")
    for largest in largest_errors(run):
        print(f"largest relative error: {largest}")
    failed = failures(run, found)
    for failure in failed:
        print(f"FAILED: {failure}")
    passed = cells([row for row in run.rows if row.ok])
    print(checked_against_truth(run))
    if run.shard:
        print(f"shard {run.shard['index']}/{run.shard['of']} of a run: merge joins them")
    lacking = len(run.not_measured)
    meshes = f"; meshes not measured: {lacking}" if lacking else ""
    print(f"cells: {passed} verified, {len(failed)} failed{meshes}")
    return 1 if failed or not passed or (lacking and not options.allow_skipped) else 0


if __name__ == "__main__":
    sys.exit(main())
