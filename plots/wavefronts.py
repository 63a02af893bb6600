"""The wavefront of solvers on a model, whole and close up: Figures 5.7 and A.1 to A.5."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from scipy.ndimage import uniform_filter

from plots import style
from plots.camera import Camera, Floats, close_up
from plots.curves import title
from plots.dots import sentences
from plots.drawing import Drawing
from plots.isolines import isoline, levels
from plots.measures import EDGE_BASED
from plots.models import agreement, titled
from plots.recordings import MOMENTS, Recording, recordings
from plots.panels import best_camera
from plots.surface import draw_lines, draw_surface, edges
from plots.zbuffer import NOTHING, ZBuffer
from results.published import APPENDIX, THESIS_SOLVERS
from results.reader import ResultError, Run

NEAR = 2
"""Mean edge lengths. If 95% of the windows are so near to the mean, the wavefront follows the isoline."""
MOMENT = 50
"""Per cent of the vertices reached, in the figures of the appendix."""
CLOSE_UP_EDGES = 24
"""Width of the close-up in mean edge lengths."""
CLOSE_UP_SHARE = 0.4
"""Largest width of the close-up, as a share of the smaller side of the whole picture."""
TALLEST = 3.6
"""Largest height of the pictures in inches."""
SOURCE = {
    "marker": "o", "markersize": 5.5, "markerfacecolor": "white", "markeredgecolor": style.INK,
    "markeredgewidth": 1.2, "linestyle": "",
}  # fmt: skip


@dataclass(frozen=True)
class Lines:
    label: str
    segments: Floats
    """(n, 2, 3)"""
    color: str
    width: float
    """Points, in the close-up; half of it on the whole model."""


@dataclass(frozen=True)
class Pictures:
    figure: Figure
    close_up: float
    """Width of the close-up in mean edge lengths."""
    source_is_seen: bool

    @property
    def sentence(self) -> str:
        where = "" if self.source_is_seen else " The source is on the far side."
        return (
            f"Right: the square on the left, {self.close_up:.0f} mean edge lengths "
            f"wide, with the edges of the mesh. Hidden lines are left out.{where}"
        )


def wavefront_and_isoline(run: Run) -> Drawing:
    """Draws Figure 5.7. @raises ResultError without recordings of edge-based"""
    recording = recordings(run, EDGE_BASED)[0]
    moment, level = _moment(recording)
    wavefront = recording.wavefront(EDGE_BASED, moment)
    pictures = _draw(
        recording,
        [
            Lines("isoline of the distance field", isoline(recording, level), style.ISOLINE, 1.8),
            Lines(f"wavefront of {EDGE_BASED}", wavefront, style.WAVEFRONT, 1.2),
        ],
        wavefront,
    )
    return Drawing(
        title=titled(run, "Wavefront and isoline", "Figure 5.7"),
        caption=sentences(
            f"Blue: windows on the wavefront of {EDGE_BASED} on {recording.mesh.label} when "
            f"{moment}% of the vertices were reached. Red: the isoline of the vertices' exact "
            "distances, straight across each face.",
            _claim(run, recording, moment, level),
            pictures.sentence,
        ),
        figure=pictures.figure,
    )


def appendix(solver: str) -> Callable[[Run], Drawing]:
    """@param solver a key of APPENDIX
    @return a function that draws the figure; it raises ResultError without the solver's recordings"""

    def draw(run: Run) -> Drawing:
        recording = recordings(run)[0]
        if solver not in recording.solvers:
            where = f"recordings of {solver} on {recording.mesh.name}"
            lacking = where if solver in run.solvers else f"{solver} in this run"
            raise ResultError(f"{run.file}: no {lacking}")
        look = style.solver_styles(run.solvers)[solver]
        wavefront = recording.wavefront(solver, MOMENT)
        base = next(one for one in THESIS_SOLVERS if one in recording.solvers)
        pictures = _draw(
            recording,
            [Lines(f"wavefront of {solver}", wavefront, look.color, 1.4)],
            recording.wavefront(base, MOMENT),
        )
        return Drawing(
            title=titled(run, f"Wavefront of {solver}", f"Figure {APPENDIX[solver]}"),
            caption=sentences(
                f"Windows on the wavefront of {solver} on {recording.mesh.label} when {MOMENT}% of "
                "the vertices were reached; the figure of each other solver shows the same moment from the "
                "same side.",
                _spread(recording, solver),
                pictures.sentence,
            ),
            figure=pictures.figure,
        )

    return draw


def _draw(recording: Recording, layers: Sequence[Lines], about: Floats) -> Pictures:
    """@param about segments that the view shows; the close-up shows a part of them"""
    mesh, surface = recording.mesh, recording.surface
    whole = best_camera(recording, about)
    ratio = whole.width / whole.height
    tall = min(style.WIDTH / (1 + ratio), TALLEST)
    figure = style.new_figure(tall + 0.5)
    left, right = figure.subplots(1, 2, width_ratios=[ratio, 1])
    buffer = draw_surface(left, surface, whole, tall * ratio)
    near = _close_up(recording, buffer, about)
    near_buffer = draw_surface(right, surface, near, tall)
    drawn_faces = surface.faces[np.unique(near_buffer.face[near_buffer.face != NOTHING])]
    draw_lines(right, near_buffer, surface.vertices[edges(drawn_faces)], style.PALE, 0.25)
    for lines in layers:
        draw_lines(left, buffer, lines.segments, lines.color, lines.width / 2)
        draw_lines(right, near_buffer, lines.segments, lines.color, lines.width)
    _outline(left, near)
    seen = draw_source(left, buffer, recording)
    left.set_title(title(mesh))
    handles = [
        Line2D([], [], label=one.label, color=one.color, linewidth=one.width) for one in layers
    ]
    style.legend_above(figure, handles + ([Line2D([], [], label="source", **SOURCE)] * seen))
    return Pictures(figure, near.width / mesh.mean_edge_length, seen)


def draw_source(axes: Axes, buffer: ZBuffer, recording: Recording) -> bool:
    """Marks the source if it is not hidden. @return whether it is shown"""
    return draw_points(axes, buffer, recording.surface.vertices[recording.vertices]) > 0


def draw_points(axes: Axes, buffer: ZBuffer, points: Floats) -> int:
    """Marks sources at points (n, 3) that are not hidden. @return the number of marks"""
    seen = points[buffer.visible(points)]
    if len(seen):  # matplotlib places a line without points in the figure's corner
        x, y, _ = buffer.camera.project(seen).T
        axes.plot(x, y, **SOURCE, clip_on=False, zorder=5)
    return len(seen)


def _close_up(recording: Recording, buffer: ZBuffer, about: Floats) -> Camera:
    """Returns the close-up on that point of the lines around which the surface most faces the viewer."""
    whole = buffer.camera
    width = min(
        CLOSE_UP_EDGES * recording.mesh.mean_edge_length,
        CLOSE_UP_SHARE * min(whole.width, whole.height),
    )
    towards = np.abs(recording.surface.face_normals @ whole.axes[2])
    facing = np.where(buffer.face == NOTHING, 0, towards[buffer.face])
    facing = uniform_filter(facing, round(width / buffer.pixel), mode="constant")
    middles = about.mean(axis=1)
    seen = middles[buffer.visible(middles)]
    if not len(seen):
        seen = middles
    x, y, _ = np.floor(buffer.to_pixels(seen)).astype(np.int64).T
    height_pixels, width_pixels = facing.shape
    merit = facing[np.clip(y, 0, height_pixels - 1), np.clip(x, 0, width_pixels - 1)]
    return close_up(whole.axes, seen[np.argmax(merit)], width)


def _outline(axes: Axes, camera: Camera) -> None:
    left, _, bottom, _ = camera.extent
    axes.add_patch(
        Rectangle(
            (left, bottom), camera.width, camera.height, fill=False, edgecolor=style.INK,
            linewidth=0.8, zorder=4,
        )
    )  # fmt: skip


def _moment(recording: Recording) -> tuple[int, float]:
    """Returns the moment whose mean distance is nearest to the level of an isoline, and this level."""
    steps = levels(recording)
    means = {
        moment: float(recording.snapshot(EDGE_BASED, moment)["distance"].mean())
        for moment in MOMENTS
    }
    moment = min(means, key=lambda moment: float(np.abs(steps - means[moment]).min()))
    return moment, float(steps[np.abs(steps - means[moment]).argmin()])


def _claim(run: Run, recording: Recording, moment: int, level: float) -> str:
    edge = recording.mesh.mean_edge_length
    distance = recording.snapshot(EDGE_BASED, moment)["distance"]
    mean = distance.mean()
    far = np.percentile(np.abs(distance - mean), 95) / edge
    claim = agreement(run, far <= NEAR, "'s claim that the wavefront is an approximate isoline")
    return (
        f"Its level is {abs(level - mean) / edge:.2f} mean edge lengths from the mean distance of "
        f"the windows, and 95% of the windows are within {far:.2f} mean edge lengths of that "
        f"mean{claim}."
    )


def _spread(recording: Recording, solver: str) -> str:
    edge = recording.mesh.mean_edge_length
    spread = {
        one: float(recording.snapshot(one, MOMENT)["distance"].std()) / edge
        for one in THESIS_SOLVERS
        if one in recording.solvers
    }
    listed = ", ".join(
        f"{one} {spread[one]:.2f}" for one in sorted(spread, key=lambda one: spread[one])
    )
    return (
        f"The standard deviation of the {len(recording.snapshot(solver, MOMENT)):,} windows' "
        f"distances is {spread[solver]:.2f} mean edge lengths; from the smoothest: {listed}."
    )
