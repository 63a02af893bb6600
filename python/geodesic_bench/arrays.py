"""What users give as arrays, as the compiled module takes it: converted without a change to theirs,
or refused with one sentence."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

OUT_OF_RANGE = np.uint32(2**32 - 1)
"""Is not a vertex of any mesh."""


def vertex_array(vertices: ArrayLike) -> NDArray[np.float64]:
    """Of shape (n, 3)."""
    return _rows_of_three(numbers(vertices, "vertices"), "vertices")


def face_array(faces: ArrayLike, vertices: int) -> NDArray[np.uint32]:
    """Of shape (m, 3), m > 0. An index that is not there becomes one that is not in any mesh."""
    array = _rows_of_three(_integers(faces, "faces"), "faces")
    if not array.size:
        raise ValueError("a mesh needs at least one face")
    if array.min() < 0 or array.max() >= vertices:
        array = np.where((array < 0) | (array >= vertices), OUT_OF_RANGE, array)
    return array.astype(np.uint32, order="C")


def vertex_indices(values: ArrayLike, what: str, vertices: int) -> NDArray[np.uint32]:
    """Of shape (k,).

    @param what they are: "source"
    @param vertices of the mesh"""
    array = _integers(values, f"{what} vertices")
    if array.ndim > 1:
        raise ValueError(f"{what} vertices must be a list of indices, not of shape {array.shape}")
    array = array.reshape(-1)
    outside = (array < 0) | (array >= vertices)
    if outside.any():
        index = array[outside.argmax()]
        raise ValueError(f"{what} vertex {index} is not in the mesh of {vertices} vertices")
    return array.astype(np.uint32)


def surface_point(
    point: object, what: str, vertices: int, faces: int
) -> tuple[int, int, tuple[float, float, float]]:
    """A vertex, a face and weights; the vertex is OUT_OF_RANGE for a point in a face.

    @param what it is: "source"
    @param vertices, faces of the mesh"""
    wrong = f"a {what} must be a vertex, or a face and three weights"
    if not isinstance(point, tuple | list):
        vertex = vertex_indices(point, what, vertices)  # type: ignore[arg-type]
        if vertex.size != 1:
            raise ValueError(wrong)
        return int(vertex[0]), 0, (0, 0, 0)
    if len(point) != 2:
        raise ValueError(wrong)
    face = _integers(point[0], f"the face of a {what}")
    weights = numbers(point[1], f"the weights of a {what}")
    if face.ndim or weights.shape != (3,):
        raise ValueError(wrong)
    if not 0 <= face < faces:
        raise ValueError(f"{what} face {face} is not in the mesh of {faces} faces")
    first, second, third = weights.tolist()
    return int(OUT_OF_RANGE), int(face), (first, second, third)


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
