"""What every table's own command has in common: --run DIR [--out DIR]."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from results import ResultError, Run, newest_run, read_run
from table import Table, write


def run_folder_parser(description: str | None) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument(
        "--run", type=Path, metavar="DIR", help="run folder (default: the newest of results/runs)"
    )
    return parser


def draw(
    description: str | None,
    tables_of: Callable[[Run], Sequence[Table]],
    arguments: Sequence[str] | None = None,
) -> int:
    """Reads the run, writes its tables and says where; returns the exit code."""
    parser = run_folder_parser(description)
    parser.add_argument(
        "--out", type=Path, metavar="DIR", help="folder for the tables (default: RUN/tables)"
    )
    options = parser.parse_args(arguments)
    try:
        folder = options.run or newest_run()
        tables = tables_of(read_run(folder))
        for table in tables:
            file, *others = write(table, options.out or folder / "tables")
            print(f"{file} (also {', '.join(other.suffix for other in others)})")
    except (ResultError, OSError) as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return 1
    return 0
