"""A preparation answers as its solver does, is made once for all threads, and is kept in files and pickles."""

from __future__ import annotations

import copy
import inspect
import pickle
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import rough_ground

gb = pytest.importorskip("geodesic_bench")

SOLVER = "straight-graph?alpha=0.3"


@pytest.fixture
def prepared(mesh: Any) -> Any:
    return mesh.prepare(alpha=0.3, threads=1)


def test_a_preparation_answers_with_the_bits_of_its_solver(mesh: Any, prepared: Any) -> None:
    assert prepared.solver == SOLVER
    sources, targets = [3, (7, (1, 1, 2))], [99, (20, (1, 2, 3)), gb.Place(*mesh.vertices[50])]
    expected = mesh.distances(sources, initial=[0, 0.5], limit=9, solver=SOLVER)
    np.testing.assert_array_equal(prepared.distances(sources, initial=[0, 0.5], limit=9), expected)
    np.testing.assert_array_equal(
        prepared.distances(sources, targets), mesh.distances(sources, targets, solver=SOLVER)
    )
    for got, other in zip(
        prepared.distances([3, 99], return_nearest=True),
        mesh.distances([3, 99], solver=SOLVER, return_nearest=True),
        strict=True,
    ):
        np.testing.assert_array_equal(got, other)
    path = mesh.path(3, 99, solver=SOLVER)
    np.testing.assert_array_equal(prepared.path(3, 99).points, path.points)
    np.testing.assert_array_equal(prepared.paths(3, [99])[0].points, path.points)
    np.testing.assert_array_equal(prepared.solve(3).path_to(99).points, path.points)
    for options in ({}, {"columns": targets}, {"dtype": "float32", "threads": 2}):
        np.testing.assert_array_equal(
            prepared.distance_matrix(range(9), **options),
            mesh.distance_matrix(range(9), solver=SOLVER, **options),
        )
    np.testing.assert_array_equal(
        prepared.distance_matrix([3], limit=4).toarray(),
        mesh.distance_matrix([3], limit=4, solver=SOLVER).toarray(),
    )
    np.testing.assert_array_equal(
        mesh.distances(5, solver=prepared), prepared.distances(5)
    )  # as an argument of the mesh


def test_distances_of_a_preparation_are_never_too_short_and_as_long_as_certified(mesh: Any) -> None:
    prepared = mesh.prepare(check=3)
    exact = mesh.distance_matrix(range(30))
    assert (prepared.distance_matrix(range(30)) >= exact * (1 - 1e-12)).all()
    found = prepared.certificate
    assert found == mesh.prepare(check=3, threads=2).certificate
    assert found.sources == 3 and 0 < found.mean_error < found.largest_error < 0.1
    assert mesh.prepare().certificate is None
    with pytest.raises(AttributeError):
        found.sources = 4


def test_a_preparation_has_the_queries_of_a_mesh_that_take_a_solver(mesh: Any) -> None:
    of_the_solver = {"solver", "parameters", "approximate", "anywhere", "threads", "region_size"}
    for name, query in vars(gb.Mesh).items():
        if not callable(query) or name.startswith(("_", "prepare")) or "solver" not in (options := inspect.signature(query).parameters):
            continue
        assert options.keys() - of_the_solver <= inspect.signature(getattr(gb.Prepared, name)).parameters.keys(), name
    prepared = mesh.prepare(threads=1)
    loop = prepared.path_through([3, 99, 50], closed=True)
    steps = prepared.pair_distances([3, 99, 50], [99, 50, 3])
    assert loop.length == pytest.approx(steps.sum(), rel=0.01) and (loop.points[0] == loop.points[-1]).all()


@pytest.mark.parametrize(
    "kept",
    [
        lambda prepared, _: pickle.loads(pickle.dumps(prepared)),
        lambda prepared, _: copy.deepcopy(prepared),
        lambda prepared, file: (prepared.save(file), prepared.mesh.load_prepared(file))[1],
        lambda prepared, file: (prepared.save(str(file)), gb.Mesh(prepared.mesh).load_prepared(str(file)))[1],
    ],
    ids=["pickle", "copy", "file", "file for an equal mesh"],
)  # fmt: skip
def test_a_preparation_that_was_kept_gives_the_same_bits(
    mesh: Any, kept: Callable[[Any, Path], Any], tmp_path: Path
) -> None:
    prepared = mesh.prepare(alpha=0.3, check=2, threads=1)
    again = kept(prepared, tmp_path / "ground.prepared")
    assert (again.solver, again.certificate) == (prepared.solver, prepared.certificate)
    np.testing.assert_array_equal(again.distance_matrix(range(20)), prepared.distance_matrix(range(20)))
    np.testing.assert_array_equal(again.path(3, 99).points, prepared.path(3, 99).points)


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (lambda saved: b"", "this is not the preparation of a solver"),
        (lambda saved: b"solid\xff\x1b[2J\n", "this is not the preparation of a solver"),
        (lambda saved: saved[:-100], "the preparation ends early: prepare again"),
        (lambda saved: saved[:-1] + bytes([saved[-1] ^ 1]), "the preparation is damaged: prepare again"),
        (lambda saved: saved.replace(b"straight-graph", b"straight-\x1b\xff\n\0h"), "no solver named 'straight-"),
    ],
    ids=["empty", "other", "cut", "bit", "name"],
)  # fmt: skip
def test_a_file_that_is_no_preparation_of_the_mesh_is_refused_with_one_sentence(
    prepared: Any, change: Callable[[bytes], bytes], sentence: str, tmp_path: Path
) -> None:
    file = tmp_path / "ground.prepared"
    prepared.save(file)
    file.write_bytes(change(file.read_bytes()))
    with pytest.raises(ValueError) as refused:
        prepared.mesh.load_prepared(file)
    assert str(refused.value).startswith(f"{file}: {sentence}")
    assert str(refused.value).isprintable()


def test_a_preparation_of_another_mesh_is_refused(prepared: Any, tmp_path: Path) -> None:
    other = gb.Mesh(*rough_ground(11))
    prepared.save(tmp_path / "file")
    with pytest.raises(ValueError, match="file: the preparation is of another mesh$"):
        other.load_prepared(tmp_path / "file")
    with pytest.raises(ValueError, match="^solver is prepared for another mesh: prepare one for this"):
        other.distances(0, solver=prepared)
    with pytest.raises(FileNotFoundError):
        other.load_prepared(tmp_path / "nowhere")


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"solver": "mmp"}, "mmp prepares nothing that takes long: ask the mesh itself, or prepare saddle-vertex-graph, straight-graph"),
        ({"solver": "edge-based?threads=2"}, "edge-based prepares nothing that takes long"),
        ({"solver": "straight-grph"}, "no solver named 'straight-grph' (did you mean 'straight-graph'?)"),
        ({"solver": None}, "solver must be a name of solvers(), not None"),
        ({"alpa": 0.1}, "no argument named 'alpa' (did you mean 'alpha'?)"),
        ({"n_jobs": 2}, "no argument named 'n_jobs' (did you mean 'threads'?)"),
        ({"threads": -1}, "threads must be an integer between 0 and 1024, not -1"),
        ({"alpha": 0}, "straight-graph: parameter alpha is "),
        ({"alpha": "small"}, "straight-graph: parameter alpha is "),
        ({"check": 0.5}, "straight-graph: parameter check is "),
    ],
)  # fmt: skip
def test_what_cannot_be_prepared_is_refused(mesh: Any, arguments: Any, sentence: str) -> None:
    with pytest.raises(ValueError) as refused:
        mesh.prepare(**arguments)
    assert str(refused.value).startswith(sentence)


def test_a_preparation_takes_no_parameters_of_a_solver(mesh: Any, prepared: Any) -> None:
    with pytest.raises(ValueError, match=r"^straight-graph\?alpha=0.3 is already prepared: leave out alpha$"):
        mesh.distances(0, solver=prepared, alpha=0.1)


def test_parameters_are_added_to_those_in_the_name_of_a_solver(mesh: Any) -> None:
    assert mesh.prepare(solver=SOLVER, check=1, threads=1).solver == f"{SOLVER}&check=1"


def test_threads_that_share_a_preparation_get_the_same_bits(prepared: Any) -> None:
    expected = prepared.distance_matrix(range(40), threads=1)
    wrong = []

    def ask(first: int) -> None:
        for row in range(first, 40):
            if not np.array_equal(prepared.distances(row), expected[row]):
                wrong.append(row)
            if not row % 20:
                pickle.dumps(prepared)

    threads = [threading.Thread(target=ask, args=(first,)) for first in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == []


def test_a_preparation_answers_after_an_invalid_query(prepared: Any) -> None:
    expected = prepared.distances(0)
    for _ in range(2):
        with pytest.raises(ValueError, match="the distance limit must be 0 or more"):
            prepared.distances(0, limit=-1)
        np.testing.assert_array_equal(prepared.distances(0), expected)


def test_a_warning_has_the_line_that_called_the_package(prepared: Any) -> None:
    far = gb.Place(500, 0, 0)
    for ask in (prepared.mesh.distances, prepared.distances):
        with pytest.warns(UserWarning, match="from the surface") as caught:
            ask(far)
        assert {warning.filename for warning in caught} == {__file__}
