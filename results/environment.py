"""What times depend on besides the solver: the machine, its settings, its load and the build, as facts of
a run in words; and the differences of two runs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .reader import Run

BUILD = {"compiler": "compiler", "compiler_flags": "compiler flags", "build_type": "build type"}
"""Facts of a program in a result file: their names, and their words."""
MACHINE = {
    "microcode": "microcode", "kernel": "kernel", "governor": "governor", "libraries": "libraries",
    "cores": "cores", "core_limit": "limit of cores",
}  # fmt: skip
"""Facts of an environment: their names, and their words."""
NONE = "none"
"""The text of a fact that the system does not tell, such as the governor of a virtual machine."""
LOAD = "load"
SAME_LOAD = 0.5
"""Greatest difference of two loads that are called the same, in running processes."""

Facts = dict[str, str]
"""Facts in words. A fact of which the file says nothing is absent."""


def of_build(described: Mapping[str, Any]) -> Facts:
    """Returns the facts of context.geodesic_bench or of one of its programs."""
    return {words: str(described[key]) for key, words in BUILD.items() if key in described}


def of_machine(environments: Sequence[Mapping[str, Any]]) -> Facts:
    """Returns the facts of the environments of a run. Where they differ, all are in the text."""
    if not environments:
        return {}
    return {
        words: "; ".join(dict.fromkeys(str(one.get(key, NONE)) for one in environments))
        for key, words in MACHINE.items()
    }


def facts(run: Run) -> Facts:
    """Returns the facts of a run that do not depend on its solvers, but for its load."""
    found = {"processor": "; ".join(run.processors or [run.ours["processor"]])}
    return found | of_machine(run.environments) | of_build(run.ours)


def load(run: Run) -> float | None:
    """Returns the largest load at a start of the run, None where the file does not say it."""
    loads = [one["load"] for one in run.environments if "load" in one]
    return max(loads, default=None)


def differences(
    base: Facts, head: Facts, *, marks: tuple[str, str] = (" (base)", " (head)")
) -> list[str]:
    """Returns the facts of either that differ, in words, and last, those that only one of them says. One
    line if all agree. The marks follow the values of the two sides."""
    of_base, of_head = marks
    both = [words for words in base if words in head]
    found = [f"different {words}: {base[words]}{of_base} / {head[words]}{of_head}"
             for words in both if base[words] != head[words]]  # fmt: skip
    alone = [words for words in {**base, **head} if words not in both]
    if alone:
        found.append(f"only one of the two says its {', '.join(alone)}")
    alike = (f"{words} {base[words]}" if words == LOAD else words for words in both)
    return found or [f"the environments agree: {', '.join(alike)}"]


def differences_of_runs(base: Run, head: Run) -> list[str]:
    """As `differences`, of two runs, with their loads and the threads of the solvers that both have."""
    before, after = facts(base), facts(head)
    old, new = load(base), load(head)
    if old is not None and new is not None and abs(new - old) <= SAME_LOAD:
        new = old
    before |= {} if old is None else {LOAD: f"{old:.1f}"}
    after |= {} if new is None else {LOAD: f"{new:.1f}"}
    both = base.solvers.keys() & head.solvers.keys()
    for run, found in ((base, before), (head, after)):
        several = {s["name"]: s.get("threads", 1) for s in run.ours["solvers"] if s["name"] in both}
        found["threads"] = ", ".join(f"{name} {several[name]}" for name in sorted(several))
    return differences(before, after)


def distinct(environments: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """Returns the environments without those that differ from an earlier one in time and load only."""
    found: dict[tuple[tuple[str, str], ...], dict[str, Any]] = {}
    for one in environments:
        found.setdefault(tuple(_of_one(one).items()), one)
    return list(found.values())


def within(run: Run) -> list[str]:
    """Returns the differences between the environments of one run, which was resumed or merged."""
    first, *others = map(_of_one, distinct(run.environments) or [{}])
    return list(
        dict.fromkeys(line for other in others for line in differences(first, other, marks=("", "")))
    )


def _of_one(found: Mapping[str, Any]) -> Facts:
    return {"processor": str(found.get("processor", NONE))} | of_machine([found])
