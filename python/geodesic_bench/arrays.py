"""What users give as arrays, as the compiled module takes it: converted without a change to theirs,
or refused with one sentence."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

OUT_OF_RANGE = np.uint32(2**32 - 1)
"""Is not a vertex of any mesh."""


def vertex_array(vertices: ArrayLike) -> NDArray[np.float64]:
    """Of shape (n, 3)."""
    return _rows_of_three(numbers(vertices, "vertices"), "vertices")


def face_array(faces: ArrayLike, vertices: int) -> NDArray[np.uint32]:
    """Of shape (m, 3), m > 0."""
    array = _rows_of_three(_integers(faces, "faces"), "faces")
    if not array.size:
        raise ValueError("a mesh needs at least one face")
    outside = (array < 0) | (array >= vertices)
    if outside.any():
        face, corner = divmod(int(outside.argmax()), 3)
        raise ValueError(
            f"face {face} names vertex {array[face, corner]}, and the mesh has {vertices} vertices,"
            " counted from 0"
            + (": these faces count from 1" if array.min() == 1 and array.max() == vertices else "")
        )
    return array.astype(np.uint32, order="C")


class Points(NamedTuple):
    """Points of a surface, k of them."""

    vertices: NDArray[np.uint32]
    """(k,): OUT_OF_RANGE for a point in a face."""
    faces: NDArray[np.uint32]
    """(k,): 0 for a vertex."""
    weights: NDArray[np.float64]
    """(k, 3): of the corners of the face."""


class Surface(NamedTuple):
    """What points must lie on."""

    vertices: int
    faces: int
    """How many there are."""
    nearest: Callable[[NDArray[np.float64], str], Points]
    """The nearest points to places in space, of shape (k, 3); told what they are."""


def surface_points(values: object, what: str, on: Surface) -> Points:
    """One point, or a list of them.

    @param what they are: "source"
    """
    if _names_a_face(values):
        return _point_in_face(values, what, on.faces)
    places = _places(values)
    if places is not None:
        return on.nearest(places, what)
    if isinstance(values, tuple | list) and any(_is_no_vertex(each) for each in values):
        points = [surface_point(each, what, on) for each in values]
        return Points(*(np.concatenate(arrays) for arrays in zip(*points, strict=True)))
    given = _vertex_indices(values, what, on.vertices)  # type: ignore[arg-type]
    return Points(given, np.zeros(len(given), np.uint32), np.zeros((len(given), 3)))


def surface_point(value: object, what: str, on: Surface) -> Points:
    """One point; otherwise as surface_points."""
    places = _places([value])
    if places is not None:
        return on.nearest(places, what)
    point = surface_points(value, what, on)
    if len(point.vertices) != 1:
        raise ValueError(_NO_POINT.format(what))
    return point


_NO_POINT = "a {} must be a vertex, a face and three weights, or a place in space"


def _places(values: object) -> NDArray[np.float64] | None:
    """Of shape (k, 3); none where the values are no coordinates. Three whole numbers are
    vertices."""
    try:
        array = np.asarray(values)
    except (ValueError, TypeError):
        return None
    if array.shape == (3,) and array.dtype.kind == "f":
        array = array[np.newaxis]
    if array.dtype.kind not in "iuf" or array.ndim != 2 or array.shape[1] != 3:
        return None
    return array.astype(np.float64, order="C", copy=False)


def _is_no_vertex(point: object) -> bool:
    return _names_a_face(point) or _places([point]) is not None


def _names_a_face(point: object) -> bool:
    """Whether it is a pair of a face and weights, right or wrong."""
    listed = (tuple, list, np.ndarray)
    return (
        isinstance(point, tuple | list)
        and len(point) == 2
        and not isinstance(point[0], listed)
        and isinstance(point[1], listed)
        and not _names_a_face(point[1])
    )


def _point_in_face(point: Any, what: str, faces: int) -> Points:
    face = _integers(point[0], f"the face of a {what}")
    weights = numbers(point[1], f"the weights of a {what}")
    if face.ndim or weights.shape != (3,):
        raise ValueError(_NO_POINT.format(what))
    if not 0 <= face < faces:
        raise ValueError(f"{what} face {face} is not in the mesh of {faces} faces")
    if not (np.isfinite(weights).all() and weights.min() >= 0 and weights.any()):
        raise ValueError(
            f"the weights of a {what} must be finite, none negative, and not all 0,"
            f" not {tuple(weights.tolist())}"
        )
    return Points(np.array([OUT_OF_RANGE]), np.array([face], np.uint32), weights[np.newaxis])


def _vertex_indices(values: ArrayLike, what: str, vertices: int) -> NDArray[np.uint32]:
    """Of shape (k,)."""
    array = _integers(values, f"{what} vertices")
    if array.ndim > 1:
        raise ValueError(f"{what} vertices must be a list of indices, not of shape {array.shape}")
    array = array.reshape(-1)
    outside = (array < 0) | (array >= vertices)
    if outside.any():
        index = array[outside.argmax()]
        raise ValueError(f"{what} vertex {index} is not in the mesh of {vertices} vertices")
    return array.astype(np.uint32)


def numbers(values: ArrayLike, what: str) -> NDArray[np.float64]:
    array = _array(values, what, "numbers")
    if array.dtype.kind not in "iuf" and array.size:
        raise ValueError(f"{what} must be real numbers, not {array.dtype}")
    return array.astype(np.float64, order="C", copy=False)


def _integers(values: ArrayLike, what: str) -> NDArray[Any]:
    """Of any integer type; of Python's own where that is not enough."""
    array = _array(values, what, "integers")
    if not array.size:
        return array.astype(np.int64)
    of_python = array.dtype == object and all(type(value) is int for value in array.flat)
    if array.dtype.kind not in "iu" and not of_python:
        raise ValueError(f"{what} must be integers, not {array.dtype}")
    return array


def _array(values: ArrayLike, what: str, of: str) -> NDArray[Any]:
    try:
        return np.asarray(values)
    except (ValueError, TypeError):  # rows of different lengths
        raise ValueError(f"{what} must be an array of {of}") from None


def _rows_of_three(array: NDArray[Any], what: str) -> NDArray[Any]:
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{what} must have the shape (n, 3), not {array.shape}")
    return array
