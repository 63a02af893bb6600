"""Invalid requests are refused with one sentence. It is that of the program if the program has one."""

from __future__ import annotations

import pickle
import random
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from python_package import BENCH, Arrays

gb = pytest.importorskip("geodesic_bench")

CORNERS = np.eye(3)
FACE = [[0, 1, 2]]
RECORDS = np.zeros(3, [("x", "f4"), ("y", "f4"), ("z", "f4"), ("nx", "f4")])  # as from plyfile
ROWS = np.empty(1, object)
ROWS[0] = np.array(FACE[0])
MASKED: Any = np.ma  # without types
NOTHING = "a mesh needs at least one vertex and one face"
MEANINGLESS = "the mesh: distances would be meaningless:"


@pytest.mark.parametrize(
    ("vertices", "faces", "sentence"),
    [
        ([], FACE, "vertices must have the shape (n, 3), not (0,)"),
        (np.zeros((0, 3)), FACE, NOTHING),
        (CORNERS, np.zeros((0, 3), int), NOTHING),
        (CORNERS, np.zeros((0, 3)), NOTHING),
        (np.ones((3, 5)), FACE, "vertices must have the shape (n, 3), not (3, 5): transpose them with .T"),
        ([[0, 1], [2]], FACE, "vertices must be an array of numbers"),
        ([["a", "b", "c"]], FACE, "vertices must be real numbers, not text"),
        (RECORDS, FACE, "vertices must be real numbers, not records: write np.stack([a['x'], a['y'], a['z']], axis=1)"),
        (CORNERS, ROWS, "faces must be integers, not objects of type ndarray: join them with np.stack"),
        (CORNERS * 1j, FACE, "vertices must be real numbers, not complex128"),
        (CORNERS * np.nan, FACE, f"{MEANINGLESS} 3 vertices with a coordinate that is not finite"),
        (CORNERS - [np.inf, 0, 0], FACE, f"{MEANINGLESS} 3 vertices with a coordinate that is not finite"),
        (CORNERS * 1e100, FACE, "the mesh: the longest side of the mesh is 1e+100, and must be from 1e-20 to 1e+20; scale it"),
        (CORNERS, [[0, 1, 3]], "face 0: vertex 3 is not in the mesh of 3 vertices, numbered from 0 to 2"),
        (CORNERS, [[0, 1, 2], [0, 1, -1]], "face 1: vertex -1 is not in the mesh of 3 vertices"),
        (CORNERS, [[0, 1, 2**32 + 2]], "face 0: vertex 4294967298 is not in the mesh of 3 vertices"),
        (CORNERS, [[0, 1, 2**70]], "face 0: vertex 1180591620717411303424 is not in the mesh of 3"),
        (CORNERS, [[0, 1, 1]], f"{MEANINGLESS} 1 face of fewer than three different vertices (first: face 0 of"),
        (CORNERS, [[0, 1, 2.0]], "faces must be integers, not float64: write .astype(int) for indices"),
        (CORNERS, [[True, False, True]], "faces must be integers, not bool"),
        (CORNERS, [0, 1, 2], "faces must have the shape (n, 3), not (3,); a flat array is [3, a, b, c, 3, ...], of"),
        (CORNERS, [4, 0, 1, 2, 0], "faces must have the shape (n, 3), not (5,); a flat array is [3, a, b, c, 3, ...]"),
        (CORNERS, [[3, 0, 1, 2]], "faces must have the shape (n, 3), not (1, 4): leave out the first column"),
        (CORNERS, [[0, 1, 2, 0]], "faces must have the shape (n, 3), not (1, 4): divide the quadrangles into tri"),
        (CORNERS, [3, 0, 1, 3], "face 0: vertex 3 is not in the mesh of 3 vertices"),
        (([[0, 1], [2]], FACE), None, "vertices must be an array of numbers"),
        (CORNERS, None, "a mesh is vertices and faces, or an object that has them, or points and ce"),
    ],
)  # fmt: skip
def test_arrays_that_are_no_mesh_are_refused(vertices: Any, faces: Any, sentence: str) -> None:
    with pytest.raises(ValueError) as refused:
        gb.Mesh(vertices, faces)
    assert str(refused.value).startswith(sentence)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("query", "sentence"),
    [
        ({"sources": []}, "edge-based: a query needs at least one source"),
        ({"sources": 3}, "source vertex 3 is not in the mesh of 3 vertices"),
        ({"sources": [0, -1]}, "source vertex -1 is not in the mesh of 3 vertices"),
        ({"sources": 2**40}, "source vertex 1099511627776 is not in the mesh of 3 vertices"),
        ({"sources": -(2**70)}, "source vertex -1180591620717411303424 is not in the mesh"),
        ({"sources": np.uint64(2**64 - 1)}, "source vertex 18446744073709551615 is not in the"),
        ({"sources": [0.0]}, "source vertices must be integers, not float64: write .astype(int) for indices, or Place"),
        ({"sources": [1.0, 2.0, 0.0]}, "source vertices must be integers, not float64: write .astype(int) for"),
        ({"sources": np.array([True, False, True])}, "source vertices must be integers, not bool: write np.flatnonzero(ma"),
        ({"sources": [0, "edge:0-1:0.5"]}, "source vertices must be integers, not text"),
        ({"sources": [0, None]}, "source vertices must be integers, not None"),
        ({"sources": [0, {1}]}, "source vertices must be integers, not objects of type set"),
        ({"sources": None}, "source vertices must be integers, not None"),
        ({"sources": FACE}, "source vertices must be a list of indices, not of shape (1, 3); coordinates of places must be fl"),
        ({"sources": 0, "limit": -1}, "edge-based: the distance limit must be 0 or more"),
        ({"sources": 0, "limit": np.nan}, "edge-based: the distance limit must be 0 or more"),
        ({"sources": 0, "initial": -1}, "edge-based: an initial distance must be finite and not"),
        ({"sources": 0, "initial": np.inf}, "edge-based: an initial distance must be finite and"),
        ({"sources": 0, "initial": "x"}, "initial distances must be real numbers, not text"),
        ({"sources": 0, "initial": [1, 2]}, "initial distances must be one a source: 2 for 1 sou"),
        ({"sources": 0, "solver": "mmmp"}, "no solver named 'mmmp' (did you mean 'mmp'?); there"),
        ({"sources": 0, "solver": "mmp", "some_factor": 2}, "no argument named 'some_factor'; there are: "),
        ({"sources": 0, "radius": 2}, "no argument named 'radius' (did you mean 'limit'?)"),
        ({"sources": 0, "limt": 2}, "no argument named 'limt' (did you mean 'limit'?); there are: "),
        ({"sources": 0, "limit": "2"}, "limit must be a number, not '2'"),
        ({"sources": 0, "solver": None}, "solver must be a name of solvers(), not None"),
        ({"sources": [[np.nan, 0, 0]]}, "a place in space must have finite coordinates"),
        ({"sources": gb.Place(1e200, 0, 0)}, "a place in space is too far from the mesh"),
        ({"rows": [9]}, "row vertex 9 is not in the mesh of 3 vertices"),
        ({"rows": [0], "columns": [-2]}, "column vertex -2 is not in the mesh of 3 vertices"),
        ({"rows": [0], "threads": -1}, "threads must be an integer between 0 and 1024, not -1"),
        ({"rows": [0], "threads": None}, "threads must be an integer between 0 and 1024, not None"),
        ({"rows": [0], "n_jobs": 2}, "no argument named 'n_jobs' (did you mean 'threads'?)"),
        ({"rows": [0], "limit": [1]}, "limit must be a number, not [1]"),
        ({"rows": [0], "dtype": "single precision"}, "dtype must be float64 or float32, not single p"),
        ({"rows": [0], "dtype": "int8"}, "dtype must be float64 or float32, not int8"),
        ({"rows": [0], "limit": -1}, "edge-based: the distance limit must be 0 or more"),
        ({"rows": [[0, 1], []]}, "row 1 has no point"),
        ({"rows": [[]]}, "row 0 has no point"),
        ({"rows": [[0, 1], [9]]}, "row vertex 9 is not in the mesh of 3 vertices"),
        ({"rows": [[0, 1], [0.0, 1.0, 2.0]]}, "row vertices must be integers, not float64: write .astype(int) for"),
        ({"rows": [[[0, 1], [1, 2]]]}, "row vertices must be a list of indices, not of shape (2, 2)"),
        ({"rows": np.array([[0, 1], [1, 2]])}, "rows of shape (2, 2) may be sets of vertices or coordinates: write .to"),
        ({"rows": [0], "columns": [[0, 1], [2]]}, "columns must be an array of vertices, tuples (face, weights) and"),
        ({"a": [0, 1, 2], "b": [0, 1]}, "a and b must have as many points: 3 and 2"),
        ({"a": 0, "b": [0, 1]}, "a and b must have as many points: 1 and 2"),
        ({"a": [[0, 1], [1, 2]], "b": [0, 1]}, "point of a vertices must be a list of indices, not of shape (2, 2)"),
        ({"a": [0], "b": [9]}, "point of b vertex 9 is not in the mesh of 3 vertices"),
        ({"a": [0.5], "b": [0]}, "point of a vertices must be integers, not float64"),
        ({"a": [0], "b": [0], "threads": -1}, "threads must be an integer between 0 and 1024, not -1"),
        ({"a": [0], "b": [0], "n_jobs": 2}, "no argument named 'n_jobs' (did you mean 'threads'?)"),
    ],
)  # fmt: skip
def test_queries_that_have_no_answer_are_refused(query: dict[str, Any], sentence: str) -> None:
    mesh = gb.Mesh(CORNERS, FACE)
    with pytest.raises(ValueError) as refused:
        ask = {"sources": mesh.distances, "a": mesh.pair_distances}
        ask.get(next(iter(query)), mesh.distance_matrix)(**query)
    assert str(refused.value).startswith(sentence)
    assert mesh.distances(0)[0] == 0


def test_an_error_is_a_value_error_and_what_python_raises_in_such_a_case() -> None:
    mesh = gb.Mesh(CORNERS, FACE)
    outside: list[Callable[[], Any]] = [
        lambda: mesh.distances(3),
        lambda: mesh.path(0, (1, (1, 1, 1))),
        lambda: gb.Mesh(CORNERS, [[0, 1, 3]]),
    ]
    unknown: list[Callable[[], Any]] = [
        lambda: mesh.distances(0, radius=2),
        lambda: mesh.solve(0, some_factor=2),
        lambda: mesh.distances(0, solver="mmp", threads=2),
        lambda: mesh.distances(0, solver="dijkstra", region_size=9),
        lambda: mesh.distances(0, solver=mesh.prepare(), alpha=0.1),
    ]
    for calls, kind in ((outside, IndexError), (unknown, TypeError)):
        for call in calls:
            for expected in (kind, ValueError):
                with pytest.raises(expected):
                    call()
    with pytest.raises(TypeError, match="^mmp has no parameter 'threads': leave it out$"):
        mesh.distances(0, solver="mmp", threads=0)


class Tensor:
    """As of torch, on a device: NumPy cannot convert it."""

    def __array__(self, *_: object, **__: object) -> Any:
        raise TypeError("can't convert cuda:0 device type tensor to numpy")

    def detach(self) -> Tensor:
        return self


class WithGradient(Tensor):
    def __array__(self, *_: object, **__: object) -> Any:
        raise RuntimeError("Can't call numpy() on Tensor that requires grad")


class OfCupy:
    __cuda_array_interface__: Any = {}

    def __array__(self, *_: object, **__: object) -> Any:
        raise TypeError("Implicit conversion to a NumPy array is not allowed")


class PolyData:
    points = CORNERS


@pytest.mark.parametrize(
    ("values", "remedy"),
    [
        (MASKED.array([0, 1], mask=[0, 1]), " must not have masked entries: leave them out, or call .filled(value)"),
        (Tensor(), ", not a Tensor on a device or with a gradient: call .detach().cpu().numpy()"),
        (WithGradient(), ", not a WithGradient on a device or with a gradient: call .detach().cpu().numpy()"),
        (OfCupy(), ", not a OfCupy on a GPU: call .get()"),
        ((i for i in (0, 1)), ", not a generator: call list() first"),
        ({0, 1}, ", not a set: call list() first"),
        ({0: 1}.keys(), ", not a dict_keys: call list() first"),
        (PolyData(), ", not a PolyData: pass its .points"),
    ],
)  # fmt: skip
def test_an_object_that_is_no_array_is_refused_with_what_to_call(values: Any, remedy: str) -> None:
    mesh = gb.Mesh(CORNERS, FACE)
    calls: list[Callable[[Any], Any]] = [
        mesh.distances,
        mesh.distance_matrix,
        lambda values: mesh.distances(0, initial=values),
        lambda values: gb.Mesh(values, FACE),
        lambda values: gb.Mesh(CORNERS, values),
    ]
    for call in calls:
        with pytest.raises(ValueError) as refused:
            call(values)
        assert str(refused.value).endswith(remedy)


def test_a_masked_array_without_masked_entries_is_its_values() -> None:
    mesh = gb.Mesh(MASKED.array(CORNERS), MASKED.array(FACE))
    np.testing.assert_array_equal(mesh.distances(MASKED.array([0])), mesh.distances([0]))


@pytest.mark.filterwarnings("ignore:.* from the surface, whose nearest point is taken")
def test_any_numbers_in_arrays_of_any_shape_are_answered_or_refused(ground: Arrays) -> None:
    chance = random.Random(4)
    values: list[Any] = [0, 1, 2, 5, 143, 144, -1, 2**31, 2**32 - 1, 2**32, 2**63, 2**64, 0.5, 1e300, 1e-300]
    values += [float("nan"), float("inf"), -0.0, True, None, "1", 1j]
    mesh = gb.Mesh(*ground)

    def anything() -> Any:
        some = [chance.choice(values) for _ in range(chance.choice([0, 1, 3, 6, 9]))]
        if chance.random() < 0.5:
            some = [value for value in some if type(value) in (int, float)]
        if len(some) % 3 == 0 and chance.random() < 0.6:
            some = [some[i : i + 3] for i in range(0, len(some), 3)]
        return np.array(some, dtype=object) if chance.random() < 0.2 else some

    answered = 0
    for _ in range(3000):
        question: Callable[[], object] = chance.choice([
            lambda: gb.Mesh(anything(), anything()),
            lambda: gb.Mesh(ground[0], anything()),
            lambda: mesh.distances(anything(), initial=anything()),
            lambda: mesh.distances(anything()),
            lambda: mesh.distance_matrix(anything(), columns=anything()),
        ])  # fmt: skip
        try:
            question()
            answered += 1
        except ValueError as error:
            assert str(error) and "\n" not in str(error)
    assert answered > 50


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("twice.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n"),
        ("empty.obj", ""),
        ("cut\x1b.off", "OFF\n3 1 0\n0 0 0\n1 0"),
    ],
)
def test_a_file_is_refused_with_the_sentence_of_the_program(
    name: str, text: str, tmp_path: Path
) -> None:
    """Only the option differs: it has its name in Python."""
    file = tmp_path / name
    file.write_text(text)
    solve: list[str | Path] = [BENCH, "solve", file, "--solver", "mmp", "--source", "0"]
    said = subprocess.run(solve, capture_output=True, text=True, check=False).stderr
    with pytest.raises(ValueError) as refused:
        gb.read_mesh(file)
    assert f"geodesic-bench: {refused.value}\n" == said.replace("--repair", "repair=True")


def test_a_repaired_file_warns_once_of_all_that_was_repaired(tmp_path: Path) -> None:
    file = tmp_path / "twice.off"
    file.write_text("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n")
    with pytest.warns(UserWarning, match=r"twice\.off: 1 repeated .*; repair: .*: 1$") as warned:
        mesh = gb.read_mesh(file, repair=True)
    assert len(warned) == 1 and len(mesh.faces) == 1


def test_defects_are_named_and_counted() -> None:
    arrays = np.vstack([CORNERS, [[9, 9, 9], [0, 0, 9]]]), [[0, 1, 2], [1, 0, 3], [0, 1, 3]]
    with pytest.raises(ValueError, match=f"{MEANINGLESS} 1 repeated face .*; correct the mesh or use repair=True$"):
        gb.Mesh(*arrays)
    with pytest.warns(UserWarning, match="^repair: repeated faces dropped, the first of each kept: 1$"):
        gb.Mesh(*arrays, repair=True)
    found = gb.defects(gb.Mesh(arrays[0], arrays[1][:2]))
    assert [(d.kind, d.severity, d.count) for d in found] == [("isolated_vertex", "warning", 1)]
    assert "vertex 4" in str(found[0])


def test_defects_and_solvers_come_back_from_other_processes() -> None:
    (defect,) = gb.defects(gb.Mesh([*CORNERS, [9, 9, 9]], FACE))
    for one in (defect, gb.solvers()["straight-graph"]):
        again = pickle.loads(pickle.dumps(one))
        properties = [name for name in dir(one) if not name.startswith("_")]
        assert [getattr(again, name) for name in properties] == [getattr(one, name) for name in properties]
        assert (repr(again), str(again)) == (repr(one), str(one))


def test_a_solver_says_what_it_does_not_support() -> None:
    mesh = gb.Mesh([[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    with pytest.raises(ValueError, match=r"^ch: supports no faces with a zero-length edge"):
        mesh.distances(0, solver="ch")
    assert mesh.distances(0)[2] == 2
