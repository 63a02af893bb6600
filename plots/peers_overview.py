"""Figure of our exact solvers and the public codes of the field: the time of preparation and one solve
of each solver, and what is known of its distances."""

from __future__ import annotations

import shlex
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from plots import style
from plots.answers import errors
from plots.dots import sentences
from plots.drawing import Drawing
from plots.logarithmic import ratio_axis
from plots.measures import columns, percent
from plots.ratios import fastest_exact, mean, number
from results import pairs
from results.console import ROOT
from results.reader import ResultError, Run
from results.statistics import Estimate, geometric_mean, median

OURS, EXACT, OTHER = "of this project", "of others, exact or within 1e-6", "of others, approximate"
GROUPS = {OURS: "#000000", EXACT: "#0072B2", OTHER: "#D55E00"}
"""Colours of the groups."""
NEARLY = 1e-6
"""Largest error bound of a solver that is grouped with the exact ones."""
SCRIPT = "run_all.sh"
CHARACTERS = 110
"""Largest length of a line of the footer."""


@dataclass(frozen=True)
class Line:
    solver: str
    group: str
    ratios: list[float]
    """Ratios to the base's time, one per mesh."""
    over_meshes: Estimate | None
    """Their geometric mean; None without a ratio."""
    accuracy: str

    @property
    def mean(self) -> float:
        return mean(self.ratios)


def figure(run: Run) -> Drawing:
    """@raises ResultError if the run has no solver of others with a time"""
    public = run.of_others
    if not public:
        raise ResultError(f"{run.file}: no solver of others: ./run_all.sh --peers all measures public codes")
    base = fastest_exact(run)
    lines = [_line(run, solver, base, public) for solver in columns(run)
             if solver in public or run.solvers[solver].exact]  # fmt: skip
    # Our own solvers that are limited to a few small meshes are left out.
    least = len(run.meshes) / 2
    shown = sorted(
        (line for line in lines if line.ratios and (line.solver in public or len(line.ratios) >= least)),
        key=lambda line: line.mean,
    )
    if not any(line.solver in public for line in shown):
        raise ResultError(f"{run.file}: no solver of others has a time that compares with {base}")
    picture = _draw(run, shown, base)
    absent = [line.solver for line in lines if line not in shown]
    return Drawing(
        title="Our solvers and those of others",
        caption=sentences(
            f"Time of preparation and one solve, over that of {base}: a dot a mesh, paired "
            "by source and repetition; the bar and the number are the geometric mean over the meshes "
            "that have a verified answer, the line its 95% bootstrap interval over sources and repetitions. On the right, the guarantee of the distances or, where they are "
            "not exact, their relative errors: the mean over vertices and meshes, and the largest.",
            f"Left out: {', '.join(absent)}, with times on few of the meshes or none." if absent else "",
            footer(run) + ".",
        ),
        figure=picture,
    )


def _line(run: Run, solver: str, base: str, public: set[str]) -> Line:
    each = [pairs.ratios(run, mesh, solver, base, pairs.first) for mesh in run.meshes]
    samples = [sample for sample in each if sample]
    ratios = [geometric_mean([sample]).value for sample in samples]
    about = run.solvers[solver]
    near = about.exact or (about.error_bound or 1) <= NEARLY
    group = OURS if solver not in public else EXACT if near else OTHER
    means = [median([known]).value for m in run.meshes
             if (known := errors(run, m, solver, "mean_relative_error"))]  # fmt: skip
    largest = [e for m in run.meshes for e in errors(run, m, solver, "max_relative_error")]
    accuracy = about.promise
    if not near and means and largest:
        accuracy = f"errors: mean {percent(sum(means) / len(means))}, largest {percent(max(largest))}"
    if len(ratios) < len(run.meshes):
        accuracy += f"; on {len(ratios)} of {len(run.meshes)} meshes"
    return Line(solver, group, ratios, geometric_mean(samples) if samples else None, accuracy)


def _draw(run: Run, lines: Sequence[Line], base: str) -> Figure:
    foot = textwrap.wrap(footer(run), CHARACTERS, break_on_hyphens=False)
    picture = style.new_figure(1.1 + 0.27 * len(lines) + 0.13 * len(foot), width=8)
    axes = picture.subplots()
    for place, line in enumerate(lines):
        color = GROUPS[line.group]
        axes.plot(line.ratios, [place] * len(line.ratios), "o", color=color, markersize=3, alpha=0.55)
        axes.plot([line.mean], [place], "|", color=color, markersize=14, markeredgewidth=1.8)
        if line.over_meshes:
            axes.errorbar([line.mean], [place], xerr=style.bars([line.over_meshes]), color=color, elinewidth=1)
        axes.annotate(
            f"{number(line.mean)}", (1.02, place), xycoords=("axes fraction", "data"), va="center",
            fontsize=9,
        )  # fmt: skip
        axes.annotate(
            line.accuracy, (1.09, place), xycoords=("axes fraction", "data"), va="center", fontsize=8,
            color=style.PALE,
        )  # fmt: skip
    axes.set_yticks(range(len(lines)), [style.plain(line.solver) for line in lines])
    for label, line in zip(axes.get_yticklabels(), lines, strict=True):
        label.set_color(GROUPS[line.group])
    axes.set_ylim(len(lines) - 0.4, -0.6)
    axes.tick_params(axis="y", length=0)
    axes.grid(axis="x")
    ratio_axis(axes.xaxis)
    axes.set_xlabel(f"preparation and one solve, time / {style.plain(base)}")
    picture.supxlabel(style.plain("\n".join(foot)), fontsize=7.5, color=style.PALE)
    used = [group for group in GROUPS if any(line.group == group for line in lines)]
    style.legend_above(
        picture,
        [Line2D([], [], marker="o", linestyle="", color=GROUPS[g], markersize=4, label=g) for g in used],
    )
    return picture


def footer(run: Run) -> str:
    """Returns the date, the processors, the number of meshes and the command of the run."""
    ours = run.ours
    count = len(run.meshes)
    return (
        f"{ours['started'][:10]}, {' and '.join(run.processors)}, {count} mesh{'es' * (count > 1)}: "
        f"{command(run)}"
    )


def command(run: Run) -> str:
    """Returns the command that measures the same in the root of a checkout with the meshes: the recorded one, without
    its folder. Of a program that was started directly it is that of run_all.sh, which passes options on; of a
    merged run that of a part."""
    recorded = (run.ours.get("parts") or [run.ours])[0]["command"]
    try:
        words = shlex.split(recorded)
    except ValueError:  # of a version that recorded words without quotes
        words = recorded.split()
    if Path(words[0]).name == SCRIPT:
        return shlex.join(_without(words, {"--out", "--resume"}))
    plugins = run.ours.get("plugins", [])
    names = [Path(plugin["file"]).stem.removeprefix("lib") for plugin in plugins if "file" in plugin]
    known = {file.parent.name for file in (ROOT / "peers").glob("*/adapter.cpp")}
    at = words.index("run")
    rest = words[at + 1 :]
    if rest and not rest[0].startswith("-"):  # the file of a suite
        rest[:1] = ["--corpus", run.ours["corpus"]]
    options = _without(words[1:at] + rest, {"--out", "--resume", "--shard"})
    if names and known.issuperset(names):
        theirs = {solver for plugin in plugins for solver in plugin.get("solvers", [])}
        options = [_but(word, theirs) for word in _without(options, {"--plugin"})]
        options += ["--peers", "all" if known == set(names) else ",".join(names)]
    return shlex.join([f"./{SCRIPT}", *options])


def _without(words: Sequence[str], options: set[str]) -> list[str]:
    """Returns the words without these options and their values."""
    kept: list[str] = []
    skips = False
    for word in words:
        if not skips and word.partition("=")[0] not in options:
            kept.append(word)
        skips = not skips and word in options
    return kept


def _but(word: str, solvers: set[str]) -> str:
    """Returns a list of solvers without some."""
    return ",".join(name for name in word.split(",") if name.partition("?")[0] not in solvers)
