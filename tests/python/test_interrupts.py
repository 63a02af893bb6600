"""Ctrl-C ends a call and nothing else. The solve of the call continues in its own thread."""

from __future__ import annotations

import subprocess
import sys
import threading

import pytest
from python_package import BUILD, HERE, rough_ground

gb = pytest.importorskip("geodesic_bench")

SCRIPT = """
import gc, os, signal, sys, threading, time
sys.path[:0] = {paths!r}
import numpy as np, geodesic_bench as gb
import scipy.sparse  # which a matrix with a limit imports
from python_package import rough_ground

def threads():
    return len(os.listdir("/proc/self/task"))

alone = threads()
mesh = gb.Mesh(*rough_ground(400))
large = rough_ground(600)
mesh.distances(0, limit=0)

def interrupt_a_solve():
    while threads() < alone + 2:  # this thread and the solve's
        time.sleep(0.001)
    os.kill(os.getpid(), signal.SIGINT)

while threads() > alone: time.sleep(0.001)
interrupt = threading.Thread(target=interrupt_a_solve)
interrupt.start()
try:
    {call}
    print("ended")
except KeyboardInterrupt:
    interrupt.join()
    print("interrupted,", "still solving" if threads() > alone else "not solving")
del mesh
gc.collect()
{then}
"""
LONG_SOLVE = 'mesh.distances(0, solver="mmp")'
MANY_SOLVES = 'mesh.distance_matrix(range(160000), columns=[0], solver="mmp", threads=2)'
BUILD_OF_A_MESH = "gb.Mesh(*large).distances(0)"
WAIT = "while threads() > alone: time.sleep(0.05)"


def interrupted(call: str, then: str) -> str:
    script = SCRIPT.format(paths=[str(BUILD / "python"), str(HERE)], call=call, then=then)
    ended = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True, timeout=300
    )
    assert ended.stderr == ""
    return ended.stdout


@pytest.mark.parametrize("call", [LONG_SOLVE, MANY_SOLVES])
def test_an_interrupted_solve_ends_after_its_mesh_is_gone(call: str) -> None:
    assert interrupted(call, WAIT) == "interrupted, still solving\n"


@pytest.mark.parametrize(
    "call",
    [
        LONG_SOLVE,
        'mesh.distances(0, solver="mmp", return_nearest=True)',
        'mesh.solve(0, solver="mmp")',
        'mesh.path(0, 159999, solver="mmp")',
        'mesh.distance_matrix([0, (1, (1, 1, 1))], limit=1e9, solver="mmp")',
        BUILD_OF_A_MESH,
    ],
)
def test_a_process_ends_while_a_solve_that_was_interrupted_goes_on(call: str) -> None:
    assert interrupted(call, "") == "interrupted, still solving\n"


def test_an_exception_of_a_signal_handler_ends_a_call() -> None:
    handler = "signal.signal(signal.SIGINT, lambda *_: 1 / 0)\n    try: " + LONG_SOLVE
    handler += "\n    except ZeroDivisionError: raise KeyboardInterrupt"
    assert interrupted(handler, "") == "interrupted, still solving\n"


def test_other_threads_run_while_one_solves() -> None:
    mesh = gb.Mesh(*rough_ground(120))
    ticks, ended = [0], threading.Event()

    def tick() -> None:
        while not ended.wait(0.001):
            ticks[0] += 1

    ticking = threading.Thread(target=tick)
    ticking.start()
    before = ticks[0]
    mesh.distance_matrix(range(8), solver="mmp", threads=1)
    during = ticks[0] - before
    ended.set()
    ticking.join()
    assert during >= 5
