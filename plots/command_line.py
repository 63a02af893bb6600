"""What every table's and figure's own command has in common: --run DIR [--out DIR]."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NoReturn

import drawing
import table
from console import complain, printable
from drawing import Drawing
from results import ResultError, Run, newest_run, read_run
from table import Table


class Parser(argparse.ArgumentParser):
    """One line for a wrong word, and the exit code of every other error."""

    def error(self, message: str) -> NoReturn:
        self.exit(1, f"{self.prog}: {printable(message)}; see {self.prog} --help\n")


def run_folder_parser(description: str | None) -> Parser:
    parser = Parser(description=description)
    parser.add_argument(
        "--run", type=Path, metavar="DIR", help="run folder (default: the newest of results/runs)"
    )
    return parser


def drawing_parser(description: str | None) -> Parser:
    parser = run_folder_parser(description)
    parser.add_argument(
        "--out", type=Path, metavar="DIR",
        help="folder for what is drawn (default: tables to RUN/tables, figures to RUN/figures)",
    )  # fmt: skip
    return parser


def write(drawn: Table | Drawing, run_folder: Path, out: Path | None) -> None:
    """Writes it in every format and says where."""
    if isinstance(drawn, Table):
        file, *others = table.write(drawn, out or run_folder / "tables")
    else:
        file, *others = drawing.write(drawn, out or run_folder / "figures")
    print(f"{file} (also {', '.join(other.suffix for other in others)})")


def draw_by(
    options: argparse.Namespace, of_run: Callable[[Run], Sequence[Table | Drawing]]
) -> int:
    """Reads the run, writes what is drawn from it; returns the exit code."""
    try:
        folder = options.run or newest_run()
        for drawn in of_run(read_run(folder)):
            write(drawn, folder, options.out)
    except (ResultError, OSError) as error:
        return complain(error)
    return 0


def draw(
    description: str | None,
    of_run: Callable[[Run], Sequence[Table | Drawing]],
    arguments: Sequence[str] | None = None,
) -> int:
    """The whole command of a table or figure without options of its own."""
    return draw_by(drawing_parser(description).parse_args(arguments), of_run)
