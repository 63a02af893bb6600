"""Meshes of other packages: their objects, and the files that they read."""

from __future__ import annotations

import importlib
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

Arrays = tuple[Any, Any]
"""Vertices and faces, which vertex_array() and face_array() check."""


def arrays_of(mesh: Any) -> Arrays:
    """Returns the vertices and faces of an object of another package, or of a tuple of both."""
    if isinstance(mesh, tuple) and len(mesh) == 2:  # of potpourri3d, libigl, nibabel
        return mesh[0], mesh[1]
    for is_of, arrays in _KINDS:
        if all(hasattr(mesh, name) for name in is_of.split()):
            return arrays(mesh)
    kind = type(mesh).__name__
    for is_of, remedy in _REMEDIES.items():
        if all(hasattr(mesh, name) for name in is_of.split()):
            raise ValueError(f"a {kind} has no vertices and faces: {remedy}")
    raise ValueError(
        "a mesh is vertices and faces, or an object that has them, or points and cells; read_mesh reads files"
    )


def _of_meshio(mesh: Any) -> Arrays:
    if not all(hasattr(block, "type") for block in mesh.cells):
        return mesh.points, mesh.cells
    blocks = [block for block in mesh.cells if block.type not in ("vertex", "line")]
    for block in blocks:
        if block.type != "triangle":
            raise ValueError(
                f"cells must be triangles, not {block.type}: convert them, or give gb.Mesh the"
                " triangles only, mesh.points and mesh.cells_dict['triangle']"
            )
    return mesh.points, np.concatenate([np.zeros((0, 3), np.int64)] + [b.data for b in blocks])


def _of_unstructured_grid(mesh: Any) -> Arrays:
    triangle = 5  # VTK_TRIANGLE
    if (np.asarray(mesh.celltypes) != triangle).any():
        raise ValueError("cells must be triangles: call .extract_surface().triangulate()")
    return mesh.points, mesh.cells


def _of_poly_data(mesh: Any) -> Arrays:
    faces = np.asarray(mesh.faces)
    if faces.ndim == 1 and (faces.size % 4 or (faces[::4] != 3).any()):
        raise ValueError("faces must be triangles: call .triangulate()")
    return mesh.points, faces


def _of_gifti(mesh: Any) -> Arrays:
    vertices, faces = mesh.agg_data(("pointset", "triangle"))
    if not len(vertices):
        raise ValueError("the GIFTI file has no surface: read the .surf.gii file")
    return vertices, faces


def _on_host(tensor: Any) -> Any:
    return tensor.cpu().numpy()


_KINDS: list[tuple[str, Callable[[Any], Arrays]]] = [
    ("vertices faces", lambda mesh: (mesh.vertices, mesh.faces)),  # trimesh
    ("vertices triangles", lambda mesh: (mesh.vertices, mesh.triangles)),  # Open3D
    ("vertex triangle", lambda mesh: (_on_host(mesh.vertex.positions), _on_host(mesh.triangle.indices))),  # its tensors
    ("points cells celltypes", _of_unstructured_grid),  # PyVista
    ("points faces", _of_poly_data),  # PyVista
    ("points cells", _of_meshio),
    ("agg_data", _of_gifti),  # nibabel
]
"""For each kind of object the attributes by which it is known, and its arrays."""

_REMEDIES = {
    "geometry graph": "call .to_mesh()",  # a scene of trimesh
    "GetPoints GetPolys": "pass pyvista.wrap(mesh)",  # VTK
    "vertex_matrix face_matrix": "pass (mesh.vertex_matrix(), mesh.face_matrix())",  # PyMeshLab
}


def _by_meshio(file: str) -> Any:
    return importlib.import_module("meshio").read(file)


def _by_pyvista(file: str) -> Any:
    return importlib.import_module("pyvista").read(file)


def _by_trimesh(file: str) -> Any:
    """Without `process`, which joins and renumbers vertices."""
    return importlib.import_module("trimesh").load(file, force="mesh", process=False)


def _by_nibabel(file: str) -> Any:
    if file.lower().endswith(".gii"):
        return importlib.import_module("nibabel").load(file)
    return importlib.import_module("nibabel.freesurfer").read_geometry(file)[:2]


_READERS: dict[str, tuple[str, ...]] = {
    ".vtk": ("pyvista", "meshio"),  # meshio reads no surfaces (POLYDATA) in this format
    ".vtu": ("meshio", "pyvista"),
    ".vtp": ("pyvista",),
    **dict.fromkeys([".msh", ".mesh", ".meshb", ".med", ".xdmf"], ("meshio",)),
    **dict.fromkeys([".glb", ".gltf", ".3mf"], ("trimesh",)),
    **dict.fromkeys([".gii", ".pial", ".white", ".inflated", ".smoothwm", ".sphere", ".orig"], ("nibabel",)),
}
"""The packages that read files, by suffix. The suffixes of FreeSurfer are the names of surfaces, as in lh.pial."""

_READ = {"meshio": _by_meshio, "nibabel": _by_nibabel, "pyvista": _by_pyvista, "trimesh": _by_trimesh}


def read_by_other_package(file: str | os.PathLike[str]) -> Arrays | None:
    """Returns the arrays of a file whose suffix another package reads; None for other files and missing ones.

    @raises ValueError if no such package is installed, or it cannot read the file; without the file's name"""
    name = os.fspath(file)
    packages = _READERS.get(Path(name).suffix.lower(), ())
    if not packages or not Path(name).is_file():
        return None
    missing = []
    for package in packages:
        try:
            mesh = _READ[package](name)
        except ImportError as error:  # of the package, or of one that it needs for this format
            missing.append((error.name or package).partition(".")[0])
            continue
        except SystemExit:  # meshio prints the reason and ends the process
            hint = f", or install {missing[0]}" if missing else ""
            raise ValueError(f"{package} cannot read it, and printed the reason; convert it{hint}") from None
        except Exception as error:
            why = str(error).strip().partition("\n")[0]
            raise ValueError(f"{package} cannot read it: {why or type(error).__name__}") from error
        return arrays_of(mesh)
    needed = " or ".join(missing)
    raise ValueError(f"needs the package {needed} (pip install {missing[0]}); or convert it to OBJ, OFF, PLY or STL")
