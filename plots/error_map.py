"""Errors of each approximate solver on the surface of a mesh."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LogNorm
from matplotlib.lines import Line2D
from matplotlib.ticker import NullLocator

from plots import style
from plots.camera import Camera, Floats
from plots.dots import sentences
from plots.drawing import Drawing
from plots.measures import ERROR, columns
from plots.panels import COLUMNS, TALLEST, best_camera, in_rows
from plots.recordings import Recording, recordings
from plots.surface import draw_surface, edges
from plots.wavefronts import SOURCE, draw_source
from results.reader import ResultError, Run

COLORS = colormaps["magma_r"]
"""Larger errors are darker, also in a grey print."""
LEAST_SHOWN = 1e-6
UNREACHED = (0.8, 0.84, 0.9)
LINE_INCHES = 0.16
LONG = 28
"""Largest number of letters of a name that has one line above its panel."""
OF_INTEREST = 1e-2
"""The map shows that setting of a solver whose largest error is nearest to this."""
TENTH = 10


@dataclass(frozen=True)
class Map:
    solver: str
    errors: Floats
    """Relative errors by vertex, negative where a distance is too short; NaN at unreached vertices and
    where the distance is 0."""

    @property
    def sizes(self) -> Floats:
        known: Floats = self.errors[np.isfinite(self.errors)]
        return np.abs(known)


def figure(run: Run) -> Drawing:
    """@raises ResultError without recordings of both an exact and an inexact solver"""
    recording = next((one for one in recordings(run) if one.inexact), None)
    if recording is None:
        raise ResultError(
            f"{run.file}: no distances of inexact solvers; run --recordings auto keeps them"
        )
    maps = _chosen(run, recording)
    surface = recording.surface
    camera = best_camera(recording, surface.vertices[edges(surface.faces)])
    scale = _scale(maps)
    count = 2 if len(maps) in (2, 4) else min(len(maps), COLUMNS)
    rows = math.ceil(len(maps) / count)
    height = min(camera.height / camera.width, TALLEST)
    inches = style.WIDTH / max(count, 2)
    lines = max(_title(one).count("\n") for one in maps) + 1
    picture = style.new_figure(1.1 + rows * (LINE_INCHES * lines + inches * height))
    panels = in_rows(picture, len(maps), count)
    seen = [
        _draw(axes, recording, one, scale, camera.of_shape(height), inches)
        for axes, one in zip(panels, maps, strict=True)
    ]
    bar = picture.colorbar(
        ScalarMappable(scale, COLORS), ax=panels, location="bottom",
        label="relative error of a distance", shrink=0.6, aspect=40, extend="min",
    )  # fmt: skip
    bar.ax.xaxis.set_minor_locator(NullLocator())
    if any(seen):
        style.legend_above(picture, [Line2D([], [], label="source", **SOURCE)])
    return Drawing(
        title=f"Where the error sits: {recording.mesh.label}",
        caption=sentences(
            f"Relative errors of the distances from {recording.origin} of "
            f"{recording.mesh.label}, {recording.mesh.vertices:,} vertices, on one scale of "
            "colours; of a solver with several settings, the one whose largest error is nearest "
            f"to {ERROR.show(OF_INTEREST)}.",
            *(_where(recording, one) for one in maps),
            "" if any(seen) else "The source is hidden.",
        ),
        figure=picture,
    )


def _chosen(run: Run, recording: Recording) -> list[Map]:
    """Returns one map per solver, in the order of the run's tables."""
    found: dict[str, Map] = {}
    for solver in (s for s in columns(run) if s in recording.inexact):
        one = Map(solver, _errors(recording, solver))
        base = run.solvers[solver].base
        if one.sizes.size and (base not in found or _nearer(one, found[base])):
            found[base] = one
    if not found:
        raise ResultError(f"{run.file}: no vertex has an error of an inexact solver")
    return list(found.values())


def _scale(maps: Sequence[Map]) -> LogNorm:
    """Returns one scale for all maps, so that they can be compared: from the decade of the least mean
    error to the largest error. Smaller errors have the colour of its lower end."""
    least = max(min(float(one.sizes.mean()) for one in maps), LEAST_SHOWN)
    low = 10.0 ** math.floor(math.log10(least))
    return LogNorm(low, max(10 * low, *(float(one.sizes.max()) for one in maps)), clip=True)


def _title(error_map: Map) -> str:
    name = error_map.solver if len(error_map.solver) <= LONG else error_map.solver.replace("?", "\n?", 1)
    errors = f"largest {ERROR.show(error_map.sizes.max())}, mean {ERROR.show(error_map.sizes.mean())}"
    return f"{style.plain(name)}\n{errors}"


def _nearer(first: Map, other: Map) -> bool:
    far, farther = (abs(math.log(max(m.sizes.max(), 1e-17) / OF_INTEREST)) for m in (first, other))
    return far < farther


def _errors(recording: Recording, solver: str) -> Floats:
    exact, got = recording.distances, recording.inexact_distances(solver)
    known = np.isfinite(exact) & np.isfinite(got) & (exact > 0)
    errors = np.full(len(exact), np.nan)
    errors[known] = got[known] / exact[known] - 1
    return errors


def _draw(
    axes: Axes, recording: Recording, one: Map, scale: LogNorm, camera: Camera, inches: float
) -> bool:
    """Returns whether the source is visible."""
    colors = np.full((len(one.errors), 3), UNREACHED)
    known = np.isfinite(one.errors)
    colors[known] = COLORS(scale(np.abs(one.errors[known])))[:, :3]
    colors[recording.distances == 0] = COLORS(0.0)[:3]
    buffer = draw_surface(axes, recording.surface, camera, inches, colors)
    axes.set_title(_title(one), fontsize=9)
    return draw_source(axes, buffer, recording)


def _where(recording: Recording, error_map: Map) -> str:
    """Returns the mean errors near the source and far from it, and the share of too short distances."""
    reached = np.flatnonzero(np.isfinite(error_map.errors))
    order = reached[np.argsort(recording.distances[reached], kind="stable")]
    part = max(1, len(order) // TENTH)
    near, far = (float(np.abs(error_map.errors[of]).mean()) for of in (order[:part], order[-part:]))
    short = 100 * np.count_nonzero(error_map.errors[reached] < -1e-12) / len(reached)
    return sentences(
        f"{error_map.solver}: {ERROR.show(near)} in the mean over the tenth of the vertices nearest to "
        f"the source, {ERROR.show(far)} over the farthest"
        + (f", too short at {short:.3g}% of the vertices." if short else ", nowhere too short.")
    )
