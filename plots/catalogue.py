"""The list of all tables and figures, and drawing them from a run."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from plots import (
    accuracy,
    drawing,
    figure_5_7,
    figure_5_8,
    figure_5_9,
    figure_5_10,
    figure_5_10_curve,
    figure_6_4,
    figure_a_1,
    figure_a_2,
    figure_a_3,
    figure_a_4,
    figure_a_5,
    overview,
    speedup,
    table_5_1,
    table_5_2,
    table_5_2_ratios,
    table_5_3,
    table_growth,
    time_over_vertices,
    windows_over_limit,
)
from plots.drawing import Drawing
from results import table
from results.reader import ResultError, Run
from results.table import Table

Make = Callable[[Run], Sequence[Table | Drawing]]
"""@raises ResultError when the run lacks the data"""

TABLES: dict[str, Make] = {
    "table_5_1": table_5_1.tables,
    "table_5_2": table_5_2.tables,
    "table_5_2_ratios": table_5_2_ratios.tables,
    "table_5_3": table_5_3.tables,
    "table_growth": table_growth.tables,
}
FIGURES: dict[str, Make] = {
    "overview": overview.figures,
    "figure_5_7": figure_5_7.figures,
    "figure_5_8": figure_5_8.figures,
    "figure_5_9": figure_5_9.figures,
    "figure_5_10": figure_5_10.figures,
    "figure_5_10_curve": figure_5_10_curve.figures,
    "figure_6_4": figure_6_4.figures,
    "speedup": speedup.figures,
    "windows_over_limit": windows_over_limit.figures,
    "time_over_vertices": time_over_vertices.figures,
    "accuracy": accuracy.figures,
    "figure_a_1": figure_a_1.figures,
    "figure_a_2": figure_a_2.figures,
    "figure_a_3": figure_a_3.figures,
    "figure_a_4": figure_a_4.figures,
    "figure_a_5": figure_a_5.figures,
}
"""In the order in which the report shows them."""

EVERYTHING = TABLES | FIGURES


@dataclass(frozen=True)
class Item:
    name: str
    """In EVERYTHING."""
    drawn: Table | Drawing


@dataclass(frozen=True)
class LeftOut:
    name: str
    why: str


def draw(run: Run, names: Sequence[str] = ()) -> tuple[list[Item], list[LeftOut]]:
    """What the run has the data for, and what it has not.

    @param names of EVERYTHING; empty: all of it"""
    items, left_out = [], []
    for name in names or EVERYTHING:
        try:
            items += [Item(name, drawn) for drawn in EVERYTHING[name](run)]
        except ResultError as error:
            left_out.append(LeftOut(name, str(error)))
    return items, left_out


def write(drawn: Table | Drawing, run_folder: Path, out: Path | None = None) -> None:
    """Writes it in every format and prints the file's name."""
    if isinstance(drawn, Table):
        file, *others = table.write(drawn, out or run_folder / "tables")
    else:
        file, *others = drawing.write(drawn, out or run_folder / "figures")
    print(f"{file} (also {', '.join(other.suffix for other in others)})")
