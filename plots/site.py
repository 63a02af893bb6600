"""Static pages of many runs: a table of all results to sort and filter, a page a solver and a mesh,
accuracy against time, and the raw files. They are opened from disk, and need no server and no network.

Times of different processors are never in one ratio. A solver's history compares runs on one
processor, over the meshes and sources that they share.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import quote, unquote

from results import console

if __name__ == "__main__":
    console.prepare("geodesic-bench site")  # before imports that may fail

from plots.measures import (
    EDGE_BASED, ERROR, PEAK_BYTES, PROPAGATIONS, baseline, failure, interval_field, our_field,
    with_promise,
)  # fmt: skip
from plots.ratios import time_over
from plots.report import TEMPLATES, picture
from results import outcomes, pairs
from results.reader import Mesh, ResultError, Run, Solver, Source, read_run
from results.statistics import Estimate, geometric_mean_of_ratios, median
from results.table import (
    BLANK, Field, Table, estimate_field, four_digits, mark, without_constant_columns,
)  # fmt: skip

if TYPE_CHECKING:
    from plots.drawing import Drawing

HERE = Path(__file__).resolve().parent
SHARED = ("report.css", "report.js", "site.js")
COLUMNS = [
    "Mesh", "Solver", "Run", "Processor", "Revision", "Date", "Time (ms)", "Time / base",
    "Time / dijkstra", "Largest error", "Windows", "Memory (MB)", "Vertices", "Sources",
]  # fmt: skip
TEXTS, KEPT = 6, 3
"""Number of columns of texts; number of columns that stay even if all their rows are equal."""


DIJKSTRA = "dijkstra"
"""Solver whose times are the unit for comparisons between machines."""
CHOSEN, FEW = "chosen", 4
"""Corpus of a run with --meshes; number of its meshes that are named."""


@dataclass(frozen=True)
class Shown:
    """A run and the texts that the pages show for it."""

    run: Run
    name: str
    """Name of its folder below runs/."""

    label: str
    """Name for users: that of the run's folder or, if its file is not run.json, of the file."""

    @property
    def raw(self) -> str:
        return f"runs/{quote(self.name)}/run.json"

    @property
    def date(self) -> str:
        return str(self.run.ours["started"])[:10]

    @property
    def revision(self) -> str:
        return str(self.run.ours["revision"])[:10] + ("+" if self.run.ours["modified"] else "")


@dataclass(frozen=True)
class Entry:
    """Results of a solver on a mesh, in a run, on one processor."""

    shown: Shown
    run: Run
    """The part of the run that this processor measured."""
    processor: str
    mesh: Mesh
    solver: Solver


def shown(runs: Iterable[Run]) -> list[Shown]:
    """Gives each run a name and a label, and returns them, the oldest first."""
    named: list[Shown] = []
    for run in sorted(runs, key=lambda one: str(one.ours["started"])):
        name = str(run.ours["started"]).replace(":", "").replace("-", "")
        same = sum(other.name.split("_")[0] == name for other in named)
        label = run.file.resolve().parent.name if run.file.name == "run.json" else run.file.stem
        alike = sum(other.label.split(" (")[0] == label for other in named)
        named.append(
            Shown(run, f"{name}_{same + 1}" if same else name, f"{label} ({alike + 1})" if alike else label)
        )
    return named


def entries(runs: Sequence[Shown]) -> list[Entry]:
    found = []
    for one in runs:
        for processor in one.run.processors:
            part = one.run.of_processor(processor)
            found += [
                Entry(one, part, processor, mesh, solver)
                for mesh in part.meshes.values()
                for solver in one.run.solvers.values()
                if part.cell(mesh.name, solver.name)
            ]
    return found


def newest_first(entries: Sequence[Entry]) -> list[Entry]:
    runs = list(dict.fromkeys(entry.shown.name for entry in entries))
    return sorted(entries, key=lambda entry: -runs.index(entry.shown.name))


def mesh_page(mesh: Mesh) -> str:
    """Returns the page of a mesh. Different files with the same mesh name have separate pages."""
    return f"meshes/{quote(quote(mesh.name, safe=''))}-{mesh.sha256[:8]}.html"


def solver_page(solver: Solver) -> str:
    return f"solvers/{quote(quote(solver.name, safe=''))}.html"


def row(entry: Entry, root: str) -> list[Field]:
    """@param root path from the page to the site's folder"""
    run, mesh, solver = entry.run, entry.mesh, entry.solver
    texts = [
        Field(mesh.name, link=root + mesh_page(mesh)),
        Field(with_promise(solver), link=root + solver_page(solver)),
        Field(entry.shown.label, link=root + entry.shown.raw),
        Field(entry.processor),
        Field(entry.shown.revision),
        Field(entry.shown.date),
    ]
    sources = len(run.sources.get(mesh.name, []))
    sizes = [Field(f"{n:,}", n) for n in (mesh.vertices, sources)]
    times = pairs.by_source(pairs.times(run, mesh.name, solver.name))
    if not times:
        return [*texts, failure(run, mesh.name, solver.name) or BLANK, *[BLANK] * 5, *sizes]
    time = median(times)
    ratio = time_over(baseline(run, EDGE_BASED)).field(run, mesh.name, solver.name)
    measured = [our_field(run, mesh.name, solver.name, m) for m in (ERROR, PROPAGATIONS, PEAK_BYTES)]
    return [*texts, estimate_field(time, four_digits(1e3 * time.value)), ratio, _over_dijkstra(entry), *measured, *sizes]


def _over_dijkstra(entry: Entry) -> Field:
    """Returns the ratio to Dijkstra's time, with its interval in the title that a pointer shows."""
    if DIJKSTRA not in entry.run.solvers:
        return BLANK
    field = time_over(DIJKSTRA).field(entry.run, entry.mesh.name, entry.solver.name)
    return replace(field, text=field.text.split(" [")[0], title=field.text)


def results(name: str, title: str, entries: Sequence[Entry], root: str) -> Table:
    return without_constant_columns(Table(
        name=name, title=title, header=COLUMNS, text_columns=TEXTS,
        rows=[row(entry, root) for entry in entries],
        remarks=[
            "CPU time of one solve without preparation, window propagations, measured peak memory of "
            "the solver: medians over sources and repetitions. The base of a run's ratios is "
            f"{EDGE_BASED}, or the first exact solver where it was not measured; ratios are paired by "
            "source and repetition, with 95% intervals. Times of different processors cannot be compared. "
            f"Their ratios to the times of {DIJKSTRA} in the same run and from the same source can. A "
            "revision with a + was modified.",
        ],
    ), KEPT)  # fmt: skip


def runs_table(runs: Sequence[Shown]) -> Table:
    rows = []
    for one in runs:
        ours = one.run.ours
        failed = len(outcomes.failures(one.run))
        chosen = ours["corpus"] == CHOSEN
        corpus = ", ".join(outcomes.first(list(one.run.meshes), FEW)) if chosen else ours["corpus"]
        texts = [one.date, corpus, one.revision, ", ".join(one.run.processors), ours["compiler"]]
        rows.append(
            [
                Field(one.label, link=one.raw),
                *(Field(text) for text in texts),
                *(Field(f"{n:,}", n) for n in (len(one.run.meshes), len(one.run.solvers))),
                *(Field(f"{n:,}", n) for n in (outcomes.verified(one.run), failed)),
            ]
        )
    return Table(
        name="runs", title="Runs",
        header=["Run", "Date", "Corpus or meshes", "Revision", "Processor", "Compiler", "Meshes", "Solvers",
                "Cells verified", "Failed or missing"],
        text_columns=6, rows=rows,
    )  # fmt: skip


@dataclass(frozen=True)
class Step:
    """Ratio of a solver's times in a run to those in the first run on the same processor."""

    shown: Shown
    processor: str
    shared: int
    """Cells that both runs have."""
    ratio: Estimate


def history(entries: Sequence[Entry]) -> list[Step]:
    """@param entries of one solver, the oldest run first"""
    times: dict[str, dict[str, dict[tuple[str, Source], list[float]]]] = {}
    runs = {entry.shown.name: entry.shown for entry in entries}
    for entry in entries:
        cells = times.setdefault(entry.processor, {}).setdefault(entry.shown.name, {})
        measured = pairs.times(entry.run, entry.mesh.name, entry.solver.name)
        for (source, _), time in measured.items():
            cells.setdefault((entry.mesh.sha256, source), []).append(time)
    steps = []
    for processor, by_run in times.items():
        first: dict[tuple[str, Source], list[float]] = next(filter(None, by_run.values()), {})
        for name, cells in by_run.items():
            shared = [(before, cells[cell]) for cell, before in first.items() if cell in cells]
            if not shared:
                continue
            steps.append(Step(runs[name], processor, len(shared), geometric_mean_of_ratios(shared)))
    return steps


def history_table(steps: Sequence[Step]) -> Table:
    return Table(
        name="history", title="History",
        header=["Processor", "Run", "Date", "Revision", "Cells in common", "Time / the first run's"],
        text_columns=4,
        rows=[
            [
                Field(step.processor), Field(step.shown.label, link=f"../{step.shown.raw}"),
                Field(step.shown.date), Field(step.shown.revision), Field(f"{step.shared:,}", step.shared),
                interval_field(step.ratio, "{:.3f}".format),
            ]
            for step in steps
        ],
        remarks=[
            "Geometric mean over meshes and sources that a run shares with the first one on the same "
            "processor, with a 95% interval. The runs were not interleaved: other load of the machine "
            "affects the ratio."
        ],
    )  # fmt: skip


def history_figure(solver: str, steps: Sequence[Step]) -> Drawing | None:
    """Returns a figure of the steps, or None if no processor has two runs."""
    from plots import style
    from plots.drawing import Drawing

    by_processor: dict[str, list[Step]] = {}
    for step in steps:
        by_processor.setdefault(step.processor, []).append(step)
    lines = {processor: of for processor, of in by_processor.items() if len(of) > 1}
    if not lines:
        return None
    figure = style.new_figure(2.8)
    axes = figure.add_subplot()
    names = list(dict.fromkeys(step.shown.name for of in lines.values() for step in of))
    for look, (processor, of) in zip(
        style.solver_styles(lines).values(), lines.items(), strict=True
    ):
        x = [names.index(step.shown.name) for step in of]
        ratios = [step.ratio for step in of]
        axes.errorbar(
            x, [ratio.value for ratio in ratios], yerr=style.bars(ratios), color=look.color, marker=look.marker,
            capsize=3, label=style.plain(processor),
        )  # fmt: skip
    labels = {step.shown.name: f"{step.shown.revision}\n{step.shown.date}" for step in steps}
    axes.set_xticks(range(len(names)), [style.plain(labels[name]) for name in names])
    axes.set_ylabel("Time / the first run's")
    axes.axhline(1, color=style.PALE, linewidth=0.7)
    axes.set_ylim(bottom=0)
    handles, _ = axes.get_legend_handles_labels()
    style.legend_above(figure, handles)
    return Drawing(
        f"{solver} over revisions",
        "Each line is a processor: times of a run over those of its first run, geometric mean over the "
        "meshes and sources that both have, with 95% intervals.",
        figure,
    )


class Site:
    """Writes pages into a folder."""

    def __init__(self, folder: Path, pages: Mapping[str, str]) -> None:
        """@param pages titles, by file, of the pages that every page links to"""
        self.folder = folder
        self.pages = pages

    def write(
        self, file: str, title: str, summary: Sequence[str], tables: Sequence[Table] = (),
        facts: Mapping[str, object] | None = None, drawings: Mapping[str, Drawing] | None = None,
    ) -> None:  # fmt: skip
        """@param file relative to the site's folder, quoted as in a link"""
        from plots import style
        from plots.drawing import Picture

        path = self.folder / unquote(file)
        path.parent.mkdir(parents=True, exist_ok=True)
        root = "../" * file.count("/")
        pictures: dict[str, Any] = {}
        with tempfile.TemporaryDirectory() as figures:
            for name, one in (drawings or {}).items():
                png = Path(figures) / f"{name}.png"
                style.save(one.figure, png)
                pictures[name] = picture(Picture.of(one, png))
        page = TEMPLATES.get_template("site.html").render(
            title=title, summary=summary, root=root, pages=self.pages, tables={table.name: table for table in tables},
            facts=facts or {}, pictures=pictures, mark=mark,
        )  # fmt: skip
        path.write_text(page, encoding="utf-8")


def write_site(runs: Sequence[Shown], folder: Path) -> None:
    """@raises ResultError, OSError"""
    of_all, without = every_frontier(runs)
    pages = {"index.html": "All results"} | ({"frontier.html": "Accuracy against time"} if of_all else {})
    site = Site(folder, pages)
    every = entries(runs)
    for one in runs:
        raw = folder / "runs" / one.name
        raw.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(one.run.file, raw / "run.json")
        if one.run.rows_file:
            shutil.copyfile(one.run.rows_file, raw / one.run.rows_file.name)
    for name in SHARED:
        shutil.copyfile(HERE / name, folder / name)
    solvers = {entry.solver.name: entry.solver for entry in every}
    meshes = {entry.mesh.sha256: entry.mesh for entry in every}
    processors = dict.fromkeys(entry.processor for entry in every)
    revisions = dict.fromkeys(one.revision for one in runs)
    summary = [
        f"Runs: {len(runs)}. Revisions: {len(revisions)}. Processors: {len(processors)}. Solvers: "
        f"{len(solvers)}. Meshes: {len(meshes)}. Only times of solvers whose distances were verified "
        "are shown; every line has its raw file."
    ]
    site.write(
        "index.html", "Geodesic distances: all results", summary,
        [results("results", "Results", newest_first(every), ""), runs_table(runs)],
    )  # fmt: skip
    for name, solver in solvers.items():
        of = [entry for entry in every if entry.solver.name == name]
        steps = history(of)
        figure = history_figure(name, steps)
        site.write(
            solver_page(solver), name, [solver.remarks] if solver.remarks else [],
            [results("results", "Results", newest_first(of), "../"), history_table(steps)],
            facts_of(of[-1].solver), {"history": figure} if figure else {},
        )  # fmt: skip
    for mesh in meshes.values():
        of = [entry for entry in every if entry.mesh.sha256 == mesh.sha256]
        latest = of[-1].mesh
        facts = {
            "Vertices": f"{latest.vertices:,}", "Faces": f"{latest.faces:,}",
            "Mean edge": f"{latest.mean_edge_length:.6g}", "SHA-256 of the file": latest.sha256,
        }  # fmt: skip
        site.write(
            mesh_page(mesh), latest.name, [latest.why] if latest.why else [],
            [results("results", "Results", newest_first(of), "../")], facts, frontiers(of),
        )  # fmt: skip
    if of_all:
        site.write(
            "frontier.html", pages["frontier.html"],
            ["One figure for each run with solvers that are not exact, the newest first.",
             *(f"No figure of the run of {why}." for why in without)],
            drawings=of_all,
        )  # fmt: skip


def every_frontier(runs: Sequence[Shown]) -> tuple[dict[str, Drawing], list[str]]:
    """Returns the frontiers of all runs, the newest first, and the reasons why other runs have none."""
    found: dict[str, Drawing] = {}
    without: list[str] = []
    for number, one in enumerate(reversed(runs), 1):
        try:
            found |= frontier(f"run_{number}", one.run, one)
        except ResultError as error:
            without.append(f"{one.label}: {str(error).removeprefix(f'{one.run.file}: ')}")
    return found, without


def facts_of(solver: Solver) -> dict[str, object]:
    facts = {"Family": solver.family, "Paper": solver.paper, "Answers": solver.promise}
    return {key: fact for key, fact in facts.items() if fact}


def frontiers(entries: Sequence[Entry]) -> dict[str, Drawing]:
    """Returns the frontiers of one mesh from the newest run that has one; empty without one."""
    for newest in dict.fromkeys(entry.shown.name for entry in reversed(entries)):
        entry = next(entry for entry in entries if entry.shown.name == newest)
        try:
            return frontier("frontier", entry.shown.run.of_meshes([entry.mesh.name]), entry.shown)
        except ResultError:
            continue
    return {}


def frontier(name: str, run: Run, shown: Shown) -> dict[str, Drawing]:
    """Returns a figure per processor. @raises ResultError if the run lacks the data"""
    from plots import catalogue

    drawn, left_out = catalogue.draw(run, ["frontier"])
    found = {
        f"{name}_{number}": replace(one, title=f"{one.title}; {shown.label}")
        for number, (part, one) in enumerate(drawn.items(), 1)
        if catalogue.OF not in part
    }
    if not found:
        raise ResultError(next(iter(left_out.values())))
    return found  # type: ignore[return-value]  # of a figure's name there are figures only


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.Parser(
        __doc__, "geodesic-bench site results/runs/* --out site",
        "geodesic-bench site mine.json theirs.json --out site",
    )  # fmt: skip
    parser.add_argument("runs", nargs="+", type=Path, metavar="RUN", help="run folder or run.json")
    parser.add_argument("--out", type=Path, metavar="DIR", default=Path("site"), help="default: site")
    options = parser.parse_args(arguments)
    try:
        runs = shown(read_run(path).of_single_sources for path in options.runs)
        write_site(runs, options.out)
        console.say(str(options.out / "index.html"))
    except (ResultError, OSError) as error:
        return console.complain(error)
    return 0


if __name__ == "__main__":
    sys.exit(main())
