"""Distances from Python have the same bits as those of the program, for all types of arrays."""

from __future__ import annotations

import json
import os
import pickle
import random
import shutil
import subprocess
import threading
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from python_package import BENCH, Arrays, rough_ground, solve

gb = pytest.importorskip("geodesic_bench")


@pytest.mark.parametrize("solver", gb.solvers())
def test_distances_are_the_bits_of_the_program(
    solver: str, mesh: Any, file: Path, tmp_path: Path
) -> None:
    output = tmp_path / "distances.txt"
    solve(file, "--solver", solver, "--source", "7,130", "--limit", 9, "--output", output)
    expected = np.loadtxt(output)
    assert np.isinf(expected).any()
    for asked in (mesh, gb.read_mesh(file)):
        np.testing.assert_array_equal(asked.distances([7, 130], limit=9, solver=solver), expected)


def test_of_several_meshes_each_that_can_be_solved_is_written(
    mesh: Any, file: Path, tmp_path: Path
) -> None:
    for name in ("first.obj", "last.obj"):
        shutil.copy(file, tmp_path / name)
    (tmp_path / "broken.obj").write_text("no mesh")
    files = ["first.obj", "broken.obj", "last.obj"]
    command: list[str | Path] = [BENCH, "solve", *files, "--source", "7", "--out", "distances"]
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert run.returncode == 1
    assert "broken: " in run.stderr and "1 of 3 meshes" in run.stderr
    solved = [json.loads(line) for line in run.stdout.splitlines()]
    assert [one["output"] for one in solved] == ["distances/first.txt", "distances/last.txt"]
    for one in solved:
        np.testing.assert_array_equal(np.loadtxt(tmp_path / one["output"]), mesh.distances([7]))


def test_files_of_any_suffix_have_the_same_distances(
    mesh: Any, file: Path, tmp_path: Path
) -> None:
    expected, nearest = mesh.distances([7, 130], limit=9, return_nearest=True)
    separate = np.stack([mesh.distances([source], limit=9) for source in (7, 130)])

    def solved(*words: str) -> Path:
        output = tmp_path / words[-1]
        solve(file, "--source", "7,130", "--limit", 9, *words[:-1], "--output", output)
        return output

    np.testing.assert_array_equal(np.load(solved("d.npy")), expected)
    csv: NDArray[Any] = np.genfromtxt(solved("--nearest-source", "d.csv"), delimiter=",", names=True)
    table = np.load(solved("--nearest-source", "table.npy"))
    for name, values in {"distance": expected, "source": nearest}.items():
        np.testing.assert_array_equal(csv[name], values)
        np.testing.assert_array_equal(table[name], values)
    np.testing.assert_array_equal(csv["vertex"], np.arange(len(expected)))
    np.testing.assert_array_equal(np.load(solved("--each", "each.npy")), separate)
    rows = solved("--each", "each.csv").read_text().splitlines()
    assert rows[0].startswith("source,0,1,2,")
    assert [row.split(",")[0] for row in rows[1:]] == ['"7"', '"130"']
    np.testing.assert_array_equal(
        [[float(number) for number in row.split(",")[1:]] for row in rows[1:]], separate
    )


def test_each_row_of_a_matrix_is_the_bits_of_a_single_query(mesh: Any) -> None:
    rows, columns = [5, 0, 143, 5], [143, 2, 2]
    full = np.stack([mesh.distances(row) for row in rows])
    for threads in (0, 1, 3, 9):
        np.testing.assert_array_equal(mesh.distance_matrix(rows, threads=threads), full)
        np.testing.assert_array_equal(
            mesh.distance_matrix(rows, columns, threads=threads), full[:, columns]
        )
        single = mesh.distance_matrix(rows, columns, threads=threads, dtype="float32")
        assert single.dtype == np.float32
        np.testing.assert_array_equal(single, full[:, columns].astype(np.float32))


@pytest.mark.parametrize("dtype", [np.float64, np.float32, ">f4"])
def test_a_matrix_with_a_limit_stores_what_it_reaches(mesh: Any, dtype: str) -> None:
    dense = mesh.distance_matrix([3, 77])
    sparse = mesh.distance_matrix([3, 77], limit=4.0, dtype=dtype)
    reached = dense <= 4
    assert sparse.dtype == np.dtype(dtype).newbyteorder("=")
    assert 2 < sparse.nnz == reached.sum() < dense.size
    np.testing.assert_array_equal(sparse.toarray()[reached], dense[reached].astype(dtype))
    assert sparse.has_canonical_format
    assert mesh.distance_matrix([3], columns=[], limit=4.0).shape == (1, 0)
    assert mesh.distance_matrix([3], columns=[]).shape == (1, 0)
    assert mesh.distance_matrix([], limit=4.0).shape == (0, dense.shape[1])


def test_a_bar_counts_the_rows(mesh: Any, capsys: pytest.CaptureFixture[str]) -> None:
    expected = mesh.distance_matrix(range(30))
    assert capsys.readouterr().err == ""
    np.testing.assert_array_equal(mesh.distance_matrix(range(30), progress=True), expected)
    mesh.distance_matrix(range(20), limit=1, progress=True)
    said = capsys.readouterr().err
    assert "30/30" in said and "20/20" in said


def test_a_matrix_without_room_is_refused_with_its_size() -> None:
    """The matrix has more bytes than a process has addresses."""
    many = np.zeros(4_500_000, np.uint8)
    with pytest.raises(MemoryError, match=r"^no room for a matrix of 4500000 rows and 4500000 col"):
        gb.Mesh(np.eye(3), [[0, 1, 2]]).distance_matrix(many, many)


def test_initial_distances_are_added_and_the_least_sum_counts(mesh: Any) -> None:
    first, second = mesh.distance_matrix([0, 100])
    both = mesh.distances([0, 100], initial=[1.5, 4])
    np.testing.assert_allclose(both, np.minimum(first + 1.5, second + 4), rtol=1e-12)
    np.testing.assert_allclose(mesh.distances(0, initial=2), first + 2, rtol=1e-12)


@pytest.mark.parametrize("solver", ["edge-based", "dijkstra"])
def test_distances_of_targets_are_those_of_all_vertices_and_points(solver: str, mesh: Any) -> None:
    every = mesh.distances([7, 130], initial=[0, 1.5], solver=solver)
    for targets in ([3], 3, np.array([3, 3, 99], np.uint8), range(20)):
        got = mesh.distances([7, 130], targets, initial=[0, 1.5], solver=solver)
        np.testing.assert_array_equal(got, np.atleast_1d(every[targets]))
    assert mesh.distances(7, [], solver=solver).shape == (0,)
    points = [(3, (0.2, 0.3, 0.5)), 12]
    np.testing.assert_allclose(
        mesh.distances([7], points, solver=solver), mesh.distance_matrix([7], points, solver=solver)[0], rtol=1e-12
    )
    assert np.isinf(mesh.distances(7, 130, limit=2, solver=solver)).tolist() == [True]


def test_no_limit_is_an_infinite_one(mesh: Any) -> None:
    np.testing.assert_array_equal(mesh.distances(0, limit=None), mesh.distances(0, limit=np.inf))


def test_a_mesh_of_another_package_is_its_arrays(ground: Arrays) -> None:
    vertices, faces = ground
    triangles, more = SimpleNamespace(type="triangle", data=faces[:9]), faces[9:]
    edges = SimpleNamespace(type="line", data=faces[:, :2])
    quads = SimpleNamespace(type="quad", data=[[0, 1, 2, 3]])
    blocks = [edges, triangles, SimpleNamespace(type="triangle", data=more)]
    for other in (
        SimpleNamespace(vertices=vertices, faces=faces),
        SimpleNamespace(points=vertices, cells=faces),
        SimpleNamespace(points=vertices, cells=blocks),
        gb.Mesh(vertices, faces),
    ):
        mesh = gb.Mesh(other)
        np.testing.assert_array_equal(mesh.vertices, vertices)
        np.testing.assert_array_equal(mesh.faces, faces)
    with pytest.raises(ValueError, match="^cells must be triangles, not quad: convert them, or give gb.Mesh the"):
        gb.Mesh(SimpleNamespace(points=vertices, cells=[triangles, quads]))
    with pytest.raises(ValueError, match="^a mesh needs at least one vertex and one face$"):
        gb.Mesh(SimpleNamespace(points=vertices, cells=[edges]))


def test_what_no_path_leads_to_is_infinite() -> None:
    mesh = gb.Mesh(np.vstack([np.eye(3), np.zeros((1, 3))]), [[0, 1, 2]])
    assert mesh.distances(0)[3] == np.inf
    assert np.isinf(mesh.distances(3)).tolist() == [True, True, True, False]
    assert mesh.distance_matrix([0], dtype="float32")[0, 3] == np.inf


def test_arrays_of_any_type_order_and_flag_give_the_same_bits_and_are_not_written_to(
    ground: Arrays,
) -> None:
    """Every type can represent these coordinates and indices."""
    chance = random.Random(22)
    vertices, faces = np.round(ground[0] * 8), ground[1]
    expected = gb.Mesh(vertices, faces).distance_matrix([0, 60, 99])
    real = ["f8", "f4", ">f8", "f2", "i4", ">i2", "u1", "longdouble", "O"]
    whole = ["i8", "u8", "i4", ">u4", "i2", "u1", "O"]

    forms: list[Callable[[Any], Any]] = [
        np.asfortranarray,
        lambda array: np.repeat(array, 2, axis=0)[::2],  # with gaps
        lambda array: array[::-1].copy()[::-1],  # backwards
        lambda array: array.tolist(),
    ]

    def disguised(array: NDArray[Any], types: list[str]) -> Any:
        array = array.astype(chance.choice(types))
        for form in forms:
            if chance.random() < 0.3:
                array = form(array)
        if isinstance(array, np.ndarray):
            array.flags.writeable = chance.random() < 0.5
        return array

    for _ in range(150):
        given = disguised(vertices, real), disguised(faces, whole)
        rows = disguised(np.array([0, 60, 99]), whole)
        before = [np.array(array) for array in (*given, rows)]
        np.testing.assert_array_equal(gb.Mesh(*given).distance_matrix(rows), expected)
        for array, old in zip((*given, rows), before, strict=True):
            np.testing.assert_array_equal(np.array(array), old)


def test_a_mesh_has_its_own_copy_of_arrays_and_shows_it_read_only(ground: Arrays) -> None:
    vertices, faces = (array.copy() for array in ground)
    mesh = gb.Mesh(vertices, faces)
    expected = mesh.distances(0)
    vertices[:] = 0
    faces[:] = 0
    np.testing.assert_array_equal(mesh.vertices, ground[0])
    np.testing.assert_array_equal(mesh.faces, ground[1])
    assert not mesh.vertices.flags.writeable and not mesh.faces.flags.writeable
    np.testing.assert_array_equal(gb.Mesh(mesh.vertices, mesh.faces).distances(0), expected)
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(mesh)).distances(0), expected)
    view = mesh.vertices
    del mesh
    np.testing.assert_array_equal(view, ground[0])


def test_threads_that_ask_one_mesh_at_once_get_the_same_bits(ground: Arrays) -> None:
    mesh = gb.Mesh(*ground)
    solvers = ["edge-based", "mmp", "dijkstra"]
    expected = {name: gb.Mesh(*ground).distance_matrix(range(40), solver=name) for name in solvers}
    wrong = []

    def ask(first: int) -> None:
        for row in range(40):
            solver = solvers[(first + row) % len(solvers)]
            if not np.array_equal(mesh.distances(row, solver=solver), expected[solver][row]):
                wrong.append((solver, row))

    threads = [threading.Thread(target=ask, args=(first,)) for first in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == []


def resident_bytes() -> int:
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096


def test_queries_and_meshes_do_not_make_the_process_grow() -> None:
    """One array of distances kept per query would need 6 MB more, one mesh kept per query 300 MB."""
    arrays = rough_ground(40)
    mesh = gb.Mesh(*arrays)

    def ask(times: int) -> None:
        for i in range(times):
            mesh.distances(i, limit=2)
            mesh.distance_matrix([i, i + 1, i + 2], threads=2, solver="dijkstra")
            other = gb.Mesh(*arrays)
            other.distance_matrix([i, i + 1], limit=2.0, threads=2)
            with pytest.raises(ValueError):
                other.distances(0, limit=-1)
            gb.defects(other)

    ask(200)
    before = resident_bytes()
    ask(500)
    assert resident_bytes() - before < 5e6


def test_indices_are_signed_so_that_differences_do_not_wrap(mesh: Any) -> None:
    line = mesh.isolines(mesh.distances(0), [3])[0]
    for indices in (mesh.faces, mesh.path(0, 143).faces, line.faces, pickle.loads(pickle.dumps(mesh)).faces):
        assert indices.dtype == np.int64 and (np.diff(indices, axis=0) < 0).any()
    assert mesh.faces is mesh.faces


def test_no_number_of_threads_is_that_of_the_processors(mesh: Any) -> None:
    expected = mesh.distances(3, threads=os.cpu_count(), region_size=20)
    np.testing.assert_array_equal(mesh.distances(3, threads=0, region_size=20), expected)
    np.testing.assert_array_equal(mesh.solve(3, threads=0).distances, mesh.distances(3))
    np.testing.assert_array_equal(mesh.pair_distances([3], [99], threads=0), mesh.distances(3)[[99]])
    assert mesh.prepare(threads=0).solver == mesh.prepare(threads=os.cpu_count()).solver


def test_several_threads_answer_one_source(mesh: Any) -> None:
    regional = mesh.distances(3, threads=3, region_size=20)
    np.testing.assert_allclose(regional, mesh.distances(3), rtol=1e-14)
