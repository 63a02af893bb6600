"""The process that has the Python functions of `benchmark` and `verify` and answers the queries of ask.py. It has
no threads, and answers each query in a fork of itself, which may crash or be ended."""

from __future__ import annotations

import json
import os
import pickle
import selectors
import signal
import socket
import time
import traceback
from collections.abc import Callable
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Solve = Callable[[NDArray[np.int64]], ArrayLike]
"""Function that maps source vertices, an array of shape (k,), to a distance for each vertex."""

Prepare = Callable[[NDArray[np.float64], NDArray[np.int64]], Solve]
"""Function that maps vertices (n, 3) and faces (m, 3) to a function that answers queries."""


def serve(pickled: bytes, folder: str, parent: Connection) -> None:
    """Answers queries to FOLDER/NAME/socket until the other end of `parent` is closed. Sends an empty text there
    when queries are answered, or why there is no function.

    @param pickled a dictionary of functions by name"""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C ends the parent, which then closes its end
    try:
        functions: dict[str, Prepare] = pickle.loads(pickled)
    except Exception as error:
        return parent.send(_one_line(error))
    server = _Server(parent)
    for name, function in functions.items():
        server.listen(Path(folder, name, "socket"), function)
    parent.send("")
    server.run()


class _Server:
    def __init__(self, parent: Connection) -> None:
        self.parent = parent
        self.selector = selectors.DefaultSelector()
        self.selector.register(parent, selectors.EVENT_READ)
        self.answering: dict[int, tuple[int, socket.socket]] = {}

    def listen(self, file: Path, function: Prepare) -> None:
        listener = socket.socket(socket.AF_UNIX)
        listener.bind(str(file))
        listener.listen()
        self.selector.register(listener, selectors.EVENT_READ, (self._accept, function))

    def run(self) -> None:
        while True:
            for key, _ in self.selector.select():
                if key.fileobj is self.parent:
                    for child in list(self.answering):
                        self._end(child)
                    return
                action, argument = key.data
                action(key.fileobj, argument)

    def _accept(self, listener: socket.socket, function: Prepare) -> None:
        connection, _ = listener.accept()
        with connection.makefile("r", encoding="utf-8") as stream:
            question = stream.readline()
        if not question:
            return connection.close()
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
        answer = _one_line(error)
    try:
        connection.sendall(json.dumps(answer).encode() + b"\n")
    finally:
        os._exit(0)


def _one_line(error: BaseException) -> str:
    return traceback.format_exception_only(type(error), error)[-1].strip()


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
