"""Answers one query to a Python function, as an external solver: functions.py starts this for each.

python3 -m geodesic_bench.answer FILE|MODULE NAME [VERTICES FACES SOURCES DISTANCES]

Without a query it only looks the function up."""

from __future__ import annotations

import functools
import importlib
import runpy
import sys
import time
import traceback
from types import SimpleNamespace
from typing import Any

import numpy as np
from geodesic_bench import functions


def _find(place: str, name: str) -> functions.Prepare:
    functions.answers = True  # a script that measures whenever it is imported would do so without end
    if place.endswith(".py"):
        module: Any = SimpleNamespace(**runpy.run_path(place))
    else:
        module = importlib.import_module(place)
    found: functions.Prepare = functools.reduce(getattr, name.split("."), module)
    return found


def _answer(
    function: functions.Prepare, vertices: str, faces: str, sources: str, out: str
) -> None:
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
    print("prepare_time", prepared - start)
    print("solve_time", solved - prepared)


if __name__ == "__main__":
    try:
        found = _find(*sys.argv[1:3])
        if sys.argv[3:]:
            _answer(found, *sys.argv[3:])
    except Exception as error:
        sys.exit(traceback.format_exception_only(type(error), error)[-1].strip())
