"""The renderer: nearer surfaces hide farther surfaces and lines."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from synthetic import Geometry, plane, sphere, torus

from plots import style, surface
from plots.camera import Camera, Floats, close_up, framing, looking
from plots.surface import Surface, draw_lines, draw_surface, edges, shade
from plots.wavefronts import draw_points
from plots.zbuffer import NOTHING, ZBuffer, z_buffer

FRONT = np.eye(3)
"""View down the z axis: x is right, y up."""


def square(side: float, z: float) -> Geometry:
    corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
    vertices = np.column_stack([side / 2 * np.array(corners), np.full(4, z)])
    return vertices, np.array([[0, 1, 2], [0, 2, 3]])


def together(*parts: Geometry) -> Geometry:
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in parts)])
    faces = [part[1] + start for part, start in zip(parts, starts, strict=False)]
    return np.vstack([vertices for vertices, _ in parts]), np.vstack(faces)


def buffer_of(geometry: Geometry, axes: Floats = FRONT, width: int = 200) -> ZBuffer:
    vertices, faces = geometry
    return z_buffer(vertices, faces, framing(axes, vertices), width)


def length_of(pieces: Floats) -> float:
    return float(np.linalg.norm(pieces[:, 1] - pieces[:, 0], axis=1).sum())


@pytest.mark.parametrize("nearer_first", [True, False])
def test_a_nearer_square_hides_a_farther_one_in_any_order(nearer_first: bool) -> None:
    near, far = square(1, 0.5), square(2, -0.5)
    order = [near, far] if nearer_first else [far, near]
    buffer = buffer_of(together(*order))
    is_near = buffer.face < 2 if nearer_first else buffer.face >= 2
    is_near &= buffer.face != NOTHING
    rows, columns = buffer.face.shape
    assert is_near[rows // 4 + 5 : -rows // 4 - 5, columns // 4 + 5 : -columns // 4 - 5].all()
    share = is_near.sum() / (buffer.face != NOTHING).sum()
    assert share == pytest.approx(1 / 4, abs=0.01)


def test_faces_that_intersect_are_told_apart_pixel_by_pixel() -> None:
    """No order of whole faces could show this."""
    left_up, right_up = square(2, 0), square(2, 0)
    left_up[0][:, 2], right_up[0][:, 2] = -left_up[0][:, 0], right_up[0][:, 0]
    buffer = buffer_of(together(left_up, right_up))
    middle = buffer.face[:, buffer.face.shape[1] // 2 - 60 : buffer.face.shape[1] // 2 + 60]
    inside = middle[20:-20]
    assert (inside[:, :58] < 2).all() and (inside[:, 62:] >= 2).all()


def test_the_outline_of_a_sphere_is_a_disc_from_everywhere() -> None:
    ball = sphere(40, 80)
    for up, azimuth, elevation in product(range(3), (0, 50), (-30, 0, 70)):
        buffer = buffer_of(ball, looking(up, azimuth, elevation))
        y, x = np.nonzero(buffer.face != NOTHING)
        left, _, bottom, _ = buffer.camera.extent
        radii = np.hypot((x + 0.5) * buffer.pixel + left, (y + 0.5) * buffer.pixel + bottom)
        assert radii.max() < 1
        area = len(x) * buffer.pixel**2
        assert area == pytest.approx(np.pi, rel=0.01)


def test_axes_are_a_rotation_and_up_is_up() -> None:
    for up, azimuth, elevation in product(range(3), (0, 20, 200), (0, 18, 50)):
        axes = looking(up, azimuth, elevation)
        assert axes @ axes.T == pytest.approx(np.eye(3))
        assert np.linalg.det(axes) == pytest.approx(1)
        right, upwards, towards = axes[:, up]
        assert right == pytest.approx(0) and upwards > 0
        assert towards == pytest.approx(np.sin(np.radians(elevation)))


def test_half_of_a_great_circle_is_seen_and_lines_behind_the_surface_vanish() -> None:
    vertices, faces = sphere(39, 80)
    buffer = buffer_of((vertices, faces), width=400)
    meridian = np.r_[0, 1 + 80 * np.arange(39), len(vertices) - 1]
    lines = np.stack([vertices[meridian[:-1]], vertices[meridian[1:]]], axis=1)
    assert length_of(buffer.visible_pieces(lines[:20])) == pytest.approx(1, abs=0.03)  # end-on
    assert len(buffer.visible_pieces(lines[21:])) == 0


def test_all_edges_of_a_plane_are_seen_from_both_sides_and_at_a_slant() -> None:
    vertices, faces = plane(12, 12)
    lines = vertices[edges(faces)]
    for azimuth, elevation in product((0, 35, 110), (-80, -20, 10, 60)):
        axes = looking(2, azimuth, elevation)
        buffer = buffer_of((vertices, faces), axes)
        flat = lines @ axes[:2].T
        assert length_of(buffer.visible_pieces(lines)) == pytest.approx(length_of(flat), rel=0.01)


def test_a_line_is_cut_where_a_nearer_square_begins() -> None:
    near, far = square(1, 0.5), square(2, -0.5)
    line = np.array([[[-1.0, 0.1, -0.5], [1.0, 0.1, -0.5]]])
    pieces = buffer_of(together(near, far)).visible_pieces(line)
    assert pieces[:, :, 0] == pytest.approx(np.array([[-1, -0.5], [0.5, 1]]), abs=0.03)
    assert pieces[:, :, 1] == pytest.approx(0.1)


def test_what_is_outside_the_picture_is_not_seen() -> None:
    vertices, faces = plane(5, 5)
    camera = close_up(FRONT, np.array([0.5, 0.5, 0]), 0.2)
    buffer = z_buffer(vertices, faces, camera, 100)
    line = np.array([[[0.0, 0.5, 0], [1.0, 0.5, 0]]])
    assert length_of(buffer.visible_pieces(line)) == pytest.approx(0.2, abs=0.02)


def test_the_back_of_a_torus_is_hidden_and_its_hole_is_open() -> None:
    vertices, faces = torus(60, 30)
    buffer = buffer_of((vertices, faces), looking(1, 20, 89))
    rows, columns = buffer.face.shape
    assert buffer.face[rows // 2, columns // 2] == NOTHING
    seen = buffer.visible(vertices)
    assert seen[vertices[:, 1] > 0.05].all()
    assert not seen[vertices[:, 1] < -0.05].any()


def test_faces_without_area_or_edge_on_do_no_harm() -> None:
    vertices, faces = square(2, 0)
    vertices = np.vstack([vertices, [[0, 0, 3]]])
    odd = np.array([[0, 0, 1], [0, 1, 0], [4, 4, 4], [0, 2, 4]])  # the last is seen edge-on
    buffer = buffer_of((vertices, np.vstack([faces, odd])))
    inside = buffer.face[10:-10, 10:-10]
    assert set(np.unique(inside)) <= {0, 1, 5}
    picture = shade(Surface(vertices, np.vstack([faces, odd])), buffer)
    assert np.isfinite(picture).all()


def test_shading_is_smooth_on_a_ball_and_flat_beside_a_crease() -> None:
    ball = Surface(*sphere(30, 60))
    normals = ball.corner_normals
    assert normals == pytest.approx(ball.vertices[ball.faces], abs=0.02)
    roof = Surface(
        np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, -1.0]]), np.array([[0, 1, 2], [1, 0, 3]])
    )
    for i in range(3):
        assert roof.corner_normals[:, i] == pytest.approx(roof.face_normals)


def test_a_picture_is_white_around_the_model_and_has_neither_black_nor_white_in_it() -> None:
    ball = Surface(*sphere(20, 40))
    buffer = z_buffer(ball.vertices, ball.faces, framing(FRONT, ball.vertices), 150)
    picture = shade(ball, buffer)
    there = buffer.face != NOTHING
    assert (picture[~there] == 1).all()
    assert 0.3 < picture[there].min() < 0.75 < picture[there].max() < 1
    inside_out = Surface(ball.vertices, ball.faces[:, ::-1])
    again = z_buffer(inside_out.vertices, inside_out.faces, buffer.camera, 150)
    assert shade(inside_out, again) == pytest.approx(picture, abs=1e-9)


def test_colours_of_vertices_are_shaded_and_blend_across_a_face() -> None:
    vertices, faces = square(2, 0)
    buffer = buffer_of((vertices, faces))
    red = np.linspace(0.2, 1, 101)[np.round(50 + 50 * vertices[:, 0]).astype(int)]
    image = shade(Surface(vertices, faces), buffer, np.column_stack([red, 0 * red, 0 * red]))
    row = image[image.shape[0] // 2]
    inside = row[row[:, 1] == 0]
    assert (inside[:, 2] == 0).all() and (np.diff(inside[:, 0]) > 0).all()
    assert 0.1 < inside[0, 0] < 0.3 < 0.8 < inside[-1, 0] <= 1


def test_no_pixel_falls_through_the_seam_of_two_faces() -> None:
    """Centres of pixels lie on edges. A missed pixel would show the far side of the ball."""
    vertices, faces = sphere(20, 40)
    buffer = buffer_of((vertices, faces), width=150)
    seen = buffer.face[buffer.face != NOTHING]
    assert (vertices[faces[seen]].mean(axis=1)[:, 2] >= 0).all()


def test_a_drawn_surface_is_an_image_and_its_lines_are_vectors(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(surface, "PIXELS_PER_INCH", 50)
    ball = Surface(*sphere(20, 40))
    axes = style.new_figure(2).subplots()
    buffer = draw_surface(axes, ball, framing(FRONT, ball.vertices), 2)
    (image,) = axes.images
    assert image.get_array().shape == (100, 100, 3)
    shown = draw_lines(axes, buffer, ball.vertices[edges(ball.faces)], "#123456", 1.0)
    (lines,) = axes.collections
    drawn = sum(length_of(np.stack([p[:-1], p[1:]], axis=1)) for p in lines.get_segments())
    assert drawn == pytest.approx(length_of(shown))
    assert axes.get_xlim() == pytest.approx(buffer.camera.extent[:2])


def test_a_source_that_is_hidden_leaves_the_picture_its_size() -> None:
    vertices, faces = together(square(2, 0), square(1, -1))
    plates = Surface(vertices, faces)
    figure = style.new_figure(2)
    axes = figure.subplots()
    buffer = draw_surface(axes, plates, framing(FRONT, vertices), 2)
    assert draw_points(axes, buffer, vertices[4:]) == 0
    figure.canvas.draw()
    box = axes.get_window_extent()
    assert min(box.width, box.height) > 0.9 * min(figure.bbox.width, figure.bbox.height)


def test_a_camera_frames_all_points_with_a_margin() -> None:
    points = np.array([[0.0, 0, 0], [4, 2, 1]])
    camera = framing(FRONT, points)
    left, right, bottom, top = camera.extent
    assert left < 0 < 4 < right and bottom < 0 < 2 < top
    assert isinstance(camera, Camera) and camera.width == pytest.approx(4.16)
    for height in (0.2, 2):
        shaped = camera.of_shape(height)
        assert shaped.height == pytest.approx(height * shaped.width)
        assert shaped.width >= camera.width and shaped.height >= camera.height
        assert min(shaped.width - camera.width, shaped.height - camera.height) == pytest.approx(0)
