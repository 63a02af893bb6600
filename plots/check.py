"""A short summary of a run, and a check that every cell is there and verified. Exit code 1 and a list
of what is not.

Listed without being a failure: a solver that does not support a mesh, an outcome that the suite
expects, and a solver that was skipped on a mesh for a stated reason. A mesh that was skipped whole is
a failure, unless --allow-skipped is given. With --others-may-fail, failures of the solvers of plug-ins
and of oracles are listed as findings, and are no failures of the run.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace

from results import console
from results.console import printable

if __name__ == "__main__":
    console.prepare("geodesic-bench check")  # before imports that may fail

import numpy as np

from plots.declared import ALLOWED, allowed, reasons
from plots.measures import of_others
from results.reader import CLOSED_FORM, OK, ResultError, Row, Run, newest_run, read_run
from results.table import to_text

MANY = 100
"""Lines of a kind: of more, the first are listed."""


def line(row: Row) -> str:
    return f"{row.cell}: {row.outcome}: {row.message}"


def findings(run: Run) -> list[Row]:
    """Failed rows of solvers of others: of plug-ins, and oracles that share no code with ours."""
    others = of_others(run)
    failed = [row for row in run.without_a_time if row.outcome not in ALLOWED]
    return [row for row in failed if row.solver in others]


def failures(run: Run, harmless: Sequence[Row] = ()) -> list[str]:
    """One line a failed row, apart from those allowed and other harmless ones, or missing cell."""
    accepted = {id(row) for row in [*allowed(run), *harmless]}  # of the one list in the run
    failed = [line(row) for row in run.without_a_time if id(row) not in accepted]
    return failed + missing(run) + parts_missing(run)


def missing(run: Run) -> list[str]:
    """One line a cell that the run should have and has not."""
    columns = run.columns
    if columns.cells(columns.has("solver")) == len(run.solvers) * sum(map(len, run.sources.values())):
        return []
    there = {(row.solver, row.mesh, row.source) for row in run.rows}
    return [
        f"{solver}/{mesh}/src:{source}: missing: the run has no row for this cell"
        for mesh in run.meshes
        for solver in run.solvers
        for source in run.sources.get(mesh, [])
        if (solver, mesh, source) not in there and run.skip(mesh, solver) is None
    ]


def parts_missing(run: Run) -> list[str]:
    """One line a shard that a merged run lacks."""
    shards = run.ours.get("missing_shards", [])
    of = len(shards) + len(run.ours.get("parts", []))
    return [f"shard {shard}/{of}: missing: it was not merged" for shard in shards]


def skipped(run: Run) -> list[str]:
    """One line a mesh that the run skipped whole."""
    return [f"{skip.mesh}: {skip.why}" for skip in run.not_measured]


def largest_errors(run: Run) -> list[str]:
    """For each exact solver its largest relative error against closed forms, which are the truth,
    and against other solvers: a line for each of the two that there is, with whom and where."""
    lines = []
    columns = run.columns
    errors = columns.numbers("max_relative_error")
    against_truth = columns.where("reference", CLOSED_FORM)
    for solver in run.solvers.values():
        for of in (against_truth, ~against_truth):
            rows = np.flatnonzero(of & columns.where("solver", solver.name) & ~np.isnan(errors))
            if len(rows) and solver.exact:
                row = run.row(int(rows[np.argmax(errors[rows])]))
                error, where = errors[rows].max(), f"{row.mesh}, source {row.source}"
                lines.append(f"{solver.name}: {error:.1e} against {row.reference} ({where})")
    return lines


def verified(run: Run) -> int:
    """How many cells have a row that is ok."""
    return run.columns.cells(run.columns.where("outcome", OK))


def checked_against_truth(run: Run) -> str:
    columns = run.columns
    rows = columns.where("outcome", OK) & columns.where("reference", CLOSED_FORM)
    places = dict.fromkeys(columns.arrays["mesh"][rows].tolist())
    meshes = first([columns.texts["mesh"][place] for place in places])
    named = ", ".join(meshes) or "no mesh of the run has one"
    return f"checked against a closed form: {columns.cells(rows)} cells ({named})"


def first(lines: Sequence[str], many: int = MANY) -> list[str]:
    """A list that can be read: of more than so many lines the first, and how many follow."""
    more = len(lines) - many
    return [*lines[:many], f"and {more} more"] if more > 0 else list(lines)


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.run_parser(
        __doc__,
        "geodesic-bench check",
        "geodesic-bench check results/runs/mine --allow-skipped",
    )
    parser.add_argument(
        "--allow-skipped", action="store_true", help="accept meshes that were skipped whole"
    )
    parser.add_argument(
        "--others-may-fail", action="store_true",
        help="list the failures of plug-ins' solvers and of oracles, and accept them",
    )  # fmt: skip
    parser.add_argument(
        "--long", action="store_true", help="every solver on every mesh, and where errors are largest"
    )
    options = parser.parse_args(arguments)
    from plots import headline, summary  # which import this module

    try:
        run = read_run(options.run or newest_run())
    except ResultError as error:
        return console.complain(error)
    if len(run.columns.texts.get("program", ())) < 2:  # the gate compares programs
        for sentence in headline.sentences(run):
            print(printable(sentence))
        print("", to_text(replace(summary.overall(run), remarks=[])), sep="\n")
    if options.long:
        print(to_text(summary.every(run.of_single_sources)))
        for largest in largest_errors(run):
            print(f"largest relative error: {largest}")
    else:
        print(f"Every solver on every mesh: geodesic-bench check --long {run.file.parent}")
    for words in first(skipped(run)):
        print(f"NOT MEASURED: {words}")
    for words in reasons(run).values():
        print(f"without a time: {words}")
    found = findings(run) if options.others_may_fail else []
    for words in first([line(row) for row in found]):
        print(f"FOUND: {words}")
    failed = failures(run, found)
    for failure in first(failed):
        print(f"FAILED: {failure}")
    passed = verified(run)
    print(checked_against_truth(run))
    if run.shard:
        print(f"shard {run.shard['index']}/{run.shard['of']} of a run: merge joins them")
    lacking = len(run.not_measured)
    meshes = f"; meshes not measured: {lacking}" if lacking else ""
    print(f"cells: {passed} verified, {len(failed)} failed{meshes}")
    return 1 if failed or not passed or (lacking and not options.allow_skipped) else 0


if __name__ == "__main__":
    sys.exit(main())
