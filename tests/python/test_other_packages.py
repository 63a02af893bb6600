"""Meshes of other packages are their arrays. Stand-ins have the attributes of their objects, since none is installed."""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
from python_package import Arrays

gb = pytest.importorskip("geodesic_bench")


class Tensor:
    def __init__(self, array: Any) -> None:
        self.array = array

    def cpu(self) -> Tensor:
        return self

    def numpy(self) -> Any:
        return self.array


class Gifti:
    def __init__(self, *arrays: Any) -> None:
        self.arrays = dict(zip(("pointset", "triangle"), arrays, strict=True))

    def agg_data(self, names: tuple[str, ...]) -> tuple[Any, ...]:
        return tuple(self.arrays[name] for name in names)


def flat(faces: Any) -> Any:
    """Faces as VTK has them."""
    return np.insert(faces, 0, 3, axis=1).reshape(-1)


def meshio_mesh(vertices: Any, faces: Any) -> Any:
    return SimpleNamespace(points=vertices, cells=[SimpleNamespace(type="triangle", data=faces)])


def test_an_object_of_another_package_is_its_arrays(ground: Arrays) -> None:
    vertices, faces = ground
    triangles = np.full(len(faces), 5, np.uint8)
    others: list[Any] = [
        (vertices, faces),  # potpourri3d, libigl, nibabel.freesurfer
        SimpleNamespace(vertices=vertices.tolist(), triangles=faces.tolist()),  # Open3D
        SimpleNamespace(
            vertex=SimpleNamespace(positions=Tensor(vertices)), triangle=SimpleNamespace(indices=Tensor(faces))
        ),
        SimpleNamespace(points=vertices, faces=flat(faces)),  # PyVista
        SimpleNamespace(points=vertices, cells=flat(faces), celltypes=triangles),
        Gifti(vertices, faces),
    ]
    for mesh in (*map(gb.Mesh, others), gb.Mesh(vertices, flat(faces))):
        np.testing.assert_array_equal(mesh.vertices, vertices)
        np.testing.assert_array_equal(mesh.faces, faces)


def test_vertices_of_a_plane_have_a_height_of_zero() -> None:
    mesh = gb.Mesh([[0, 0], [3, 0], [0, 4]], [[0, 1, 2]])
    np.testing.assert_array_equal(mesh.vertices, [[0, 0, 0], [3, 0, 0], [0, 4, 0]])
    assert mesh.distances(1).tolist() == [3, 0, 5]


@pytest.mark.parametrize(
    ("other", "sentence"),
    [
        (SimpleNamespace(points=np.eye(3), faces=[4, 0, 1, 2, 0]), "faces must be triangles: call .triangulate()"),
        (
            SimpleNamespace(points=np.eye(3), cells=[3, 0, 1, 2], celltypes=[9]),
            "cells must be triangles: call .extract_surface().triangulate()",
        ),
        (Gifti((), ()), "the GIFTI file has no surface: read the .surf.gii file"),
        (SimpleNamespace(geometry={}, graph=None), "a SimpleNamespace has no vertices and faces: call .to_mesh()"),
        (
            SimpleNamespace(GetPoints=None, GetPolys=None),
            "a SimpleNamespace has no vertices and faces: pass pyvista.wrap(mesh)",
        ),
        (
            SimpleNamespace(vertex_matrix=None, face_matrix=None),
            "a SimpleNamespace has no vertices and faces: pass (mesh.vertex_matrix(), mesh.face_matrix())",
        ),
    ],
)
def test_an_object_without_triangles_is_refused_with_what_to_call(other: Any, sentence: str) -> None:
    with pytest.raises(ValueError) as refused:
        gb.Mesh(other)
    assert str(refused.value) == sentence


def stand_in(name: str, monkeypatch: pytest.MonkeyPatch, **functions: Any) -> None:
    module = ModuleType(name)
    vars(module).update(functions)
    monkeypatch.setitem(sys.modules, name, module)


def test_files_that_another_package_reads_are_read_by_their_suffix(
    ground: Arrays, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def load(file: str, **options: Any) -> Any:
        assert options == {"force": "mesh", "process": False}  # which keeps the numbers of the vertices
        return SimpleNamespace(vertices=ground[0], faces=ground[1])

    stand_in("meshio", monkeypatch, read=lambda _: meshio_mesh(*ground))
    stand_in("pyvista", monkeypatch, read=lambda _: SimpleNamespace(points=ground[0], faces=flat(ground[1])))
    stand_in("trimesh", monkeypatch, load=load)
    stand_in("nibabel", monkeypatch, load=lambda _: Gifti(*ground))
    stand_in("nibabel.freesurfer", monkeypatch, read_geometry=lambda _: (*ground, "stamp"))
    for name in ("a.vtk", "a.VTU", "a.msh", "a.vtp", "a.glb", "lh.central.surf.gii", "lh.pial"):
        file = tmp_path / name
        file.write_text("")
        np.testing.assert_array_equal(gb.read_mesh(file).faces, ground[1])


def test_a_file_of_another_package_is_checked_and_repaired_as_every_file(
    ground: Arrays, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "twice.vtu"
    file.write_text("")
    stand_in("meshio", monkeypatch, read=lambda _: meshio_mesh(ground[0], np.vstack([ground[1], ground[1][:1]])))
    with pytest.raises(ValueError, match=r"twice\.vtu: distances would be meaningless: 1 repeated .*use repair=True$"):
        gb.read_mesh(file)
    with pytest.warns(UserWarning, match=r"twice\.vtu: 1 repeated face .*; repair: "):
        np.testing.assert_array_equal(gb.read_mesh(file, repair=True).faces, ground[1])
    stand_in("meshio", monkeypatch, read=lambda _: meshio_mesh(ground[0], [[0, 1, 999]]))
    with pytest.raises(ValueError, match=r"^[^:]*twice\.vtu: face 0: vertex 999 is not in the mesh of 144 vertices"):
        gb.read_mesh(file)


def test_a_file_that_cannot_be_read_is_refused_with_the_package_and_what_to_do(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    modules: Any = sys.modules
    for package in ("meshio", "pyvista", "nibabel", "trimesh"):
        monkeypatch.setitem(modules, package, None)  # as if it were not installed
    packages = {"a.vtu": "meshio or pyvista", "a.vtp": "pyvista", "lh.pial": "nibabel", "a.glb": "trimesh"}
    for name, package in packages.items():
        (tmp_path / name).write_text("")
        with pytest.raises(ValueError) as refused:
            gb.read_mesh(tmp_path / name)
        said = f"{tmp_path / name}: needs the package {package} (pip install {package.split()[0]}); or convert it to OBJ, OFF, PLY or STL"
        assert str(refused.value) == said

    def exit_with(_: str) -> None:
        sys.exit(1)

    def fail(_: str) -> None:
        raise KeyError("points")

    for failing, why in ((exit_with, ", and printed the reason; convert it"), (fail, ": 'points'")):
        stand_in("meshio", monkeypatch, read=failing)
        with pytest.raises(ValueError) as refused:
            gb.read_mesh(tmp_path / "a.vtu")
        assert str(refused.value) == f"{tmp_path / 'a.vtu'}: meshio cannot read it{why}"
    (tmp_path / "a.vtk").write_text("")
    stand_in("meshio", monkeypatch, read=exit_with)
    with pytest.raises(ValueError, match=r"a\.vtk: meshio cannot read it, .*; convert it, or install pyvista$"):
        gb.read_mesh(tmp_path / "a.vtk")
    with pytest.raises(ValueError, match=r"b\.vtu: no such file; check the path$"):
        gb.read_mesh(tmp_path / "b.vtu")
