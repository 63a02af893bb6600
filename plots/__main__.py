"""Draws tables and figures of a run: all that it has the data for, or those that are named."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from results import console

if __name__ == "__main__":
    console.prepare("geodesic-bench plot")  # before imports that may fail

from plots.catalogue import EVERYTHING, draw_files
from results.names import unknown_name
from results.reader import ResultError, read_run, run_folder


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.Parser(
        __doc__, "geodesic-bench plot times speedup",
        "geodesic-bench plot overview --run results/runs/mine --meshes horse --out paper",
    )  # fmt: skip
    parser.add_argument("--run", type=Path, metavar="RUN", help=console.RUN)
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help=f"what to draw: {', '.join(EVERYTHING)}"
    )
    parser.add_argument(
        "--meshes", type=lambda text: text.split(","), metavar="A,B",
        help="meshes of the run that are drawn (default: all)",
    )  # fmt: skip
    parser.add_argument(
        "--out", type=Path, metavar="DIR",
        help="folder for what is drawn (default: tables to RUN/tables, figures to RUN/figures)",
    )  # fmt: skip
    options = parser.parse_args(arguments)
    for name in options.names:
        if name not in EVERYTHING:
            parser.error(unknown_name("table or figure", name, EVERYTHING))
    try:
        folder = run_folder(options.run)
        run = read_run(folder)
        if options.meshes:
            run = run.of_meshes(options.meshes)
        _, left_out = draw_files(run, folder, options.names, options.out)
        if options.names and left_out:
            raise ResultError(next(iter(left_out.values())))
        if left_out:
            print(f"left out: {', '.join(left_out)}; one that is named says why")
    except (ResultError, OSError) as error:
        return console.complain(error)
    return 0


if __name__ == "__main__":
    sys.exit(main())
