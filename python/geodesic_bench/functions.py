"""Python functions as solvers, which are verified and measured like all other solvers."""

from __future__ import annotations

import json
import os
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np
from geodesic_bench.program import FAULT, Option, Results, drive, flags, program
from numpy.typing import ArrayLike, NDArray

Solve = Callable[[NDArray[np.int64]], ArrayLike]
"""Function that maps source vertices, an array of shape (k,), to a distance for each vertex."""

Prepare = Callable[[NDArray[np.float64], NDArray[np.int64]], Solve]
"""Function that maps vertices (n, 3) and faces (m, 3) to a function that answers queries."""

Promise = str | float
"""Guarantee for the distances: "exact", "upper_bound", "unbounded", or the largest relative error."""

answers = False
"""Whether this process answers a query (answer.py)."""


def benchmark(
    functions: Prepare | Mapping[str, Prepare],
    out: str | os.PathLike[str],
    *,
    against: Sequence[str] = ("edge-based",),
    promise: Promise = "unbounded",
    executable: str | os.PathLike[str] | None = None,
    progress: bool = True,
    **options: Option,
) -> Results:
    """Measures Python functions together with solvers, like `run`.

    Parameters
    ----------
    functions : function, or mapping of names to functions
        Each takes vertices, (n, 3) float64, and faces, (m, 3) int64, and returns a function that
        takes source vertices, (k,) int64, and returns n distances, infinite for unreachable vertices.
        The first is timed as preparation, the second as the solve; both times are CPU times. Each
        query runs in a new process of this Python, which a limit of time or memory may end. These
        processes find the function by its name: it must be at the top level of a module or a
        script, and a script calls this under ``if __name__ == "__main__":``.
    out : path
        Folder for the results; it must not contain results yet.
    against : names
        Names of solvers to run together with the functions.
    promise : str or float
        Guarantee of all functions for their distances: "exact", "upper_bound", "unbounded", or the
        largest relative error. Answers that violate it have no time.
    executable : path, optional
        As in `run`.
    progress : bool
        As in `run`.
    options
        As in `run`: ``benchmark(prepare, "first", meshes=["horse"], repetitions=9)``.

    Raises
    ------
    ValueError, FileNotFoundError
        As in `run`, and for a function that other processes cannot find.
    """
    file = Path(out) / "run.json"
    if file.exists():
        raise ValueError(f"{file} is there already: choose another folder")
    with _Described(_named(functions), promise) as described:
        names = ",".join([*described.names, *against])
        words = ["run", f"--out={os.fspath(out)}", f"--solvers={names}", *flags(options)]
        _, said = drive([program(executable), *described.words, *words], progress)
    if not file.exists():
        raise ValueError(said[-1].removeprefix(FAULT))
    return Results(file)


def verify(
    function: Prepare,
    *,
    promise: Promise = "unbounded",
    executable: str | os.PathLike[str] | None = None,
    progress: bool = True,
    **options: Option,
) -> None:
    """Checks that a Python function has the properties of all solvers, like `geodesic-bench verify`.

    Parameters
    ----------
    function, promise, executable, progress
        As in `benchmark`.
    options
        Options of the command line, as in ``verify(prepare, property="distances-are-symmetric")``.

    Raises
    ------
    ValueError
        If properties do not hold, with their names, and for the reasons of `benchmark`.
    """
    with _Described(_named(function), promise) as described, tempfile.TemporaryDirectory() as folder:
        (name,) = described.names
        words = ["verify", f"--solver={name}", *flags({"out": folder} | options)]
        code, said = drive([program(executable), *described.words, *words], progress)
    failed = [line.split()[1] for line in said if line.startswith("  FAILS ")]
    if failed:
        raise ValueError(f"{name} does not keep: {', '.join(failed)}")
    if code:
        raise ValueError(said[-1].removeprefix(FAULT))


def _named(functions: Prepare | Mapping[str, Prepare]) -> dict[str, Prepare]:
    if isinstance(functions, Mapping):
        return dict(functions)
    name = getattr(functions, "__name__", type(functions).__name__)
    plain = "".join(c if c.isascii() and c.isalnum() else "-" for c in name.lower()).strip("-")
    return {plain or "function": functions}


class _Described:
    """Folders with descriptions of functions as external solvers. Queries are answered by processes of this Python,
    which find the functions by their names (answer.py)."""

    def __init__(self, functions: dict[str, Prepare], promise: Promise) -> None:
        if answers:
            raise ValueError("the script measures whenever it is run")
        self.names = list(functions)
        self.commands = {name: _command(function) for name, function in functions.items()}
        self.promise: dict[str, object] = {"promise": promise}
        if not isinstance(promise, str):
            self.promise = {"promise": "bounded", "error_bound": promise}
        for command in self.commands.values():
            looked = subprocess.run(command, capture_output=True, text=True, check=False)
            if looked.returncode:
                raise _not_found(looked.stderr.strip().rpartition("\n")[2])

    def __enter__(self) -> _Described:
        self.folder = tempfile.TemporaryDirectory(prefix="geodesic-bench-")
        self.words: list[str] = []
        for name, command in self.commands.items():
            place = Path(self.folder.name, name)
            place.mkdir()
            query = "{vertices.npy} {faces.npy} {sources} {distances.npy}"
            about = {"name": name, "command": f"{shlex.join(command)} {query}", "remarks": "a Python function"}
            (place / "solver.json").write_text(json.dumps(about | self.promise))
            self.words += ["--external", str(place)]
        return self

    def __exit__(self, *_: object) -> None:
        self.folder.cleanup()


def _command(function: Prepare) -> list[str]:
    place, name = getattr(function, "__module__", ""), getattr(function, "__qualname__", "")
    if not name or "<" in name:
        raise _not_found(name or f"{function!r} has no name")
    if place == "__main__":
        main = sys.modules[place]
        place = main.__spec__.name if main.__spec__ else os.path.abspath(getattr(main, "__file__", None) or "")
        if not os.path.isfile(place) and not main.__spec__:
            raise _not_found("there is no file of a script")
    path = os.pathsep.join(map(os.path.abspath, sys.path))
    return ["env", f"PYTHONPATH={path}", sys.executable, "-P", "-m", "geodesic_bench.answer", place, name]


def _not_found(why: str) -> ValueError:
    return ValueError(
        "the processes that run the functions cannot find them: define them at the top level of a module, or of"
        f" a script that calls this under if __name__ == '__main__' ({why})"
    )
