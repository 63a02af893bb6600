"""Python functions as solvers, which are verified and measured like all other solvers."""

from __future__ import annotations

import json
import os
import selectors
import shlex
import signal
import socket
import subprocess
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geodesic_bench.program import FAULT, Option, Results, flags, program

Solve = Callable[[NDArray[np.int64]], ArrayLike]
"""Function that maps source vertices, an array of shape (k,), to a distance for each vertex."""

Prepare = Callable[[NDArray[np.float64], NDArray[np.int64]], Solve]
"""Function that maps vertices (n, 3) and faces (m, 3) to a function that answers queries."""

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
        query runs in a fork of this process, which a limit of time or memory may end.
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
        As in `run`.
    """
    file = Path(out) / "run.json"
    if file.exists():
        raise ValueError(f"{file} is there already: choose another folder")
    with _Served(_named(functions), promise) as served:
        names = ",".join([*served.functions, *against])
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
        If properties do not hold, with their names.
    """
    with _Served(_named(function), promise) as served, tempfile.TemporaryDirectory() as folder:
        (name,) = served.functions
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
    """Runs the program and answers its queries to the functions."""

    def __init__(self, functions: dict[str, Prepare], promise: Promise) -> None:
        self.functions = functions
        self.promise = promise
        self.code = 0

    def __enter__(self) -> _Served:
        self.closing = ExitStack()
        temporary = tempfile.TemporaryDirectory(prefix="geodesic-bench-")
        folder = Path(self.closing.enter_context(temporary))
        self.selector = self.closing.enter_context(selectors.DefaultSelector())
        self.answering: dict[int, tuple[int, socket.socket]] = {}
        self.words: list[str] = []
        for name, function in self.functions.items():
            place = folder / name
            place.mkdir()
            listener = self.closing.enter_context(socket.socket(socket.AF_UNIX))
            listener.bind(str(place / "socket"))
            listener.listen()
            self.selector.register(listener, selectors.EVENT_READ, (self._accept, function))
            (place / "solver.json").write_text(json.dumps(self._description(name)))
            self.words += ["--external", str(place)]
        return self

    def __exit__(self, *_: object) -> None:
        for child in list(self.answering):
            self._end(child)
        self.closing.close()

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
        rest = b""
        with subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
        ) as process:
            output = process.stdout
            assert output is not None
            self.selector.register(output, selectors.EVENT_READ, None)
            try:
                while block := self._next_block(output.fileno()):
                    *lines, rest = (rest + block).split(b"\n")
                    for line in lines:
                        said.append(line.decode(errors="replace"))
                        if progress and not said[-1].startswith(FAULT):  # errors are raised instead
                            sys.stderr.write(said[-1] + "\n")
            except BaseException:
                process.terminate()
                raise
            finally:
                self.selector.unregister(output)
        self.code = process.returncode
        return [*said, rest.decode(errors="replace")] if rest or not said else said

    def _next_block(self, output: int) -> bytes:
        """Returns the next block of the program's output, empty at its end, and answers queries meanwhile."""
        while True:
            for key, _ in self.selector.select():
                if key.data is None:
                    return os.read(output, 1 << 16)
                action, argument = key.data
                action(key.fileobj, argument)

    def _accept(self, listener: socket.socket, function: Prepare) -> None:
        connection, _ = listener.accept()
        with connection.makefile("r", encoding="utf-8") as stream:
            question = stream.readline()
        if not question:
            return connection.close()
        sys.stdout.flush()
        sys.stderr.flush()
        child = os.fork()
        if child == 0:
            _answer(connection, function, *json.loads(question))
        ended = os.pidfd_open(child)
        self.answering[child] = (ended, connection)
        # Detects the end of the child, and the end of ask.py when a limit is reached.
        self.selector.register(ended, selectors.EVENT_READ, (self._ended, child))
        self.selector.register(connection, selectors.EVENT_READ, (self._ended, child))

    def _ended(self, _: object, child: int) -> None:
        if child in self.answering:
            self._end(child)

    def _end(self, child: int) -> None:
        ended, connection = self.answering.pop(child)
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        self.selector.unregister(ended)
        self.selector.unregister(connection)
        os.close(ended)
        connection.close()


def _answer(
    connection: socket.socket, function: Prepare, vertices: str, faces: str, sources: str, out: str
) -> None:
    """Answers a query in a child process, and ends this process."""
    try:
        answer: Any = _times(function, vertices, faces, sources, out)
    except BaseException as error:
        answer = traceback.format_exception_only(type(error), error)[-1].strip()
    try:
        connection.sendall(json.dumps(answer).encode() + b"\n")
    finally:
        os._exit(0)


def _times(
    function: Prepare, vertices: str, faces: str, sources: str, out: str
) -> tuple[float, float]:
    arrays = np.load(vertices), np.load(faces).astype(np.int64)
    asked = np.array([int(source) for source in sources.split(",") if source], dtype=np.int64)
    start = time.process_time()
    solve = function(*arrays)
    prepared = time.process_time()
    distances = np.asarray(solve(asked), dtype=np.float64)
    solved = time.process_time()
    if distances.shape != (len(arrays[0]),):
        raise ValueError(f"distances of shape {distances.shape} for {len(arrays[0])} vertices")
    np.save(out, distances)
    return prepared - start, solved - prepared
