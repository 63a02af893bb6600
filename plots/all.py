#!/usr/bin/python3
"""Every table and figure that can be drawn from a run folder, and a line for each that cannot."""

from __future__ import annotations

import sys
from dataclasses import dataclass

import console  # noqa: F401  first: it tells what cannot be imported

import accuracy
import figure_5_7
import figure_5_8
import figure_5_9
import figure_5_10
import figure_5_10_curve
import figure_6_4
import figure_a_1
import figure_a_2
import figure_a_3
import figure_a_4
import figure_a_5
import overview
import speedup
import table_5_1
import table_5_2
import table_5_2_ratios
import table_5_3
import table_growth
import time_over_vertices
import windows_over_limit
from command_line import draw_by, drawing_parser
from drawing import Drawing
from results import ResultError, Run
from table import Table

TABLES = [table_5_1, table_5_2, table_5_2_ratios, table_5_3, table_growth]
FIGURES = [
    overview, figure_5_7, figure_5_8, figure_5_9, figure_5_10, figure_5_10_curve, figure_6_4,
    speedup, windows_over_limit, time_over_vertices, accuracy,
    figure_a_1, figure_a_2, figure_a_3, figure_a_4, figure_a_5,
]  # fmt: skip
"""In the order in which the report shows them."""


@dataclass(frozen=True)
class Item:
    command: str
    """Of plots/, draws it alone."""
    drawn: Table | Drawing


@dataclass(frozen=True)
class LeftOut:
    command: str
    why: str


def everything(run: Run) -> tuple[list[Item], list[LeftOut]]:
    """What the run has the data for, and what it has not."""
    items, left_out = [], []
    makers = [(m, m.tables) for m in TABLES] + [(m, m.figures) for m in FIGURES]
    for module, make in makers:
        command = f"{module.__name__}.py"
        try:
            items += [Item(command, drawn) for drawn in make(run)]
        except ResultError as error:
            left_out.append(LeftOut(command, str(error)))
    return items, left_out


def drawn(run: Run) -> list[Table | Drawing]:
    """The same without the names, having said what is left out."""
    items, left_out = everything(run)
    for one in left_out:
        print(f"left out: {one.command}: {one.why}")
    return [item.drawn for item in items]


if __name__ == "__main__":
    sys.exit(draw_by(drawing_parser(__doc__).parse_args(), drawn))
