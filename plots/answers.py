"""Cost of answers: for every solver on every mesh the time of the first answer and of each further
one, memory and errors."""

from __future__ import annotations

from plots.measures import (
    ABSENT, EDGE_BASED, ERROR, PEAK_BYTES, RESIDENT, baseline, columns, failure, interval_field, our_field,
    partial_failure, time_unit,
)  # fmt: skip
from plots.models import ordered_meshes
from plots.ratios import plain
from results.pairs import Time, by_source, first, further, ratios, times
from results.reader import Mesh, Run
from results.statistics import geometric_mean, median
from results.table import BLANK, Field, Table, estimate_field


def errors(run: Run, mesh: str, solver: str, key: str) -> list[float]:
    """Returns the error `key` of each row that has it, for right and wrong answers."""
    found = (row.number(key) for row in run.cell(mesh, solver))
    return [error for error in found if error is not None]


def table(run: Run) -> Table:
    base = baseline(run, EDGE_BASED)
    return Table(
        name="answers",
        title="First answer and further ones",
        header=[
            "Mesh", "Solver", "Promise", "Outcome", "First answer", f"/ {base}", "Each further",
            f"/ {base}, further", "Solver's peak (MB)", "Process's peak (MB)", "Largest error",
            "Mean error",
        ],
        text_columns=4,
        rows=[row for mesh in ordered_meshes(run) for row in _block(run, mesh, base)],
        remarks=[
            "First answer: preparation (conversion of the mesh, factorisation) and a solve; each "
            "further: what has to be built again for another source, and a solve. CPU time, and "
            "wall time of solvers with several threads: medians over sources and repetitions. "
            "Ratios are paired by source and repetition: geometric means. In brackets: 95% bootstrap "
            "intervals. Errors are relative, against the reference: the largest, and the median "
            "over sources of the mean over vertices; wrong answers have no time, but errors.",
        ],
    )


def _block(run: Run, mesh: Mesh, base: str) -> list[list[Field]]:
    firsts = {s: times(run, mesh.name, s, first) for s in columns(run)}
    middle = {s: median(by_source(of)).value for s, of in firsts.items() if of}
    order = sorted(firsts, key=lambda s: middle.get(s, float("inf")))
    return [
        [Field("" if index else mesh.name, mesh.label), *_row(run, mesh.name, solver, base)]
        for index, solver in enumerate(order)
    ]


def _row(run: Run, mesh: str, solver: str, base: str) -> list[Field]:
    note = partial_failure(run, mesh, solver)
    failed = failure(run, mesh, solver)
    if failed:
        costs = [BLANK] * 6
    else:
        costs = [
            *_time(run, mesh, solver, base, first),
            *_time(run, mesh, solver, base, further),
            our_field(run, mesh, solver, PEAK_BYTES),
            our_field(run, mesh, solver, RESIDENT),
        ]
    largest = errors(run, mesh, solver, "max_relative_error")
    mean = errors(run, mesh, solver, "mean_relative_error")
    return [
        Field(solver),
        Field(run.solvers[solver].promise),
        failed or Field("ok", note=note),
        *costs,
        _error(max(largest)) if largest else Field(ABSENT),
        _error(median([mean]).value) if mean else Field(ABSENT),
    ]


def _time(run: Run, mesh: str, solver: str, base: str, time: Time) -> list[Field]:
    """Returns the fields of the solver's time and of its ratio to the base's time."""
    estimate = median(by_source(times(run, mesh, solver, time)))
    shown = time_unit([estimate.value]).interval(estimate)
    pairs = ratios(run, mesh, solver, base, time)
    if not pairs:
        return [estimate_field(estimate, shown), Field(ABSENT)]
    ratio = geometric_mean([pairs])
    return [estimate_field(estimate, shown), interval_field(ratio, plain)]


def _error(error: float) -> Field:
    return Field(ERROR.show(error), error)
