"""Figures with a row for each mesh and a dot for each solver: speed-up, windows over the limit,
wavefront quality (Figure 5.10), accuracy."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from plots import style
from plots.dots import (
    AT_THE_EDGE, Dot, Row, draw_rows, hollow_mark, mesh_rows, sentences, styles_of, without_value,
)  # fmt: skip
from plots.drawing import Drawing
from plots.logarithmic import logarithmic, ratio_axis
from plots.measures import (
    ERROR, LIMIT, LIMIT_SOLVER, TIME, Measure, baseline, measured_solvers, median_of,
)  # fmt: skip
from plots.models import beside_thesis, of_thesis, titled
from plots.ratios import BY_KEY, RIVAL, Ratio, over_meshes
from results import published
from results.reader import ResultError, Run

OVER_LIMIT = BY_KEY["propagations over the limit"]
SD = Measure("wavefront_sd_edges", "wavefront SD (mean edge lengths)", lambda value: f"{value:.3f}")
BOUND = 1e-12
"""Largest relative error of an exact solver on a clean mesh."""
FLOOR = 1e-17
"""Position of errors of 0: a logarithmic axis has no 0."""


def speedup(run: Run) -> Drawing:
    """@raises ResultError when no exact solver can be compared with the baseline"""
    base = baseline(run, LIMIT_SOLVER)
    ratio = Ratio("", f"speed-up over {base}: time of {base} / time", (base, TIME), (RIVAL, TIME))
    solvers = [s for s in measured_solvers(run) if s != base and run.solvers[s].exact]

    def measured(mesh: str, solver: str) -> list[Dot]:
        mean = ratio.mean(run, mesh, solver)
        return [Dot.of(mean, hollow=run.meshes[mesh].stand_in)] if mean else []

    models = of_thesis(run)
    shown = run.of_meshes([mesh.name for mesh in models]) if models else run
    rows = mesh_rows(shown, ratio.label, solvers, measured, ratio.published)
    groups = {
        "models of the thesis": [mesh.name for mesh in models if not mesh.stand_in],
        "stand-ins": [mesh.name for mesh in models if mesh.stand_in],
        "meshes": list(run.meshes),
    }
    for words, meshes in groups.items():
        means = {s: over_meshes(ratio, run, meshes, s) for s in solvers}
        dots = {
            s: [Dot.of(mean.estimate, note=f" ({mean.coverage})" if mean.coverage else "")]
            for s, mean in means.items()
            if mean
        }
        new = words == "meshes" or len(meshes) < len(run.meshes)
        if dots and new and len(meshes) > 1:
            label = f"geometric mean,\n{len(meshes)} {words}"
            hollow = {s: [replace(d, hollow=words == "stand-ins") for d in dots[s]] for s in dots}
            rows.append(Row(label, hollow, mean=True))
    marks = [hollow_mark("hollow: a stand-in")] if any(m.stand_in for m in models) else []
    label = style.plain(ratio.label)
    figure = draw_rows(rows, label, styles_of(run), marks=marks, numbers=True)
    ratio_axis(figure.axes[0].xaxis)
    return Drawing(
        title=f"Speed-up over {base}",
        caption=sentences(
            f"How many times as fast as {base} each exact solver is: geometric means of CPU time "
            "ratios paired by source and repetition, with 95% bootstrap intervals. A mean is over "
            "the meshes that have both times; their number is given where some lack them.",
            "Hollow: stand-ins, other meshes than the thesis measured." if marks else "",
            f"Diamonds: computed from {published.citation()}, Table 5.2; hollow beside a "
            "stand-in, where they are context only."
            if any(row.published for row in rows)
            else "",
            without_value(run, [base, *solvers]),
        ),
        figure=figure,
    )


def estimates(
    run: Run,
    label: str,
    measured: Callable[[str, str], Sequence[Dot]],
    words: Sequence[str],
    title: str,
    published_of: Callable[[str, str], float | None] = lambda model, solver: None,
    left: float = 0,
) -> Drawing:
    """Draws one estimate for each mesh and solver."""
    solvers = measured_solvers(run)
    rows = mesh_rows(run, label, solvers, measured, published_of)
    figure = draw_rows(rows, label, styles_of(run), left=left)
    with_value = [s for s in solvers if any(s in row.dots for row in rows)]
    caption = sentences(*words, AT_THE_EDGE, without_value(run, with_value))
    return Drawing(title, caption, figure)


def windows_over_limit(run: Run) -> Drawing:
    """@raises ResultError if no solver counts window propagations, or none counts the window limit"""
    if not run.columns.has(LIMIT.key).any():
        raise ResultError(f"{run.file}: no solver of the MMP family, which counts the window limit")

    def measured(mesh: str, solver: str) -> list[Dot]:
        mean = OVER_LIMIT.mean(run, mesh, solver)
        return [Dot.of(mean)] if mean else []

    words = [
        "Windows propagated across a face over the windows that MMP leaves on the edges: a solver "
        "at 1 propagates no window in vain. Geometric means over sources with 95% bootstrap "
        "intervals.",
        OVER_LIMIT.note,
    ]
    if of_thesis(run):
        words.insert(
            1,
            f"Thin diamonds: {published.citation()}, Table 5.2; hollow where a stand-in was "
            "measured, so that they are context only.",
        )
    title = "Window propagations over the window limit"
    return estimates(run, OVER_LIMIT.label, measured, words, title, OVER_LIMIT.published, 0.9)


def wavefront_quality(run: Run) -> Drawing:
    """Draws Figure 5.10. @raises ResultError if no solver's wavefront was recorded"""

    def measured(mesh: str, solver: str) -> list[Dot]:
        median = median_of(run, mesh, solver, SD)
        return [Dot.of(median)] if median else []

    words = [
        "Standard deviation of the distances of all windows on the wavefront, mean over samples at "
        "fixed steps of progress, in mean edge lengths of the mesh; medians over sources with 95% "
        "bootstrap intervals. Smaller is a smoother wavefront.",
        beside_thesis(run, "The thesis prints no numbers for it."),
    ]
    return estimates(run, SD.label, measured, words, titled(run, "Wavefront quality", "Figure 5.10"))


LEAST_ALIKE, ALIKE = 3, 1.01
"""Least number of solvers with equal errors, and largest factor between errors that count as equal."""


def largest_errors(run: Run, mesh: str, solver: str) -> dict[bool, float]:
    """Returns the largest error over sources and repetitions, by whether the reference is the truth."""
    errors: dict[bool, float] = {}
    for row in run.cell(mesh, solver):
        if (error := row.number(ERROR.key)) is not None:
            truth = row.against_truth
            errors[truth] = max(errors.get(truth, 0), error)
    return errors


def of_the_reference(run: Run, solvers: Sequence[str]) -> dict[str, list[str]]:
    """Returns, by reference, the meshes on which so many solvers differ from it by the same amount that
    the difference is an error of the reference."""
    found: dict[str, list[str]] = {}
    for mesh in run.meshes:
        errors: dict[str, dict[str, float]] = {}
        for solver in solvers:
            for row in run.cell(mesh, solver):
                if row.reference and not row.against_truth and (error := row.number(ERROR.key)):
                    of = errors.setdefault(row.reference, {})
                    of[solver] = max(of.get(solver, 0), error)
        for reference, of in errors.items():
            if len(of) >= LEAST_ALIKE and max(of.values()) <= ALIKE * min(of.values()):
                found.setdefault(reference, []).append(mesh)
    return found


def accuracy(run: Run) -> Drawing:
    """@raises ResultError when no exact solver was verified"""

    def measured(mesh: str, solver: str) -> list[Dot]:
        errors = sorted(largest_errors(run, mesh, solver).items())
        places = [(max(error, FLOOR), not truth) for truth, error in errors]
        return [Dot(place, place, place, hollow) for place, hollow in places]

    solvers = [s for s in measured_solvers(run) if run.solvers[s].exact]
    rows = mesh_rows(run, ERROR.label, solvers, measured)
    mark = hollow_mark("hollow: against a solver")
    figure = draw_rows(
        rows, "largest relative error", styles_of(run), marks=[mark], in_sight=BOUND
    )
    axes = figure.axes[0]
    logarithmic(axes.xaxis)
    # Errors above the bound are numbers at the right edge; the axis leaves space between them and the line.
    wrong = any(dot.value > BOUND for row in rows for dots in row.dots.values() for dot in dots)
    axes.set_xlim(left=FLOOR / 2, right=max(axes.get_xlim()[1], (300 if wrong else 4) * BOUND))
    axes.axvline(BOUND, color=style.INK, linewidth=1, linestyle=(0, (4, 2)))
    axes.annotate(
        f"bound {BOUND:.0e}", (BOUND, 1), (-3, -2), ("data", "axes fraction"),
        textcoords="offset points", rotation=90, ha="right", va="top", fontsize=8,
    )  # fmt: skip
    return Drawing(
        title="Accuracy of the exact solvers",
        caption=sentences(
            "Largest relative error over all vertices, sources and repetitions. Filled: against a "
            "closed form, which is the truth; hollow: against the distances of another solver, "
            "which the run file names. The dashed line is 1e-12, the bound on clean meshes; marks "
            "at 1e-17 are errors of 0 or below it. Upper bounds such as Dijkstra's are left out.",
            *(f"On {', '.join(meshes)} all differ from {reference} by the same amount, which is the rounding "
              f"error of {reference}." for reference, meshes in of_the_reference(run, solvers).items()),
            without_value(run, solvers),
        ),
        figure=figure,
    )
