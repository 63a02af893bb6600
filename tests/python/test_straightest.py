"""Straightest lines, polar coordinates, and files of a mesh with its distances."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

gb = pytest.importorskip("geodesic_bench")


@pytest.fixture(scope="module")
def plane() -> Any:
    x, y = np.divmod(np.arange(100), 10)
    corner = np.flatnonzero((x < 9) & (y < 9))[:, None]
    faces = np.concatenate([corner + [0, 10, 11], corner + [0, 11, 1]])
    return gb.Mesh(np.stack([x, y, 0 * x], axis=1), faces)


def test_a_line_of_a_plane_is_straight_in_the_direction_of_a_vector(plane: Any) -> None:
    for begin in (44, (40, (1, 1, 1)), gb.Place(4.3, 4.2, 0)):
        line = plane.trace(begin, [3, 4, 7], 2.5)
        assert line.points[-1] - line.points[0] == pytest.approx([1.5, 2, 0], abs=1e-12)
        assert line.length == pytest.approx(2.5) and not line.ends_at_boundary
        assert len(line.faces) == len(line.points) - 1
    assert plane.trace(44, [1, 0, 0], 100).ends_at_boundary


def test_polar_coordinates_lead_straight_lines_to_their_vertices(plane: Any) -> None:
    at: NDArray[np.float64] = plane.vertices
    for source in (44, (40, (1, 1, 1))):
        lengths, angles = plane.log_map(source)
        assert lengths == pytest.approx(plane.distances([source]), abs=1e-13)
        for vertex in (0, 7, 45, 99):
            line = plane.trace(source, angles[vertex], lengths[vertex])
            assert line.points[-1] == pytest.approx(at[vertex], abs=1e-12)
    assert plane.total_angle(44) == pytest.approx(2 * math.pi)
    assert plane.total_angle(0) == pytest.approx(math.pi / 2)


def test_bad_directions_are_refused(plane: Any) -> None:
    for direction, why in {(0, 0, 1): "perpendicular", (0, 0): "shape", (0, 0, 0): "not 0", math.nan: "finite"}.items():
        with pytest.raises(ValueError, match=why):
            plane.trace(44, direction, 1)
    with pytest.raises(ValueError, match="length of a line"):
        plane.trace(44, 0, -1)
    with pytest.raises(ValueError, match="does not remember paths"):
        plane.log_map(44, solver="dijkstra")


def test_a_field_is_saved_with_its_mesh(plane: Any, tmp_path: Path) -> None:
    field = plane.solve(44)
    field.save(tmp_path / "d.ply")
    field.save(tmp_path / "d.vtk")
    again = gb.read_mesh(tmp_path / "d.ply")
    assert (again.vertices == plane.vertices).all() and (again.faces == plane.faces).all()
    header, _, body = (tmp_path / "d.ply").read_bytes().partition(b"end_header\n")
    assert b"property double quality" in header
    rows = np.frombuffer(body[: 100 * 32], "<f8").reshape(100, 4)
    assert (rows[:, 3] == field.distances).all()
    scalars = (tmp_path / "d.vtk").read_bytes().partition(b"LOOKUP_TABLE default\n")[2]
    assert (np.frombuffer(scalars[:800], ">f8") == field.distances).all()
    with pytest.raises(ValueError, match=r"written as \.ply or \.vtk"):
        field.save(tmp_path / "d.obj")
