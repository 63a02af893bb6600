"""Runs the program geodesic-bench from Python and reads its results."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pandas import DataFrame

Option = bool | str | float | os.PathLike[str] | Sequence[object] | None

FAULT = "geodesic-bench: "
"""Prefix of the program's error message."""


class Results:
    """The results of a run of geodesic-bench.

    Parameters
    ----------
    file : path
        A run.json, or the folder with it.

    Raises
    ------
    ValueError
        For a file that is missing, broken or does not conform to the schema.

    Attributes
    ----------
    run : geodesic_bench.results.reader.Run
        The data of the tables and figures: rows, meshes, solvers, and the context of the measurement.
    """

    def __init__(self, file: str | os.PathLike[str]) -> None:
        from geodesic_bench.results import reader

        self.run = reader.read_run(Path(file))

    def __repr__(self) -> str:
        run = self.run
        count = run.columns.length
        return f"Results({count} rows of {len(run.solvers)} solvers on {len(run.meshes)} meshes)"

    def to_pandas(self) -> DataFrame:
        """Returns one row per repetition, or one for a cell that failed. docs/metrics.md defines the
        columns of numbers; "cpu_time" is in milliseconds."""
        from pandas import DataFrame

        names = ("solver", "mesh", "source", "repetition", "outcome", "message", "reference")
        return DataFrame(
            [{name: getattr(row, name) for name in names} | row.numbers for row in self.run.rows]
        )


def run(
    out: str | os.PathLike[str],
    *,
    executable: str | os.PathLike[str] | None = None,
    progress: bool = True,
    **options: Option,
) -> Results:
    """Measures solvers with `geodesic-bench run`, which verifies each solver before timing it.

    Parameters
    ----------
    out : path
        Folder for the results; it must not contain results yet.
    executable : path, optional
        The program; by default the one that GEODESIC_BENCH names, or else the one on the PATH.
    progress : bool
        Copy the progress of the program to the error stream: a line per cell, and the time left.
    options
        Options of the command line, as in ``run("first", corpus="tiny", solvers=["mmp", "edge-based"])``.

    Raises
    ------
    ValueError
        With the program's message, if it wrote no results. A cell that failed is a result.
    FileNotFoundError
        If the program is not found.
    """
    file = Path(out) / "run.json"
    if file.exists():
        raise ValueError(f"{file} is there already: choose another folder")
    command = [program(executable), "run", f"--out={os.fspath(out)}", *flags(options)]
    _, said = drive(command, progress)
    if not file.exists():
        raise ValueError(said[-1].removeprefix(FAULT))
    return Results(file)


def drive(command: list[str], progress: bool) -> tuple[int, list[str]]:
    """Runs the program to its end.

    @return the exit code and the lines that it printed, on both streams; at least one"""
    said: list[str] = []
    sys.stdout.flush()  # the caller's lines come before those of the program
    with subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    ) as process:
        try:
            for line in process.stdout or ():
                said.append(line.decode(errors="replace").removesuffix("\n"))
                if progress and not said[-1].startswith(FAULT):  # errors are raised instead
                    sys.stderr.write(said[-1] + "\n")
        except BaseException:
            process.terminate()
            raise
    return process.returncode, said or [""]


def program(named: str | os.PathLike[str] | None) -> str:
    name = os.fspath(named or os.environ.get("GEODESIC_BENCH") or "geodesic-bench")
    found = shutil.which(name)
    if found is None:
        raise FileNotFoundError(
            f"no program {name}: build it with ./run_all.sh build, and name it by executable= or"
            " GEODESIC_BENCH"
        )
    return found


def flags(options: dict[str, Option]) -> list[str]:
    flags = []
    for name, value in options.items():
        flag = f"--{name.replace('_', '-')}"
        if value is True:
            flags.append(flag)
        elif isinstance(value, list | tuple):
            flags.append(f"{flag}={','.join(map(str, value))}")
        elif value is not None and value is not False:
            flags.append(f"{flag}={value}")
    return flags
