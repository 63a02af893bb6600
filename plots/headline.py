"""The main results of a run in a few sentences, all computed from the run."""

from __future__ import annotations

from collections.abc import Sequence

from plots.measures import LIMIT_SOLVER, errors_of, percent
from plots.models import groups_of_thesis
from plots.ratios import fastest_exact, mean, number, over_each_mesh, over_meshes, time_over
from plots.table_thesis import SPEED, WINDOWS, Pair, compare
from results import outcomes
from results.pairs import Floats, first, ratios
from results.reader import CLOSED_FORM, OK, ResultError, Run
from results.statistics import geometric_mean

INEXACT = 2
"""Largest number of inexact solvers that are named, the fastest first."""
FEW = 4
"""Largest number of meshes that a list names; the others are counted."""


def sentences(run: Run) -> list[str]:
    base = fastest_exact(run)
    if not base:
        return ["No answer of the run is verified, so that it has no times."]
    ratios = over_each_mesh(run, base)
    found = [
        _speed(run, base, ratios), _public(run, base, ratios), _inexact(run, base, ratios),
        _verified(run), _lacking(run), _thesis(run.of_single_sources),
    ]  # fmt: skip
    return [sentence for sentence in found if sentence]


def _speed(run: Run, base: str, ratios: dict[str, Floats]) -> str:
    exact = [s for s in ratios if run.solvers[s].exact]
    others = [s for s in (exact or ratios) if s != base]
    kind = "exact " if exact else ""
    lone = "" if exact else "No exact solver has a verified time. "
    if not others:
        return f"{lone}{base} is the only {kind}solver with a verified time{_on(run, ratios[base])}."
    second = fastest_exact(run, but={base, *(s for s in ratios if s not in others)})
    more = [s for s in others if s != second]
    slowest = max(more, key=lambda s: mean(ratios[s]), default="")
    last = LIMIT_SOLVER if LIMIT_SOLVER in more else slowest
    rank = "the fastest of the other {}solvers" if more else "the other {}solver"
    named = f"{second}, {rank.format(kind)}"
    if not _resolved(run, base, second):
        share = mean(ratios[second])
        words = (f"The run does not resolve which of {base} and {second} is faster "
                 f"(ratio {share:.3f}){_on(run, ratios[second])}")  # fmt: skip
        if last:
            words += f"; {base} {_than(mean(ratios[last]), last)}{_on(run, ratios[last])}"
        return f"{lone}{words}."
    words = f"{base} {_than(mean(ratios[second]), named)}"
    if not last:
        return f"{lone}{words}{_on(run, ratios[second])}."
    same = len(ratios[second]) == len(ratios[last])
    middle = "" if same else _on(run, ratios[second])
    return f"{lone}{words}{middle}, and {_than(mean(ratios[last]), last)}{_on(run, ratios[last])}."


def _public(run: Run, base: str, ratios: dict[str, Floats]) -> str:
    others = run.of_others
    exact = [s for s in ratios if s in others and run.solvers[s].exact]
    if not exact or base in others or not run.solvers[base].exact:
        return ""
    solver = min(exact, key=lambda s: mean(ratios[s]))
    fastest = f"Of the exact solvers of others, {solver} is the fastest"
    one = f"The exact solver of others is {solver}"
    return f"{fastest if len(exact) > 1 else one}: {base} {_than(mean(ratios[solver]), 'it')}{_on(run, ratios[solver])}."


def _resolved(run: Run, base: str, other: str) -> bool:
    """Returns whether the interval of the ratio excludes 1; True without an interval."""
    found = over_meshes(time_over(base), run, list(run.meshes), other)
    return found is None or found.estimate.excludes_one


def _than(ratio: float, other: str) -> str:
    """Returns what is said of a solver beside another one whose time is `ratio` times its own."""
    if ratio >= 1:
        return f"is {_short(ratio)} times as fast as {other}"
    return f"takes {_short(1 / ratio)} times the time of {other}"


def _short(ratio: float) -> str:
    return number(ratio) if ratio < 2 else f"{ratio:.1f}" if ratio < 10 else f"{ratio:,.0f}"


def _on(run: Run, ratios: Sequence[float] | Floats) -> str:
    count, of = len(ratios), len(run.meshes)
    if count < of:
        return f", on {count:,} of {of:,} meshes"
    return f", over {of:,} meshes" if of > 1 else f", on {next(iter(run.meshes))}"


def _inexact(run: Run, base: str, ratios: dict[str, Floats]) -> str:
    found = [s for s in ratios if not run.solvers[s].exact]
    words = []
    for solver in sorted(found, key=lambda s: mean(ratios[s]))[:INEXACT]:
        ratio, errors = mean(ratios[solver]), errors_of(run, solver)
        parts = [f"{solver} {_than(1 / ratio, base)}", _prepared(run, base, solver, ratio)]
        if len(errors):
            parts.append(f"with errors of up to {percent(errors.max())}")
        words.append(", ".join(filter(None, parts)) + _on(run, ratios[solver]))
    return f"Not exact: {'; '.join(words)}." if words and run.solvers[base].exact else ""


def _prepared(run: Run, base: str, solver: str, ratio: float) -> str:
    """Returns the ratio of first answers in words; empty if preparation makes little difference."""
    pairs = [ratios(run, mesh, solver, base, first) for mesh in run.meshes]
    known = [sample for sample in pairs if sample]
    whole = geometric_mean(known).value if known else ratio
    return f"but takes {_short(whole)} times the time of {base} with its preparation" if whole > max(1, 2 * ratio) else ""


def _verified(run: Run) -> str:
    cells = run.columns
    ok = cells.where("outcome", OK)
    words = f"{_many(cells.cells(ok), 'answer')} verified"
    exact = [solver for solver in run.solvers if run.solvers[solver].exact]
    worst = {solver: float(errors.max()) for solver in exact if len(errors := errors_of(run, solver))}
    if worst:
        solver = max(worst, key=lambda s: worst[s])
        words += f", worst relative error of an exact solver {worst[solver]:.1e} ({solver})"
    against = cells.cells(ok & cells.where("reference", CLOSED_FORM))
    return words + (f"; {against:,} of them against a closed form." if against else ".")


def _many(count: int, what: str) -> str:
    return f"{count:,} {what}{'s' * (count != 1)}"


def _lacking(run: Run) -> str:
    failed = len(outcomes.failures(run))
    words = [f"{_many(failed, 'answer')} failed or missing"] if failed else []
    if run.not_measured:
        words.append(f"not measured: {_named([skip.mesh for skip in run.not_measured])}")
    text = "; ".join(words)
    return f"{text[0].upper()}{text[1:]}." if text else ""


def _named(names: list[str]) -> str:
    rest = len(names) - FEW
    return ", ".join(names[:FEW]) + (f" and {rest:,} more" if rest > 0 else "")


def _thesis(run: Run) -> str:
    """Compares the run with the thesis: on its own models if one is measured, else on stand-ins."""
    try:
        groups = groups_of_thesis(run)
    except ResultError:
        return ""
    for kind, meshes in groups.items():
        speed = compare(run, meshes, SPEED)
        if len(speed) > 1:
            break
    else:
        return ""
    models = list(dict.fromkeys(str(mesh.thesis_model) for mesh in meshes))
    role = "a model of the thesis" if len(models) == 1 else "models of the thesis"
    own = kind != "stand-ins"
    place = f"On {_named(models)}, {role}" if own else f"On stand-ins for {_named(models)}"
    here, there = (sorted(speed, key=lambda s: float(getattr(speed[s], of))) for of in ("ours", "thesis"))
    if here == there:
        order = f"{place}, the order by time is the thesis's: {', '.join(here)}"
    elif here[0] == there[0]:
        order = (f"{place}, {here[0]} is the fastest as in the thesis; then come {', '.join(here[1:])}, "
                 f"in the thesis {', '.join(there[1:])}")  # fmt: skip
    else:
        order = f"{place}, the order by time is {', '.join(here)}, in the thesis {', '.join(there)}"
    most = max(speed, key=lambda s: speed[s].ours)
    pair = speed[most]
    longer = (f"{most} takes {_short(pair.ours)} times as long as edge-based, in the thesis "
              f"{_short(pair.thesis)} (docs/performance.md says why)")  # fmt: skip
    return f"{order}; {longer}.{_windows(compare(run, meshes, WINDOWS))}"


def _windows(windows: dict[str, Pair]) -> str:
    if not windows:
        return ""
    factors = {solver: pair.ours / pair.thesis for solver, pair in windows.items()}
    listed = ", ".join(f"{_short(factor)} ({solver})" for solver, factor in factors.items())
    return (f" Windows propagated there, over those of the thesis: {listed}; docs/metrics.md says what "
            "each counts.")  # fmt: skip
