"""Writes docs/results.md with its pictures, and the tables of other pages, from the newest results of
each corpus in results/contributed/: what the project states about itself is measured. The command is

    /usr/bin/python3 -m plots.contributed
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from results import console

if __name__ == "__main__":
    console.prepare("plots.contributed")  # before imports that may fail

from plots import (
    break_even, catalogue, frontier, further_sources, headline, many_sources, path_costs, peers_overview, robustness,
    style, summary, twins,
)  # fmt: skip
from plots.drawing import Drawing
from plots.measures import ERROR, columns, errors_of, interval, percent
from plots.ratios import number
from results import pairs
from results.console import ROOT
from results.reader import ResultError, Run, read_run
from results.statistics import geometric_mean
from results.table import BLANK, Field, Table, estimate_field, to_markdown

FOLDER = ROOT / "results" / "contributed"
PAGE, README, PEERS = ROOT / "docs" / "results.md", ROOT / "README.md", ROOT / "docs" / "peers.md"
APPROXIMATE = ROOT / "docs" / "approximate.md"
RESULTS = {README: "docs/results.md", PEERS: "results.md", APPROXIMATE: "results.md"}
"""Link to the page of all results, by the page that contains the link."""
STANDARD, ROBUSTNESS, FRONTIER = "standard", "robustness", "frontier"
SETS, PATHS, ALL_PAIRS = "source-sets", "paths", "all-pairs"
PICTURES: dict[str, list[str]] = {
    STANDARD: ["peers_overview", "overview", "performance_profile"],
    FRONTIER: ["frontier"],
    ALL_PAIRS: ["break_even"],
    SETS: ["many_sources"],
    PATHS: ["paths_compared"],
    ROBUSTNESS: [],
}
"""Figures by corpus, in the order of the page; each is docs/NAME.png."""
TABLES: dict[str, list[Callable[[Run], Table]]] = {
    ALL_PAIRS: [further_sources.table, break_even.table], PATHS: [path_costs.table],
    ROBUSTNESS: [robustness.counts],
}  # fmt: skip
WORDS: dict[str, Callable[[Run], list[str]]] = {
    ALL_PAIRS: lambda run: [], PATHS: path_costs.sentences, ROBUSTNESS: lambda run: [],
}  # fmt: skip
"""Tables and sentences that replace the summary and the headline, by corpus."""
BASE = "edge-based"
PERCENT = 1e-4
"""Least relative error that is written in percent."""
SHOWN = {
    BASE: "this project",
    "vtp": "VTP, by its authors",
    "libigl-exact": "libigl",
    "gc-exact": "geometry-central",
    "cgal": "CGAL",
    "gc-heat": "geometry-central, heat method",
}
"""Solvers of README's table, with the name of the code."""
MARK = "<!-- Made by /usr/bin/python3 -m plots.contributed: {} -->\n"
END = "<!-- End -->"


def newest() -> dict[str, Run]:
    """Returns the newest run of each corpus. @raises ResultError if a corpus has no run"""
    runs = sorted((read_run(file) for file in FOLDER.glob("*.json.gz")), key=lambda run: str(run.ours["started"]))
    found = {str(run.ours["corpus"]): run for run in runs}
    if lacking := [corpus for corpus in PICTURES if corpus not in found]:
        raise ResultError(f"{FOLDER}: no result of {', '.join(lacking)}")
    return found


def beside_public_codes(standard: Run, hard: Run) -> Table:
    """Returns README's table, with one row per code."""
    right = robustness.right(hard)
    return Table(
        name="beside_public_codes", title="", text_columns=2,
        header=["Solver", "Code", f"Preparation and one solve, time / {BASE}", "Meshes",
                "Largest relative error", f"Correct on, of {len(hard.meshes)} hard meshes"],
        rows=[[Field(solver), Field(whose), *_numbers(standard, solver), Field(right[solver])]
              for solver, whose in SHOWN.items() if solver in columns(standard) and solver in right],
    )  # fmt: skip


def _numbers(run: Run, solver: str) -> list[Field]:
    samples = [one for mesh in run.meshes if (one := pairs.ratios(run, mesh, solver, BASE, pairs.first))]
    if not samples:
        return [BLANK, Field("0"), BLANK]
    mean = geometric_mean(samples)
    text = number(mean.value)
    if solver != BASE:
        text = interval(mean, number)
    largest = float(max(errors_of(run, solver)))
    return [estimate_field(mean, text), Field(f"{len(samples)} of {len(run.meshes)}"), Field(_error(largest))]


def _error(largest: float) -> str:
    return percent(largest) if largest >= PERCENT else ERROR.show(largest)


def inexact_solvers(run: Run) -> Table:
    """Returns the table of docs/approximate.md: times over those of edge-based, and errors, over all meshes."""
    points = frontier.over_meshes(run, list(run.meshes.values()), BASE)
    return Table(
        name="inexact_solvers", title="", text_columns=2,
        header=["Solver", "Promise", "First answer", "Each further", "Largest error", "Mean error"],
        rows=[[Field(point.solver.name), Field(point.solver.promise),
               Field(number(point.costs["1 source"].value)),
               Field(interval(point.costs["each further source"], number)),
               *(Field(percent(error) if error else "0") for error in (point.largest, point.mean))]
              for point in sorted(points, key=lambda point: point.costs["each further source"].value)],
    )  # fmt: skip


def prepared_solvers(run: Run) -> Table:
    """Returns the table of docs/approximate.md: straight-graph on every mesh, the other solvers on the horse."""
    whole = further_sources.table(run)
    rows = [row for row in whole.rows if row[0].text == "horse" or row[1].text == "straight-graph"]
    return replace(whole, name="prepared_solvers", rows=rows, remarks=[])


def tables(runs: Mapping[str, Run]) -> dict[Path, list[tuple[Table, Run]]]:
    """Returns, by page, the tables between the marks of that page, each with its run."""
    standard, sets = runs[STANDARD], runs[SETS]
    return {
        README: [(beside_public_codes(standard, runs[ROBUSTNESS]), standard)],
        PEERS: [(twins.overall(standard), standard), (many_sources.errors(sets), sets)],
        APPROXIMATE: [(inexact_solvers(runs[FRONTIER]), runs[FRONTIER]),
                      (prepared_solvers(runs[ALL_PAIRS]), runs[ALL_PAIRS])],
    }


def with_tables(page: Path, made: Sequence[tuple[Table, Run]]) -> str:
    """Returns the page's text with these tables. @raises ResultError if the marks of one are missing"""
    text = page.read_text("utf-8")
    for table, run in made:
        mark = MARK.format(table.name)
        before, found, rest = text.partition(mark)
        _, end, after = rest.partition(END)
        if not found or not end:
            raise ResultError(f"{page}: the marks of {table.name} are gone")
        plain = to_markdown(replace(table, title=""))
        text = f"{before}{mark}{plain}\n{peers_overview.footer(run)} ([all results]({RESULTS[page]})).\n{end}{after}"
    return text


def page(runs: Mapping[str, Run], captions: Mapping[str, tuple[str, str]]) -> str:
    """Returns the text of docs/results.md.

    @param captions title and caption of each figure"""
    parts = [
        "# Results\n\n"
        "The newest result of each corpus in `results/contributed/`. This page and its pictures are made by\n"
        "`/usr/bin/python3 -m plots.contributed`; [contribute one](contributed-results.md).\n"
    ]
    for corpus, names in PICTURES.items():
        run = runs[corpus]
        tables = [table(run) for table in TABLES.get(corpus, [summary.overall])]
        sentences = WORDS.get(corpus, headline.sentences)(run)
        parts.append(f"## {corpus}\n\n{peers_overview.footer(run)}, at {run.ours['revision'][:10]}\n"
                     f"([the file](../results/contributed/{run.file.name})).\n")  # fmt: skip
        parts += [f"{' '.join(sentences)}\n"] if sentences else []
        parts += [to_markdown(replace(table, title="")) for table in tables]
        for name in names:
            title, caption = captions[name]
            parts.append(f"![{title}]({_file(name).name})\n\n{caption}\n")
    return "\n".join(parts)


def _file(name: str) -> Path:
    return PAGE.with_name(f"{name.replace('_', '-')}.png")


def drawings(runs: Mapping[str, Run]) -> dict[str, Drawing]:
    """Returns the figures by name. @raises ResultError if a run lacks the data"""
    return {name: catalogue.FIGURES[name](runs[corpus]) for corpus, names in PICTURES.items() for name in names}


def main(arguments: Sequence[str] | None = None) -> int:
    console.Parser(__doc__).parse_args(arguments)
    try:
        runs = newest()
        found = drawings(runs)
        for name, drawing in found.items():
            style.save(drawing.figure, _file(name))
        captions = {name: (drawing.title, drawing.caption) for name, drawing in found.items()}
        pages = {file: with_tables(file, made) for file, made in tables(runs).items()}
        for file, text in (pages | {PAGE: page(runs, captions)}).items():
            file.write_text(text, encoding="utf-8")
            print(file)
    except (ResultError, OSError) as error:
        return console.complain(error)
    return 0


if __name__ == "__main__":
    sys.exit(main())
