"""Prints a short summary of a run, and checks that every cell is present and verified. Otherwise it lists
the other cells and ends with exit code 1.

Some cells are listed without being failures: a solver that does not support a mesh, an outcome that
the suite expects, and a solver or a mesh that was skipped for a stated reason. A mesh that was named and
is there, but cannot be solved, is a failure, as it is of the run. With --others-may-fail, failures of the
solvers of plug-ins and of oracles are listed as findings and are not failures of the run.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace

from results import console
from results.console import printable

if __name__ == "__main__":
    console.prepare("geodesic-bench check")  # before imports that may fail

from plots import headline, summary
from results import outcomes
from results.reader import ResultError, newest_run, read_run
from results.table import to_text


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.run_parser(
        __doc__,
        "geodesic-bench check",
        "geodesic-bench check results/runs/mine --long",
    )
    parser.add_argument(
        "--others-may-fail", action="store_true",
        help="list the failures of plug-ins' solvers and of oracles, and accept them",
    )  # fmt: skip
    parser.add_argument(
        "--long", action="store_true", help="every solver on every mesh, and where errors are largest"
    )
    options = parser.parse_args(arguments)
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
        for largest in outcomes.largest_errors(run):
            print(f"largest relative error: {largest}")
    else:
        print(f"Every solver on every mesh: geodesic-bench check --long {run.file.parent}")
    for words in outcomes.first(outcomes.skipped(run)):
        print(f"NOT MEASURED: {words}")
    for words in outcomes.reasons(run).values():
        print(f"without a time: {words}")
    found = outcomes.findings(run) if options.others_may_fail else []
    for words in outcomes.first([outcomes.line(row) for row in found]):
        print(f"FOUND: {words}")
    failed = outcomes.failures(run, found)
    for failure in outcomes.first(failed):
        print(f"FAILED: {failure}")
    passed = outcomes.verified(run)
    print(outcomes.checked_against_truth(run))
    if run.shard:
        print(f"shard {run.shard['index']}/{run.shard['of']} of a run: merge joins them")
    lacking = len(run.not_measured)
    meshes = f"; meshes not measured: {lacking}" if lacking else ""
    print(f"cells: {passed} verified, {len(failed)} failed{meshes}")
    unreadable = any(skip.unreadable for skip in run.not_measured)
    return 1 if failed or not passed or unreadable else 0


if __name__ == "__main__":
    sys.exit(main())
