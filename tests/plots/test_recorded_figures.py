"""Contents of figures from recordings. test_figures.py has the tests of every figure."""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.text import Text
from synthetic import SPREAD, changed_rows, without_recordings

from plots import catalogue, isoline_figure, isolines, paths, report, style, wavefronts
from plots.catalogue import FIGURES
from plots.recordings import recordings
from results.published import APPENDIX, THESIS_SOLVERS
from results.reader import ResultError, Run
from results.table import Table


def wavefront_of(solver: str) -> str:
    """Returns the name of the figure of the solver's wavefront."""
    return f"wavefront_{solver.replace('-', '_')}"


NEEDS = {
    "error_map": "dijkstra/distances.npy",
    "wavefront_and_isoline": "edge-based/snapshot-25.npy",
    "windows_on_wavefront": "ich/curve.npy",
    "wavefront_quality_over_progress": "mmp/curve.npy",
    "isolines": "distances.npy",
    "paths": "path_points.npy",
    "cells": "cell_sources.npy",
} | {wavefront_of(solver): f"{solver}/snapshot-50.npy" for solver in APPENDIX}
"""A recorded file that a figure needs, by figure."""


def all_inside(axes: Axes) -> bool:
    """Returns whether all points of the lines are inside the axes."""
    points = np.vstack([line.get_xydata() for line in axes.lines])
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    low, high = points.min(axis=0), points.max(axis=0)
    return bool(left <= low[0] and high[0] <= right and bottom <= low[1] and high[1] <= top)


def own_recordings(run: Run) -> Path:
    """Copies the recordings. Returns the folder of the first mesh and source, which the test may change."""
    folder = run.file.parent / "recordings"
    shared = folder.resolve()
    folder.unlink()
    shutil.copytree(shared, folder)
    return recordings(run)[0].folder


def change_file(file: Path, change: Callable[[np.ndarray[Any, Any]], object]) -> None:
    data = np.load(file)
    change(data)
    np.save(file, data)


def colors(axes: Axes) -> set[str]:
    return {to_hex(color) for lines in axes.collections for color in lines.get_color()}


@pytest.mark.parametrize(("name", "path"), NEEDS.items())
def test_a_file_that_is_missing_or_truncated_is_named(name: str, path: str, run: Run) -> None:
    file = own_recordings(run) / path
    file.write_bytes(file.read_bytes()[:-40])
    for why in ["perhaps truncated", "no such file"]:
        with pytest.raises(ResultError, match=why) as caught:
            FIGURES[name](run)
        assert file.name in str(caught.value)
        file.unlink(missing_ok=True)


def without(run: Run, solver: str) -> Run:
    return changed_rows(run, lambda row: without_recordings(row) if row["solver"] == solver else row)


@pytest.mark.parametrize("name", ["wavefront_and_isoline", "windows_on_wavefront", "wavefront_edge_based"])
def test_without_the_solver_it_is_about_there_is_no_figure(name: str, run: Run) -> None:
    with pytest.raises(ResultError, match="no recordings of edge-based"):
        FIGURES[name](without(run, "edge-based"))


def test_windows_are_drawn_over_the_level_for_two_solvers_and_for_all(run: Run) -> None:
    def many(data: np.ndarray[Any, Any]) -> None:
        data["windows"] *= 3

    change_file(own_recordings(run) / "ich" / "curve.npy", many)
    grid = FIGURES["windows_on_wavefront"](run).figure.axes
    assert [len(axes.lines) for axes in grid] == [2, 5, 2, 4]
    assert all(map(all_inside, grid))
    (recording, *_) = recordings(run, "edge-based", "fwp-mmp")
    curve = recording.curve("edge-based")
    line = next(line for line in grid[0].lines if line.get_label() == "edge-based")
    assert line.get_xdata() == pytest.approx(curve["mean"] / recording.greatest)
    assert line.get_ydata() == pytest.approx(curve["windows"])
    assert grid[0].get_title("left").startswith("rocker-arm") and grid[0].get_xlim() == (0, 1)


@pytest.mark.parametrize(
    ("factor", "words"),
    [
        (0.5, "fewer windows than fwp-mmp at 100% of 64 levels, and 0.50 times as many"),
        (2, "fewer windows than fwp-mmp at 0% of 64 levels, and 2.00 times as many"),
    ],
)
def test_the_caption_says_who_has_fewer_windows(run: Run, factor: float, words: str) -> None:
    def scale(data: np.ndarray[Any, Any]) -> None:
        data["windows"] = factor * np.maximum(data["windows"], 2)

    def at_least_two(data: np.ndarray[Any, Any]) -> None:
        data["windows"] = np.maximum(data["windows"], 2)

    folder = own_recordings(run)
    change_file(folder / "edge-based" / "curve.npy", scale)
    change_file(folder / "fwp-mmp" / "curve.npy", at_least_two)
    caption = FIGURES["windows_on_wavefront"](run).caption
    assert words in caption
    assert ("which agrees with the thesis" in caption) == (factor < 1)


def test_the_curve_of_the_spread_is_in_mean_edge_lengths(run: Run) -> None:
    drawn = FIGURES["wavefront_quality_over_progress"](run)
    axes = drawn.figure.axes
    assert [len(one.lines) for one in axes] == [5, 4]
    assert all(map(all_inside, axes))
    for line in axes[0].lines:
        assert line.get_ydata().mean() == pytest.approx(SPREAD[line.get_label()], rel=1e-6)
        assert line.get_xdata()[-1] == pytest.approx(1)


def test_the_title_of_a_stand_in_is_not_cut(run: Run) -> None:
    models = {"rocker-arm": "asian dragon", "flat-grid": "cervino terrain"}
    meshes = {key: replace(mesh, thesis_model=models.get(key), stand_in=True, vertices=1_575_425)
              for key, mesh in run.meshes.items()}  # fmt: skip
    figure = FIGURES["wavefront_quality_over_progress"](replace(run, meshes=meshes)).figure
    figure.canvas.draw()
    titles = [title for axes in figure.axes for title in axes.texts + axes.get_children()
              if isinstance(title, Text) and "vertices" in title.get_text()]  # fmt: skip
    boxes = [title.get_window_extent() for title in titles]
    assert len(boxes) == 2 and all(0 <= box.x0 and box.x1 <= figure.bbox.width for box in boxes)
    assert not boxes[0].overlaps(boxes[1])


def test_the_caption_says_whether_mmp_and_ich_are_the_smoothest(run: Run) -> None:
    assert "edge-based" in FIGURES["wavefront_quality_over_progress"](run).caption
    assert FIGURES["wavefront_quality_over_progress"](run).caption.count("which agrees with the thesis") == 2

    def rough(data: np.ndarray[Any, Any]) -> None:
        data["sd"] *= 10

    change_file(own_recordings(run) / "mmp" / "curve.npy", rough)
    caption = FIGURES["wavefront_quality_over_progress"](run).caption
    assert "from the smoothest: ich" in caption and "does not agree with the thesis" in caption


def test_the_wavefront_is_drawn_over_the_isoline_of_its_distance(run: Run) -> None:
    drawn = FIGURES["wavefront_and_isoline"](run)
    whole, near = drawn.figure.axes
    wanted = {style.ISOLINE.lower(), style.WAVEFRONT.lower()}
    assert colors(whole) == wanted and colors(near) == wanted | {style.PALE}
    for axes in (whole, near):
        assert len(axes.images) == 1
        for lines in axes.collections:
            assert lines.get_segments(), "lines without a visible part"
    (recording, *_) = recordings(run)
    assert len(near.collections[1].get_segments()) < len(whole.collections[0].get_segments()) + 500
    width = np.diff(near.get_xlim())[0] / recording.mesh.mean_edge_length
    assert f"{width:.0f} mean edge lengths wide" in drawn.caption


@pytest.mark.parametrize(("spread", "agrees"), [(1.0, True), (40.0, False)])
def test_the_caption_says_how_near_the_isoline_is(run: Run, spread: float, agrees: bool) -> None:
    def scale(data: np.ndarray[Any, Any]) -> None:
        mean = data["distance"].mean()
        data["distance"] = np.abs(mean + spread * (data["distance"] - mean))

    folder = own_recordings(run)
    for moment in (25, 50, 75):
        change_file(folder / "edge-based" / f"snapshot-{moment}.npy", scale)
    caption = FIGURES["wavefront_and_isoline"](run).caption
    assert ("which agrees with the thesis's claim" in caption) == agrees


def test_the_level_is_the_one_next_to_the_wavefront_s_mean(run: Run) -> None:
    (recording, *_) = recordings(run)
    moment, level = wavefronts._moment(recording)
    mean = recording.snapshot("edge-based", moment)["distance"].mean()
    step = recording.greatest / isolines.STEPS
    assert abs(level - mean) <= step / 2
    assert level in isolines.levels(recording)


@pytest.mark.parametrize("solver", APPENDIX)
def test_each_solver_s_wavefront_has_its_colour_and_its_spread(solver: str, run: Run) -> None:
    drawn = FIGURES[wavefront_of(solver)](run)
    color = style.solver_styles([solver])[solver].color.lower()
    whole, near = drawn.figure.axes
    assert colors(whole) == {color} and colors(near) == {color, style.PALE}
    assert drawn.title == f"Wavefront of {solver} (Figure {APPENDIX[solver]} of the thesis)"
    (recording, *_) = recordings(run)
    windows = recording.snapshot(solver, 50)
    sd = windows["distance"].std() / recording.mesh.mean_edge_length
    words = f"the {len(windows):,} windows' distances is {sd:.2f} mean edge lengths"
    assert words in drawn.caption


def test_all_wavefronts_are_shown_from_one_side_with_one_close_up(run: Run) -> None:
    places = [
        [(axes.get_xlim(), axes.get_ylim()) for axes in FIGURES[wavefront_of(solver)](run).figure.axes]
        for solver in APPENDIX
    ]
    assert all(place == places[0] for place in places)


def test_every_model_has_all_its_isolines(run: Run) -> None:
    drawn = FIGURES["isolines"](run)
    assert len(drawn.figure.axes) == 2
    count = isolines.STEPS - 1
    for axes in drawn.figure.axes:
        assert len(axes.images) == 1 and len(axes.collections) == count
        widths = [float(lines.get_linewidth()[0]) for lines in axes.collections]
        assert sum(width > min(widths) for width in widths) == count // isoline_figure.THICK
        seen = [lines for lines in axes.collections if lines.get_segments()]
        assert len(seen) > count / 2
    assert f"{count} on each model" in drawn.caption


def test_every_model_has_its_paths(run: Run) -> None:
    drawn = FIGURES["paths"](run)
    assert len(drawn.figure.axes) == 2
    for axes in drawn.figure.axes:
        (lines,) = axes.collections
        assert to_hex(lines.get_color()[0]) == paths.PATH
    assert "4 on rocker-arm, 4 on flat-grid" in drawn.caption


def test_cells_have_a_colour_each_and_sharp_borders(run: Run) -> None:
    flat = next(one for one in recordings(run) if one.mesh.name == "flat-grid")
    axes = FIGURES["cells"](run).figure.axes[1]
    image = np.asarray(axes.images[0].get_array())
    seen = {tuple(color) for color in image.reshape(-1, 3).round(6)}
    assert len(seen) == 1 + len(flat.cells.sources), "a flat surface has one shade"


def test_a_figure_of_recordings_is_written_and_on_the_page(run: Run) -> None:
    written, _ = catalogue.draw_files(run, run.file.parent, ["paths"])
    assert set(written) == {"paths"} and '<figure id="paths">' in report.page(run, written, {})


def test_a_run_without_a_mesh_of_the_thesis_has_none_of_its_numbers(complete_run: Run) -> None:
    meshes = {name: replace(mesh, thesis_model=None, stand_in=False) for name, mesh in complete_run.meshes.items()}
    own, _ = catalogue.draw(replace(complete_run, meshes=meshes))
    assert NEEDS.keys() | {"strip_depth", "performance"} <= own.keys()
    assert set(APPENDIX) == set(THESIS_SOLVERS)
    for name, one in own.items():
        said = f"{name} {one.title} {'' if isinstance(one, Table) else one.caption}"
        assert not re.search(r"(?i)thesis|(figure|table)s?[ _][a\d]\b", said), said
        assert not isinstance(one, Table) or one.name == name
