"""Draws all tables and figures of a run and writes them to one self-contained page: RUN/report.html."""

from __future__ import annotations

import base64
import shlex
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from results import console

if __name__ == "__main__":
    console.prepare("geodesic-bench report")  # before imports that may fail

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from plots import headline
from plots.catalogue import base_name, draw_files
from results import environment, outcomes
from results.reader import ResultError, Run, read_run, run_folder
from results.table import Table, mark

if TYPE_CHECKING:
    from plots.drawing import Picture

TEMPLATES = Environment(
    loader=FileSystemLoader(Path(__file__).resolve().parent), autoescape=True,
    undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True,
)  # fmt: skip
CSS_DPI = 96
SECTION_OF = {"summary_by_mesh": "results", "table_thesis": "thesis", "times": "long", "every_solver": "long",
              "summary": "long"}  # fmt: skip
"""Section of a table; other tables are in "tables"."""
FIRST = ("peers_overview", "overview")
"""Figures that come before all others."""
FEW = 4
"""Largest number of meshes that the title names; the others are counted."""


def page(run: Run, drawn: Mapping[str, Table | Picture], left_out: Mapping[str, str]) -> str:
    places = SECTION_OF | ({} if "summary_by_mesh" in map(base_name, drawn) else {"summary": "results"})
    tables: dict[str, dict[str, Table]] = {}
    pictures = {}
    for name, one in drawn.items():
        if isinstance(one, Table):
            tables.setdefault(places.get(base_name(name), "tables"), {})[name] = one
        else:
            pictures[name] = picture(one)
    sections = {
        "results": "Results" if "results" in tables or pictures.keys() & set(FIRST) else "",
        "thesis": "Compared with the thesis" if "thesis" in tables else "",
        "long": "Every solver on every mesh" if "long" in tables else "",
        "figures": "Figures" if pictures.keys() - set(FIRST) else "",
        "tables": "Tables" if "tables" in tables else "",
        "cells": "Cells",
        "machine": "Machine and revision",
        "reproduce": "How to reproduce",
    }
    folder = _folder(run)
    return TEMPLATES.get_template("report.html").render(
        title=_title(run),
        about=_about(run),
        headline=headline.sentences(run),
        sections={key: title for key, title in sections.items() if title},
        tables=tables,
        first={name: one for name, one in pictures.items() if name in FIRST},
        pictures={name: one for name, one in pictures.items() if name not in FIRST},
        checked=outcomes.checked_against_truth(run).capitalize(),
        failed=outcomes.first(outcomes.failures(run)),
        errors=outcomes.largest_errors(run),
        without_a_time=list(outcomes.reasons(run).values()),
        skipped=outcomes.first(outcomes.skipped(run)),
        machine=_machine(run),
        commands={
            "The run itself, that is run.json and cells/": run.ours["command"],
            "Every table and figure, and this page": f"geodesic-bench report {folder}",
            "Whether every cell is there and verified": f"geodesic-bench check {folder}",
        },
        left_out=[
            f"{name}: {why.removeprefix(f'{run.file}: ')}" for name, why in left_out.items()
        ],
        drawn_by=lambda name: f"python3 -m plots {base_name(name)} --run {folder}",
        mark=mark,
    )


def picture(one: Picture) -> dict[str, Any]:
    """Returns the data of a figure for the macro one_figure of parts.html."""
    width, height = (round(CSS_DPI * inches) for inches in one.inches)
    return {
        "title": one.title, "caption": one.caption, "width": width, "height": height,
        "png": base64.b64encode(one.png.read_bytes()).decode("ascii"),
    }  # fmt: skip


def _title(run: Run) -> str:
    about = ", ".join(list(run.meshes)[:FEW])
    if len(run.meshes) > FEW:
        about += f" and {len(run.meshes) - FEW} more"
    return f"Geodesic distances: {about}; {run.ours['started'][:10]}"


def _folder(run: Run) -> str:
    """Returns the run's folder as an argument of a command in the root of the checkout."""
    folder, root = run.file.parent.resolve(), console.ROOT
    return shlex.quote(str(folder.relative_to(root) if folder.is_relative_to(root) else folder))


def _about(run: Run) -> str:
    ours = run.ours
    stand_ins = sum(mesh.stand_in for mesh in run.meshes.values())
    return (
        f"Solvers: {len(run.solvers)}. Meshes: {len(run.meshes)}"
        + (f", stand-ins among them: {stand_ins}" if stand_ins else "")
        + f". Measured on {ours['started'][:10]}, {_processors(run)}; revision "
        f"{ours['revision'][:10]}. Only times of answers that were verified are shown."
    )


def _processors(run: Run) -> str:
    if len(run.processors) < 2:
        return f"{run.ours['processor']}, {run.context['num_cpus']} cores seen"
    counts = {name: run.columns.where("processor", name).sum() for name in run.processors}
    return "; ".join(f"{name} ({count} rows)" for name, count in counts.items())


def _environment(run: Run) -> dict[str, str]:
    found = environment.of_machine(run.environments)
    load = environment.load(run)
    if load is not None:
        found["load at the start"] = f"{load:.1f}"
    if differences := environment.within(run):
        found["environments of its parts"] = "; ".join(differences)
    return {words.capitalize(): text for words, text in found.items()}


def _machine(run: Run) -> dict[str, object]:
    ours = run.ours
    modified = {True: ", modified", False: "", None: ", perhaps modified"}[ours["modified"]]
    library = run.context["library_build_type"]
    if library == "debug":
        library = (
            "library_build_type: debug, as Debian's package always reports. It is about the library "
            "that calls the solvers and not about the solvers, whose build type is above."
        )
    return {
        "Revision": ours["revision"] + modified,
        "Started": ours["started"],
        "Finished": ours["finished"],
        "Processor": _processors(run),
        **_environment(run),
        "Compiler": f"{ours['compiler']} {ours['compiler_flags']}",
        "Build type": ours["build_type"],
        "Google Benchmark": library,
        "Seed of the sources": ours["seed"],
        "Sources a mesh": max(map(len, run.sources.values()), default=0),
        "Repetitions": ours["repetitions"],
    }


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.run_parser(
        __doc__, "geodesic-bench report", "geodesic-bench report results/runs/mine"
    )
    options = parser.parse_args(arguments)
    try:
        folder = run_folder(options.run)
        run = read_run(folder)
        drawn, left_out = draw_files(run, folder)
        file = folder / "report.html"
        file.write_text(page(run, drawn, left_out), encoding="utf-8")
        if left_out:
            print(f"left out: {len(left_out)} tables and figures; the page says why")
        print(file)
    except (ResultError, OSError) as error:
        return console.complain(error)
    return 0


if __name__ == "__main__":
    sys.exit(main())
