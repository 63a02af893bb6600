"""Python functions as solvers: they are measured, checked, and stopped if they do not end."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import BENCH

gb = pytest.importorskip("geodesic_bench")

Solve = Callable[[Any], Any]

def exact(vertices: Any, faces: Any) -> Solve:
    solve: Solve = gb.Mesh(vertices, faces).distances
    return solve


def zeros(vertices: Any, faces: Any) -> Solve:
    return lambda sources: np.zeros(len(vertices))


def few(vertices: Any, faces: Any) -> Solve:
    return lambda sources: np.zeros(3)


def failing(vertices: Any, faces: Any) -> Solve:
    raise KeyError("no such thing")


def crashing(vertices: Any, faces: Any) -> Solve:
    return lambda sources: os.kill(os.getpid(), signal.SIGKILL)


def endless(vertices: Any, faces: Any) -> Solve:
    return lambda sources: time.sleep(1000)


def longer(vertices: Any, faces: Any) -> Solve:
    solve = exact(vertices, faces)
    return lambda sources: 1.02 * solve(sources)


def measure(functions: Any, out: Path, file: Path, **options: Any) -> Any:
    return gb.benchmark(functions, out, meshes=[file], executable=BENCH, repetitions=2, sources=1,
                        min_time=0.001, progress=False, **options)  # fmt: skip


def test_a_function_is_measured_beside_solvers(tmp_path: Path, file: Path) -> None:
    results = measure(exact, tmp_path / "out", file, promise="exact", against=["mmp"])
    table = results.to_pandas()
    assert set(table.solver) == {"exact", "mmp"} and set(table.outcome) == {"ok"}
    of = table[table.solver == "exact"]
    assert (of.cpu_time > 0).all() and (of.max_relative_error < 1e-12).all()
    assert (of.prepare_time > 0).all()


@pytest.mark.parametrize(
    ("function", "reason"),
    [
        (zeros, "wrong answer"),
        (few, "distances of shape (3,) for 144 vertices"),
        (failing, "KeyError: 'no such thing'"),
        (crashing, "killed by signal 9"),
    ],
)
def test_what_is_wrong_with_a_function_is_its_row(
    tmp_path: Path, file: Path, function: Any, reason: str
) -> None:
    results = measure(function, tmp_path / "out", file, promise="upper_bound", against=["mmp"])
    rows = {row.solver: f"{row.outcome}: {row.message}" for row in results.run.rows}
    assert rows["mmp"].startswith("ok")
    assert reason in rows[function.__name__]


def test_a_function_that_does_not_end_is_stopped(tmp_path: Path, file: Path) -> None:
    start = time.monotonic()
    results = measure(endless, tmp_path / "out", file, time_limit=1, against=["mmp"])
    assert time.monotonic() - start < 100
    outcomes = {row.solver: row.outcome for row in results.run.rows}
    assert outcomes == {"endless": "time-out", "mmp": "ok"}


def test_a_function_is_checked_for_what_solvers_promise() -> None:
    here = {"property": "another-component-is-infinitely-far", "executable": BENCH}
    gb.verify(exact, promise="exact", progress=False, **here)
    with pytest.raises(ValueError, match="zeros does not keep: another-component-is-infinitely-far"):
        gb.verify(zeros, progress=False, shrink=0, **here)
    with pytest.raises(ValueError, match="no property named 'no-such'"):
        gb.verify(exact, property="no-such", progress=False, executable=BENCH)


def test_a_promise_that_is_a_number_bounds_the_error(tmp_path: Path, file: Path) -> None:
    for bound, outcome in [(0.03, "ok"), (0.01, "wrong answer")]:
        results = measure(longer, tmp_path / str(bound), file, promise=bound, against=[])
        assert {row.outcome for row in results.run.rows} == {outcome}


def test_a_function_that_other_processes_cannot_find_is_refused_in_one_sentence(
    tmp_path: Path, file: Path
) -> None:
    def local(vertices: Any, faces: Any) -> Solve:
        return zeros(vertices, faces)

    for function in (local, {"nameless": lambda vertices, faces: zeros(vertices, faces)}):
        with pytest.raises(ValueError, match=r"^the processes that run the functions cannot find them: define.*<l(ocals|ambda)>"):
            measure(function, tmp_path / "out", file)
    script = tmp_path / "script.py"
    script.write_text(
        f"import sys; sys.path[:] = {sys.path!r}\n"
        "import geodesic_bench as gb\n"
        "def unguarded(vertices, faces): pass\n"
        f"gb.verify(unguarded, executable={str(BENCH)!r})\n"
    )
    for words in ([str(script)], ["-c", script.read_text()]):
        command = [sys.executable, *words]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        *_, last = ended.stderr.splitlines()
        assert ended.returncode == 1 and ended.stderr.count("Traceback") == 1, ended.stderr
        assert last.startswith("ValueError: the processes that run the functions cannot find them: define")
