"""Python functions as solvers, which are verified and measured like all other solvers."""

from __future__ import annotations

import json
import os
import pickle
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from multiprocessing import get_context
from pathlib import Path

from geodesic_bench.program import FAULT, Option, Results, flags, program
from geodesic_bench.serving import Prepare, serve

Promise = str | float
"""Guarantee for the distances: "exact", "upper_bound", "unbounded", or the largest relative error."""


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
        query runs in a process of its own, which a limit of time or memory may end. These processes
        find the function by its name: it must be at the top level of a module or a script, and a
        script calls this under ``if __name__ == "__main__":``.
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
    with _Served(_named(functions), promise) as served:
        names = ",".join([*served.names, *against])
        words = ["run", f"--out={os.fspath(out)}", f"--solvers={names}", *flags(options)]
        said = served.drive([program(executable), *served.words, *words], progress)
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
    with _Served(_named(function), promise) as served, tempfile.TemporaryDirectory() as folder:
        (name,) = served.names
        words = ["verify", f"--solver={name}", *flags({"out": folder} | options)]
        said = served.drive([program(executable), *served.words, *words], progress)
    failed = [line.split()[1] for line in said if line.startswith("  FAILS ")]
    if failed:
        raise ValueError(f"{name} does not keep: {', '.join(failed)}")
    if served.code:
        raise ValueError(said[-1].removeprefix(FAULT))


def _named(functions: Prepare | Mapping[str, Prepare]) -> dict[str, Prepare]:
    if isinstance(functions, Mapping):
        return dict(functions)
    name = getattr(functions, "__name__", type(functions).__name__)
    plain = "".join(c if c.isascii() and c.isalnum() else "-" for c in name.lower()).strip("-")
    return {plain or "function": functions}


class _Served:
    """Runs the program, beside a process that answers its queries to the functions. That process is started anew:
    a fork of this one, which may have threads, could wait forever for a lock that one of them holds."""

    def __init__(self, functions: dict[str, Prepare], promise: Promise) -> None:
        self.names = list(functions)
        self.promise = promise
        self.code = 0
        try:
            self.pickled = pickle.dumps(functions)
        except (pickle.PicklingError, AttributeError, TypeError) as error:
            raise _not_found(str(error)) from None

    def __enter__(self) -> _Served:
        self.folder = tempfile.TemporaryDirectory(prefix="geodesic-bench-")
        self.words: list[str] = []
        for name in self.names:
            place = Path(self.folder.name, name)
            place.mkdir()
            (place / "solver.json").write_text(json.dumps(self._description(name)))
            self.words += ["--external", str(place)]
        context = get_context("spawn")
        self.end, other_end = context.Pipe()
        self.process = context.Process(target=serve, args=(self.pickled, self.folder.name, other_end))
        try:
            self.process.start()
            other_end.close()
            if fault := self.end.recv():
                raise _not_found(fault)
        except BaseException as error:
            self.__exit__()
            if isinstance(error, EOFError):
                raise _not_found("the process has ended") from None
            if isinstance(error, RuntimeError):  # in the new process, which runs an unguarded script
                sys.exit(1)
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self.end.close()
        if self.process.pid is not None:
            self.process.join()
        self.folder.cleanup()

    def _description(self, name: str) -> dict[str, object]:
        ask = shlex.join([sys.executable, "-I", "-S", str(Path(__file__).with_name("ask.py"))])
        about: dict[str, object] = {"promise": self.promise}
        if not isinstance(self.promise, str):
            about = {"promise": "bounded", "error_bound": self.promise}
        return about | {
            "name": name,
            "command": f"{ask} {{folder}}/socket "
            "{vertices.npy} {faces.npy} {sources} {distances.npy}",
            "remarks": "a Python function",
        }

    def drive(self, command: list[str], progress: bool) -> list[str]:
        """Runs the program to its end. @return the lines that the program prints"""
        said: list[str] = []
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
        self.code = process.returncode
        return said or [""]


def _not_found(why: str) -> ValueError:
    return ValueError(
        "the process that runs the functions cannot find them: define them at the top level of a module, or of"
        f" a script that calls this under if __name__ == '__main__' ({why})"
    )
