"""Converts the arrays of users for the compiled module, without changing them. Raises a ValueError with
a message of one sentence for invalid arrays."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geodesic_bench.errors import NotInMesh

NONE = np.uint32(2**32 - 1)
"""Stands for no vertex or no face."""


def vertex_array(vertices: ArrayLike) -> NDArray[np.float64]:
    """Converts vertices to an array of shape (n, 3). Those of a plane, of shape (n, 2), get z = 0."""
    array = numbers(vertices, "vertices")
    if array.ndim == 2 and array.shape[1] == 2:
        array = np.column_stack([array, np.zeros(len(array))])
    return _rows_of_three(array, "vertices")


def face_array(faces: ArrayLike, vertices: int) -> NDArray[np.uint32]:
    """Converts faces to an array of shape (m, 3), m > 0. They may be flat as in VTK: [3, a, b, c, 3, ...]."""
    array = _integers(faces, "faces")
    if array.ndim == 1 and array.size and array.size % 4 == 0 and (array[::4] == 3).all():
        array = array.reshape(-1, 4)[:, 1:]
    array = _rows_of_three(array, "faces")
    if not array.size or not vertices:
        raise ValueError("a mesh needs at least one vertex and one face")
    outside = (array < 0) | (array >= vertices)
    if outside.any():
        face, corner = np.argwhere(outside)[0]
        raise _not_in_mesh(f"face {face}: vertex", array[face, corner], vertices, "vertices")
    return array.astype(np.uint32, order="C")


def chosen(values: ArrayLike | None, what: str) -> tuple[NDArray[np.uint32], int | None]:
    """Converts the numbers of vertices or faces, or a mask with a boolean for each, to their numbers and the
    length of the mask. The mesh may not be read yet.

    @param what name of the argument, for messages"""
    if values is None:
        return np.zeros(0, np.uint32), None
    kinds = "numbers, or of a boolean for each vertex or face"
    array = _array(values, what, kinds)
    if array.dtype == np.bool_:
        if array.ndim != 1:
            raise ValueError(f"{what} must be a list of {kinds}, not of shape {array.shape}")
        return np.flatnonzero(array).astype(np.uint32), len(array)
    array = _integers(values, what, ".astype(bool) for a mask")
    if array.ndim > 1:
        raise ValueError(f"{what} must be a list of {kinds}, not of shape {array.shape}")
    array = array.reshape(-1)
    outside = (array < 0) | (array >= int(NONE))
    if outside.any():
        raise ValueError(f"{what} must be numbers of vertices or faces from 0, not {array[outside.argmax()]}")
    return array.astype(np.uint32), None


class Place(NamedTuple):
    """A place in space, which stands for the nearest point of the surface. It has a name, since three bare
    numbers might be vertices.

    >>> Place(0.5, 1, 0)
    Place(x=0.5, y=1, z=0)
    """

    x: float
    y: float
    z: float


class Points(NamedTuple):
    """k points of a surface or in space."""

    vertices: NDArray[np.uint32]
    """(k,): the vertex, NONE for a point that is not a vertex."""
    faces: NDArray[np.uint32]
    """(k,): the face, 0 for a vertex, NONE for a place in space."""
    weights: NDArray[np.float64]
    """(k, 3): the weights of the corners of the face, or the coordinates of the place."""


def surface_points(values: Any, what: str, vertices: int, faces: int) -> Points:
    """Converts one point or a list of points.

    @param what name of the points in messages, such as "source"
    @param vertices, faces numbers of vertices and faces of the mesh"""
    if isinstance(values, Place):
        values = numbers(values, f"the coordinates of a {what}").reshape(-1, 3)
    if _names_a_face(values) or _names_faces(values):
        in_faces, weights = _faces_and_weights(values, what, faces)
        return Points(np.full(len(in_faces), NONE), in_faces, weights)
    if isinstance(values, tuple | list) and any(
        isinstance(value, Place) or _names_a_face(value) for value in values
    ):
        return _joined([surface_point(value, what, vertices, faces) for value in values])
    _refuse_wrong_faces_and_weights(values, what)
    array = _array(values, f"{what}s", "vertices, tuples (face, weights) and Place(x, y, z)")
    if _are_places(array):
        none = np.full(len(array), NONE)
        return Points(none, none, array.astype(np.float64))
    given = _vertex_indices(array, what, vertices)
    return Points(given, np.zeros(len(given), np.uint32), np.zeros((len(given), 3)))


def surface_point(value: object, what: str, vertices: int, faces: int) -> Points:
    """Converts exactly one point, like surface_points()."""
    point = surface_points(value, what, vertices, faces)
    if len(point.vertices) != 1:
        raise ValueError(f"a {what} must be one point, not {len(point.vertices)}")
    return point


class PointSets(NamedTuple):
    """k sets of points."""

    all: Points
    """The points of the first set, then those of the second, and so on."""
    begins: NDArray[np.int64]
    """(k + 1,): where each set begins among the points; then their number."""

    def part(self, begin: int, end: int) -> PointSets:
        """Returns some of the sets."""
        some = slice(self.begins[begin], self.begins[end])
        points = Points(self.all.vertices[some], self.all.faces[some], self.all.weights[some])
        return PointSets(points, self.begins[begin : end + 1] - self.begins[begin])


def point_sets(values: Any, what: str, vertices: int, faces: int) -> PointSets:
    """Converts what surface_points() does, to a set a point, and a list of which some items are lists: sets."""
    if isinstance(values, np.ndarray) and values.dtype.kind in "iu" and values.ndim == 2:
        raise ValueError(
            f"{what}s of shape {values.shape} may be sets of vertices or coordinates:"
            " write .tolist() for sets, or .astype(float) for places"
        )
    if isinstance(values, tuple) and not _names_faces(values):  # sets of places are in a list
        _refuse_wrong_faces_and_weights(values, what)
    if not _has_sets(values):
        points = surface_points(values, what, vertices, faces)
        return PointSets(points, np.arange(len(points.vertices) + 1))
    sets = [surface_points(value, what, vertices, faces) for value in values]
    sizes = [len(each.vertices) for each in sets]
    if 0 in sizes:
        raise ValueError(f"{what} {sizes.index(0)} has no point")
    return PointSets(_joined(sets), np.cumsum([0, *sizes]))


def _has_sets(values: Any) -> bool:
    """Whether the values are a list of which some items are lists of points, and not a list of places."""
    if not isinstance(values, tuple | list) or isinstance(values, Place):
        return False
    if _names_a_face(values) or _names_faces(values):
        return False
    others = [value for value in values if not (isinstance(value, Place) or _names_a_face(value))]
    if not any(_is_iterable(value) and not _has_no_dimension(value) for value in others):
        return False
    try:
        return len(others) < len(values) or not _are_places(np.asarray(values))
    except (ValueError, TypeError, RuntimeError):  # of different lengths, or memory of another device
        return True


def _is_iterable(value: object) -> bool:
    return isinstance(value, Iterable) and not isinstance(value, str | bytes)


def _has_no_dimension(value: object) -> bool:
    """Whether the value is an array of one item, or an item of an array."""
    return getattr(value, "shape", None) == ()


def _are_places(array: NDArray[Any]) -> bool:
    return array.dtype.kind == "f" and array.ndim == 2 and array.shape[1] == 3


def _joined(each: list[Points]) -> Points:
    return Points(
        np.concatenate([points.vertices for points in each]),
        np.concatenate([points.faces for points in each]),
        np.concatenate([points.weights for points in each]),
    )


_NO_POINT = "a {} must be a vertex, a tuple (face, three weights), or Place(x, y, z)"
_LISTED = (tuple, list, np.ndarray)


def _names_a_face(point: object) -> bool:
    """Whether the point has the form of a face and weights, with valid values or not. It is a tuple, since a
    list of two is a list of two points."""
    return (
        isinstance(point, tuple)
        and len(point) == 2
        and (not isinstance(point[0], _LISTED) or _has_no_dimension(point[0]))
        and isinstance(point[1], _LISTED)
        and not _has_no_dimension(point[1])
        and not isinstance(point[1], Place)
        and not _names_a_face(point[1])
    )


def _names_faces(points: object) -> bool:
    """Whether the points have the form of two arrays, of k faces and of their weights. Columns of pandas and lists
    are arrays here."""
    if not isinstance(points, tuple) or (arrays := _two_arrays(points)) is None:
        return False
    faces, weights = arrays
    return faces.ndim == 1 and faces.dtype.kind in "iu" and weights.shape == (len(faces), 3)


def _refuse_wrong_faces_and_weights(points: object, what: str) -> None:
    """Raises an error for two arrays of which one has rows: these are neither vertices nor places."""
    if (arrays := _two_arrays(points)) is not None and max(array.ndim for array in arrays) == 2:
        first, second = (f"{array.dtype} of shape {array.shape}" for array in arrays)
        raise ValueError(
            f"many {what}s in faces are a tuple (faces, weights), of integers of shape (k,) and numbers of shape"
            f" (k, 3), not a {type(points).__name__} of {first} and {second}"
        )


def _two_arrays(points: object) -> list[NDArray[Any]] | None:
    """Converts a tuple or list of two arrays, lists or columns of pandas, with at least one dimension."""
    if not isinstance(points, tuple | list) or len(points) != 2:
        return None
    if not all(isinstance(each, list | np.ndarray) or hasattr(each, "__array__") for each in points):
        return None
    try:
        arrays = [_of_numbers(np.asarray(each)) for each in points]
    except (ValueError, TypeError, RuntimeError):  # of different lengths, or memory of another device
        return None
    return arrays if all(array.ndim for array in arrays) else None


def _faces_and_weights(
    points: Any, what: str, faces: int
) -> tuple[NDArray[np.uint32], NDArray[np.float64]]:
    """Converts a face and its weights, or k of them, to arrays of shape (k,) and (k, 3)."""
    given = _integers(points[0], f"the face of a {what}")
    weights = numbers(points[1], f"the weights of a {what}")
    if weights.shape != (*given.shape, 3):
        raise ValueError(_NO_POINT.format(what))
    given, weights = given.reshape(-1), weights.reshape(-1, 3)
    outside = (given < 0) | (given >= faces)
    if outside.any():
        raise _not_in_mesh(f"{what} face", given[outside.argmax()], faces, "faces")
    wrong = ~(np.isfinite(weights) & (weights >= 0)).all(axis=1) | ~weights.any(axis=1)
    if wrong.any():
        raise ValueError(
            f"the weights of a {what} must be finite, none negative, and not all 0,"
            f" not {tuple(weights[wrong.argmax()].tolist())}"
        )
    return given.astype(np.uint32), weights


def _vertex_indices(values: ArrayLike, what: str, vertices: int) -> NDArray[np.uint32]:
    """Converts vertex indices to an array of shape (k,)."""
    array = _integers(
        values, f"{what} vertices", "Place(x, y, z) for a place", "np.flatnonzero(mask) for a mask"
    )
    if array.ndim > 1:
        raise ValueError(
            f"{what} vertices must be a list of indices, not of shape {array.shape};"
            " coordinates of places must be floats"
        )
    array = array.reshape(-1)
    outside = (array < 0) | (array >= vertices)
    if outside.any():
        raise _not_in_mesh(f"{what} vertex", array[outside.argmax()], vertices, "vertices")
    return array.astype(np.uint32)


def _not_in_mesh(name: str, index: Any, count: int, kind: str) -> NotInMesh:
    return NotInMesh(
        f"{name} {index} is not in the mesh of {count} {kind}, numbered from 0 to {count - 1}"
    )


def number(value: Any, what: str) -> float:
    array = _array(value, what, "numbers")
    if array.ndim or array.dtype.kind not in "iuf":
        raise ValueError(f"{what} must be a number, not {value!r}")
    return float(array)


def numbers(values: ArrayLike, what: str) -> NDArray[np.float64]:
    array = _array(values, what, "numbers")
    if array.dtype.kind not in "iuf" and array.size:
        raise ValueError(f"{what} must be real numbers, not {_kind_of(array)}")
    return array.astype(np.float64, order="C", copy=False)


def _integers(values: ArrayLike, what: str, of_floats: str = "", of_booleans: str = "") -> NDArray[Any]:
    """Returns an array of any integer type, or of Python integers if they are too large for these. Floats are
    refused even if they are whole: they may be coordinates.

    @param of_floats, of_booleans what else to write for these"""
    array = _array(values, what, "integers")
    if not array.size:
        return array.astype(np.int64)
    of_python = array.dtype == object and all(type(value) is int for value in array.flat)
    if array.dtype.kind not in "iu" and not of_python:
        ways = [of_booleans] if array.dtype.kind == "b" and of_booleans else []
        if array.dtype.kind == "f":
            whole = bool((array == np.floor(array)).all())
            ways = [way for way in (whole and ".astype(int) for indices", of_floats) if way]
        hint = f": write {', or '.join(ways)}" if ways else ""
        raise ValueError(f"{what} must be integers, not {_kind_of(array)}{hint}")
    return array


def _kind_of(array: NDArray[Any]) -> str:
    """Returns what the items are, in the words of Python where NumPy's would be codes: "text", not "<U7"; and how to
    join those that are arrays."""
    if array.dtype.kind in "US":
        return "text"
    if array.dtype.names:
        columns = ", ".join(f"a[{name!r}]" for name in array.dtype.names[:3])
        return f"records: write np.stack([{columns}], axis=1)"
    if array.dtype != object:
        return str(array.dtype)
    kinds = [type(value).__name__ for value in array.flat if type(value) is not int]
    if not kinds:
        return "integers of Python"
    join = ": join them with np.stack" if {"ndarray", "list"}.issuperset(kinds) else ""
    return "None" if kinds[0] == "NoneType" else f"objects of type {kinds[0]}{join}"


def _array(values: Any, what: str, kind: str) -> NDArray[Any]:
    if isinstance(values, np.ma.MaskedArray) and np.any(values.mask):  # asarray would drop the mask
        raise ValueError(f"{what} must not have masked entries: leave them out, or call .filled(value)")
    try:
        array = np.asarray(values)
    except (ValueError, TypeError, RuntimeError):  # rows of different lengths, or memory of another device
        raise ValueError(f"{what} must be an array of {kind}{_remedy(values)}") from None
    if array.ndim == 0 and array.dtype == object and (remedy := _remedy(values)):
        raise ValueError(f"{what} must be an array of {kind}{remedy}")
    return _of_numbers(array)


def _of_numbers(array: NDArray[Any]) -> NDArray[Any]:
    """Returns an array of objects that are all numbers, or all booleans, with their type: the nullable columns of
    pandas become arrays of objects. Integers of Python remain if they are too large for a type of integers."""
    if array.dtype != object or not array.size:
        return array
    kinds = {type(value) for value in array.flat}
    if not kinds <= {bool, np.bool_}:
        if bool in kinds or not all(issubclass(kind, int | float | np.integer | np.floating) for kind in kinds):
            return array
    typed = np.array(array.tolist())
    return array if kinds == {int} and typed.dtype.kind not in "iu" else typed


def _remedy(values: Any) -> str:
    """Returns what to do with an object that NumPy cannot convert, for the end of a message; empty if unknown."""
    kind = type(values).__name__
    if hasattr(values, "detach"):
        return f", not a {kind} on a device or with a gradient: call .detach().cpu().numpy()"
    if hasattr(values, "__cuda_array_interface__"):
        call = ".copy_to_host()" if hasattr(values, "copy_to_host") else ".get()"
        return f", not a {kind} on a GPU: call {call}"
    if hasattr(values, "points"):
        return f", not a {kind}: pass its .points"
    if _is_iterable(values) and not isinstance(values, _LISTED):
        return f", not a {kind}: call list() first"
    return ""


def _rows_of_three(array: NDArray[Any], what: str) -> NDArray[Any]:
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{what} must have the shape (n, 3), not {array.shape}{_shape_remedy(array, what)}")
    return array


def _shape_remedy(array: NDArray[Any], what: str) -> str:
    """Returns what to do with rows of another shape, for the end of a message; empty if unknown."""
    if array.ndim == 2 and array.shape[0] == 3:
        return ": transpose them with .T"
    if what != "faces":
        return ""
    if array.ndim == 1 and array.size:
        return "; a flat array is [3, a, b, c, 3, ...], of triangles only"
    if array.ndim == 2 and array.shape[1] == 4:
        return ": leave out the first column" if (array[:, 0] == 3).all() else ": divide the quadrangles into triangles"
    return ""
