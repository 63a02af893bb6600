"""`geodesic-bench compare`: two finished runs, or the two programs of one run, by the levels of the gate.

The times of two programs in one run are pairs. Two separate runs are two blocks of time, between which
the machine may have drifted: a single cell is shown and never fails, and a solver fails on the mean over
its cells only.
"""

from __future__ import annotations

import statistics
import sys
from collections.abc import Sequence
from pathlib import Path

from results import console

if __name__ == "__main__":
    console.prepare("geodesic-bench compare")  # before imports that may fail

from gate import levels, options, timing
from gate.findings import REGRESSION, GateError, LevelResult, Weight
from gate.measured import Measured, measured, programs
from gate.program import Verified
from gate.verdict import Verdict, as_text, judge, write
from results import environment
from results.pairs import interleaved
from results.reader import Cell, ResultError, Run, read_run
from results.statistics import geometric_mean_of_ratios, rank_test
from results.table import four_digits

LEVELS = (0, 1, 3, 4)
"""Those that need nothing but rows."""
SIGNIFICANCE = 0.01
"""Significance level of the rank test for a cell of two separate runs."""
LEAST_REPETITIONS = 5
"""Least repetitions of either run for this level: 2 / C(10, 5) = 0.008."""
LEAST_CELLS = 3
"""Least number of cells of a mean that may fail. Fewer cells say little about a solver."""
ONE_PROGRAM = ("both runs are of one program: where their times differ, the machine or its"
               " environment has changed between them")  # fmt: skip
SEPARATE = (
    "times are of two separate runs and include a drift of the machine between them:"
    " run --program old=FILE --program new=FILE measures both programs in pairs"
)
REPEAT = "not decided against the margin: more --repetitions decide it"

Both = tuple[Measured, Measured]


def compare(base: Run, head: Run, chosen: Sequence[int], margin: float, strict: bool) -> Verdict:
    """Compares two separate runs. @raises GateError when they cannot be compared"""
    for name, mesh in head.meshes.items():
        if name in base.meshes and base.meshes[name].sha256 != mesh.sha256:
            raise GateError(f"mesh {name} is another file in {head.file} than in {base.file}")
    before, after = (Verified(run, measured(run)) for run in (base, head))
    if not before.cells.keys() & after.cells.keys():
        raise GateError(f"nothing to compare: {base.file} and {head.file} have no cell in common")
    builds = [(run.ours["revision"], environment.of_build(run.ours)) for run in (base, head)]
    one_program = builds[0] == builds[1] and {False} == {run.ours["modified"] for run in (base, head)}
    found = _of_rows(before, after, chosen)
    if 4 in chosen:
        found.append(separate_times(levels.common(before, after), margin, one_program))
    return judge(
        str(base.file), str(head.file), found, strict, environment.differences_of_runs(base, head)
    )


def compare_programs(run: Run, chosen: Sequence[int], margin: float, strict: bool) -> Verdict:
    """Compares the programs of an interleaved run. @raises GateError when the run does not have two"""
    names = programs(run)
    if len(names) != 2:
        raise GateError(
            f"{run.file}: a single run is compared when it was measured with two --program; it has"
            f" {', '.join(names) or 'no programs'}. Give two runs otherwise"
        )
    base, head = (Verified(run, measured(run, name)) for name in names)
    found = _of_rows(base, head, chosen)
    if 4 in chosen:
        pairs = {
            after.cell: paired
            for before, after in levels.common(base, head)
            if (paired := interleaved(before.rows, after.rows))
        }
        timed = timing.Timing(margin, {}, everything=True, confirmed=1)
        timed.add(pairs)
        found.append(timing.report(timed, REPEAT))
    builds = map(environment.of_build, run.ours["programs"])
    return judge(names[0], names[1], found, strict, environment.differences(*builds))


def _of_rows(base: Verified, head: Verified, chosen: Sequence[int]) -> list[LevelResult]:
    """Returns the levels that judge rows one by one."""
    found = [levels.answers(base, head)]
    if 1 in chosen:
        counted = LevelResult(1, "The algorithms' counters")
        counted.heading = levels.counters_heading("base")
        for before, after in levels.common(base, head):
            counted.compared += 1
            for name in levels.judge_counters(counted, after.cell, before.counters(), after.counters()):
                counted.add(Weight.NOTE, str(after.cell), remark=f"only one of the two has {name}")
        found.append(counted)
    if 3 in chosen:
        found.append(levels.memory(base, head))
    return found


def separate_times(rows: Sequence[Both], margin: float, one_program: bool) -> LevelResult:
    """Level 4 for two separate runs."""
    result = LevelResult(4, f"CPU time of two separate runs, margin {margin:g}")
    alike = [both for both in rows if len({one.rows[0].processor for one in both}) == 1]
    timed = [both for both in alike if all(min(one.times) > 0 for one in both)]
    if not timed:
        result.skipped = "no row has times of one processor in both runs"
        return result
    if len(alike) < len(rows):
        result.add(Weight.NOTE, "times of different processors are not compared")
    result.add(Weight.NOTE, ONE_PROGRAM if one_program else SEPARATE)
    if min(len(one.times) for both in timed for one in both) < LEAST_REPETITIONS:
        result.add(Weight.NOTE, f"cells with fewer than {LEAST_REPETITIONS} repetitions cannot be resolved:"
                                f" run with --repetitions {LEAST_REPETITIONS}")  # fmt: skip
    result.heading = ["row", "base ms", "head ms", "head/base", "rank test or 95% interval"]
    for solver in dict.fromkeys(after.cell.solver for _, after in timed):
        of_solver = [both for both in timed if both[1].cell.solver == solver]
        result.table += [_cell(before, after, one_program) for before, after in of_solver]
        result.compared += len(of_solver)
        _mean(result, solver, of_solver, margin, one_program)
    return result


def _cell(before: Measured, after: Measured, one_program: bool) -> list[str]:
    old, new = statistics.median(before.times), statistics.median(after.times)
    p = rank_test(before.times, after.times)
    resolved = p <= SIGNIFICANCE and not one_program
    ratio = f"{'' if resolved else '~ '}{new / old:.3f}"
    return [str(after.cell), four_digits(old), four_digits(new), ratio, f"p = {p:.2g}"]


def _mean(
    result: LevelResult, solver: str, rows: Sequence[Both], margin: float, one_program: bool
) -> None:
    mean = geometric_mean_of_ratios([(before.times, after.times) for before, after in rows])
    what = timing.mean_of(solver, len(rows))
    resolved = mean.excludes_one and not one_program
    ratio = f"{'' if resolved else '~ '}{mean.value:.3f}"
    result.table.append([what, "", "", ratio, timing.interval(mean)])
    text = f"{what}: {timing.times(mean)}"
    if one_program or len(rows) < LEAST_CELLS:
        return
    if mean.low > margin:
        result.fail(text, REGRESSION, solver)
    elif timing.noticeable(mean, margin):
        result.add(Weight.WITHIN_MARGIN, text, solver=solver)


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.Parser(
        __doc__,
        "geodesic-bench compare results/runs/old results/runs/new",
        "geodesic-bench compare results/runs/two-programs --levels 0,4 --margin 1.05",
    )
    parser.add_argument("base", type=Path, help="a result file or run folder")
    parser.add_argument(
        "head", type=Path, nargs="?",
        help="a second one of the same corpus; if left out, base is a run with two --program",
    )  # fmt: skip
    options.add_to(parser, LEVELS)
    given = parser.parse_args(arguments)
    how = (given.levels, given.margin, given.strict)
    try:
        base = read_run(given.base)
        verdict = compare(base, read_run(given.head), *how) if given.head else compare_programs(base, *how)
        if given.out:
            given.out.mkdir(parents=True, exist_ok=True)
            write(verdict, given.out)
    except (GateError, ResultError, OSError) as error:
        return console.complain(error)
    print(as_text(verdict), end="")
    return verdict.exit_code


if __name__ == "__main__":
    sys.exit(main())
