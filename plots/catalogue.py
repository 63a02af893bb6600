"""All tables and figures by name, and the functions that draw them from a run."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

from results import table
from results.console import StatusLine
from results.published import APPENDIX
from results.reader import ResultError, Run
from results.table import Table

if TYPE_CHECKING:
    from plots.drawing import Drawing, Picture


def _of(place: str) -> Callable[[Run], Any]:
    """Returns a function that imports what it draws. @param place "summary.overall" of plots/"""
    module, name = place.split(".")

    def draw(run: Run) -> Any:
        return getattr(import_module(f"plots.{module}"), name)(run)

    return draw


def _wavefront_of(solver: str) -> Callable[[Run], Drawing]:
    def draw(run: Run) -> Drawing:
        from plots.wavefronts import appendix

        return appendix(solver)(run)

    return draw


TABLES: dict[str, Callable[[Run], Table]] = {
    "summary": _of("summary.overall"),
    "summary_by_mesh": _of("summary.by_mesh"),
    "times": _of("summary.times"),
    "every_solver": _of("summary.every"),
    "table_thesis": _of("table_thesis.table"),
    "strip_depth": _of("strip_depth.table"),
    "performance": _of("performance.table"),
    "ratios": _of("ratio_tables.ratios"),
    "claims": _of("ratio_tables.claims"),
    "solvers": _of("solvers.table"),
    "table_growth": _of("growth.table"),
    "table_growth_exponents": _of("growth.exponents"),
    "answers": _of("answers.table"),
    "many_sources_numbers": _of("many_sources.table"),
    "many_sources_errors": _of("many_sources.errors"),
    "path_costs": _of("path_costs.table"),
    "path_numbers": _of("path_costs.by_mesh"),
    "further_sources": _of("further_sources.table"),
    "twins": _of("twins.table"),
    "twins_overall": _of("twins.overall"),
    "break_even_numbers": _of("break_even.table"),
    "which_to_take": _of("frontier.which_to_take"),
    "which_to_take_mean": _of("frontier.which_to_take_mean"),
    "robustness": _of("robustness.matrix"),
    "robustness_counts": _of("robustness.counts"),
    "robustness_failures": _of("robustness.failures"),
}
FIGURES: dict[str, Callable[[Run], Drawing]] = {
    "peers_overview": _of("peers_overview.figure"),
    "overview": _of("overview.figure"),
    "performance_profile": _of("performance_profile.figure"),
    "speedup": _of("dot_figures.speedup"),
    "windows_over_limit": _of("dot_figures.windows_over_limit"),
    "time_over_vertices": _of("growth.figure"),
    "accuracy": _of("dot_figures.accuracy"),
    "wavefront_and_isoline": _of("wavefronts.wavefront_and_isoline"),
    "windows_on_wavefront": _of("curves.windows"),
    "phases": _of("phases.figure"),
    "wavefront_quality": _of("dot_figures.wavefront_quality"),
    "wavefront_quality_over_progress": _of("curves.spread"),
    "isolines": _of("isoline_figure.figure"),
    "paths": _of("paths.figure"),
    "cells": _of("paths.cells"),
    "break_even": _of("break_even.figure"),
    "frontier": _of("frontier.figure"),
    "many_sources": _of("many_sources.figure"),
    "paths_compared": _of("path_costs.figure"),
    "error_map": _of("error_map.figure"),
    **{f"wavefront_{solver.replace('-', '_')}": _wavefront_of(solver) for solver in APPENDIX},
}
"""Figures in the order of the report. A function raises ResultError if the run lacks the data."""

BY_MESH = {"frontier"}
"""Figures that are also drawn for each mesh of a run with several meshes."""
OF = "_of_"
"""Separates a figure's name from the name of a mesh, also in file names."""

EVERYTHING: dict[str, Callable[[Run], Table | Drawing]] = {**TABLES, **FIGURES}
WITH_SECONDS = {
    "summary_by_mesh", "times", "every_solver", "table_thesis", "performance", "table_growth",
    "table_growth_exponents", "answers", "break_even_numbers", "phases", "time_over_vertices",
    "break_even", "frontier", "which_to_take", "which_to_take_mean", "path_numbers",
}  # fmt: skip
"""Tables and figures that show times, which one processor must have measured. The others show counts,
errors, and ratios of times that one processor measured on one source."""

OF_SETS = {
    "summary", "accuracy", "many_sources", "many_sources_errors", "many_sources_numbers", "robustness", "robustness_counts",
    "robustness_failures",
}  # fmt: skip
"""Tables and figures that show sets of sources. The others show single vertices, if the run has any."""


def base_name(name: str) -> str:
    """Returns the name in EVERYTHING, without mesh."""
    return name.split(OF)[0]


def _parts(run: Run, name: str) -> dict[str, Run]:
    """Returns the runs that a name is drawn of, by full name."""
    parts = {name: run}
    if name in BY_MESH and len(run.meshes) > 1:
        parts |= {f"{name}{OF}{quote(m, safe='')}": run.of_meshes([m]) for m in run.meshes}
    return parts


def _on_one_processor(run: Run) -> Run:
    """Returns the run. @raises ResultError if several processors measured it"""
    if len(run.processors) > 1:
        raise ResultError(
            f"{run.file}: times in seconds of several processors, {', '.join(run.processors)}: "
            "choose meshes of one with --meshes"
        )
    return run


def draw(run: Run, names: Sequence[str] = ()) -> tuple[dict[str, Table | Drawing], dict[str, str]]:
    """Returns the tables and figures for which the run has the data, and the reasons for those left out.
    Both are by name; a figure of one mesh has a name like "frontier_of_horse".

    @param names keys of EVERYTHING; empty: all
    @raises ResultError for a run of several programs"""
    if len(run.columns.texts.get("program", ())) > 1:
        raise ResultError(f"{run.file}: a run of several programs; the gate compares them")
    drawn: dict[str, Table | Drawing] = {}
    left_out: dict[str, str] = {}
    for one in names or EVERYTHING:
        shown = run if one in OF_SETS else run.of_single_sources
        for name, part in _parts(shown, one).items():
            try:
                drawn[name] = EVERYTHING[one](_on_one_processor(part) if one in WITH_SECONDS else part)
            except ResultError as error:
                if OF not in name or str(error) not in left_out.values():
                    left_out[name] = str(error)
    return drawn, left_out


@dataclass(frozen=True)
class Files:
    """Tables and figures that have been written, the reasons for those left out, and lines that name the files."""

    written: dict[str, Table | Picture]
    left_out: dict[str, str]
    lines: list[str]


def draw_files(
    run: Run, folder: Path, names: Sequence[str] = (), out: Path | None = None
) -> tuple[dict[str, Table | Picture], dict[str, str]]:
    """As `draw`, and writes each table and figure in every format: tables to FOLDER/tables and figures to
    FOLDER/figures, or all to `out`. All processors of the machine draw. Prints
    the name of the first file of each, and shows on a terminal what is being drawn."""
    each = list(names) or list(EVERYTHING)
    processes = min(len(each), os.cpu_count() or 1)
    draw_one = partial(_draw_files, run, folder, out)
    written: dict[str, Table | Picture] = {}
    left_out: dict[str, str] = {}
    with ExitStack() as stack:
        parts: Iterable[Files] = map(draw_one, each)
        if processes > 1:
            # Not forked: a process that imported NumPy may have threads.
            pool = ProcessPoolExecutor(processes, get_context("spawn"))
            parts = stack.enter_context(pool).map(draw_one, each)
        status = stack.enter_context(StatusLine())
        left = iter(parts)
        for number, name in enumerate(each, start=1):
            status.show(f"drawing {number} of {len(each)}: {name}")
            part = next(left)
            status.clear()
            for line in part.lines:
                print(line)
            written |= part.written
            left_out |= part.left_out
    return written, left_out


def _draw_files(run: Run, folder: Path, out: Path | None, name: str) -> Files:
    drawn, left_out = draw(run, [name])
    written: dict[str, Table | Picture] = {}
    lines = []
    for name, one in drawn.items():
        if isinstance(one, Table):
            written[name] = one
            files = table.write(one, out or folder / "tables")
        else:
            from plots import drawing

            written[name], files = drawing.write(one, name, out or folder / "figures")
        lines.append(f"{files[0]} (also {', '.join(dict.fromkeys(file.suffix for file in files[1:]))})")
    return Files(written, left_out, lines)
