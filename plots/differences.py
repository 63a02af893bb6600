"""Sentences that compare a run with the thesis: time, order of solvers, windows.

Compared are geometric means over the same models, apart for the thesis's own and for stand-ins.
"""

from __future__ import annotations

from dataclasses import dataclass
from statistics import geometric_mean

from plots.measures import EDGE_BASED
from plots.models import of_thesis
from plots.ratios import BY_KEY, Ratio
from results import statistics as estimates
from results.published import THESIS_SOLVERS
from results.reader import Mesh, Run

SPEED = BY_KEY["speed-up"]
WINDOWS = BY_KEY["propagations over the limit"]
NEAR = 0.1
"""A count of windows further from the thesis's than this share of it is named."""


@dataclass(frozen=True)
class Pair:
    """A mean over the models for which both numbers are there."""

    ours: float
    thesis: float
    models: int

    @property
    def is_far(self) -> bool:
        return abs(self.ours / self.thesis - 1) > NEAR

    def __str__(self) -> str:
        return f"{_digits(self.ours)} ({_digits(self.thesis)})"


def compare(run: Run, of: list[Mesh], ratio: Ratio) -> dict[str, Pair]:
    """By solver, for those that have the ratio here and in the thesis on some model."""
    pairs = {}
    for solver in THESIS_SOLVERS:
        both = []
        for model in of:
            sample = ratio.measured(run, model.name, solver)
            theirs = ratio.published(str(model.thesis_model), solver)
            if sample and theirs is not None:
                both.append((estimates.geometric_mean([sample]).value, theirs))
        if both:
            ours, theirs_all = zip(*both, strict=True)
            pairs[solver] = Pair(geometric_mean(ours), geometric_mean(theirs_all), len(both))
    return pairs


def paragraphs(run: Run) -> list[str]:
    """One for the thesis's own models and one for stand-ins, as far as the run has them."""
    measured = of_thesis(run)
    own = [model for model in measured if not model.stand_in]
    stand_ins = [model for model in measured if model.stand_in]
    found = []
    if own:
        names = ", ".join(model.name for model in own)
        found.append(_compared(run, own, f"On the thesis's own models in this run ({names})"))
    else:
        found.append("None of the thesis's own models was measured in this run.")
    if stand_ins:
        names = ", ".join(f"{model.name} for {model.thesis_model}" for model in stand_ins)
        found.append(
            _compared(
                run, stand_ins,
                f"On stand-ins ({names}), which are other meshes than the thesis measured, so that "
                "its numbers are context only",
            )  # fmt: skip
        )
    return found


def _compared(run: Run, of: list[Mesh], where: str) -> str:
    speed, windows = compare(run, of, SPEED), compare(run, of, WINDOWS)
    sentences = []
    rivals = [solver for solver in speed if solver != EDGE_BASED]
    if rivals:
        listed = ", ".join(f"{solver} {speed[solver]}" for solver in rivals)
        sentences.append(
            f"time over that of {EDGE_BASED}, ours first and the thesis's in brackets, is {listed}"
        )
        sentences.append(_order(speed))
    if windows:
        listed = ", ".join(f"{solver} {pair}" for solver, pair in windows.items())
        far = "" if of[0].stand_in else _far(windows)
        sentences.append(f"Window propagations over the window limit are {listed}{far}")
    if not sentences:
        return f"{where}, no cell can be compared."
    text = ". ".join(sentences)
    return f"{where}: {text}. {_coverage(len(of), speed, windows)}".strip()


def _order(speed: dict[str, Pair]) -> str:
    ours = sorted(speed, key=lambda solver: speed[solver].ours)
    theirs = sorted(speed, key=lambda solver: speed[solver].thesis)
    if ours == theirs:
        return f"The order from fastest to slowest is the thesis's: {', '.join(ours)}"
    return (
        f"From fastest to slowest they are {', '.join(ours)}, but in the thesis {', '.join(theirs)}"
    )


def _far(windows: dict[str, Pair]) -> str:
    far = [solver for solver, pair in windows.items() if pair.is_far]
    if not far:
        return f", all within {NEAR:.0%} of the thesis"
    return (
        f"; more than {NEAR:.0%} from the thesis: {', '.join(far)} "
        "(what is counted: docs/metrics.md, Counting windows)"
    )


def _coverage(of: int, *compared: dict[str, Pair]) -> str:
    """A sentence about the solvers that lack a number on some model, by how many have both."""
    fewest: dict[str, int] = {}
    for pairs in compared:
        for solver, pair in pairs.items():
            fewest[solver] = min(pair.models, fewest.get(solver, of))
    by_count: dict[int, list[str]] = {}
    for solver, models_with in fewest.items():
        if models_with < of:
            by_count.setdefault(models_with, []).append(solver)
    listed = "; ".join(
        f"{', '.join(solvers)} on {models_with}" for models_with, solvers in by_count.items()
    )
    return f"Not every model has both numbers: {listed} of {of}." if listed else ""


def _digits(value: float) -> str:
    return f"{value:.2f}" if value < 10 else f"{value:.1f}"
