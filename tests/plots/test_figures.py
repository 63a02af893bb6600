"""Every figure is refused without its data and complete with it. Its numbers are at the right places."""

from __future__ import annotations

import io
import math
import os
import subprocess
import sys
from collections import defaultdict
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import matplotlib
import numpy as np
import pytest
from matplotlib.collections import LineCollection
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from matplotlib.text import Text
from synthetic import Data, changed_rows, data_of, of_solvers, with_rows, without_recordings

from plots import catalogue, dot_figures, growth, phases, style
from plots.catalogue import FIGURES
from plots.dots import BEYOND
from plots.drawing import Drawing
from plots.logarithmic import logarithmic
from plots.measures import TIME, median_of
from plots.ratios import Ratio
from results.console import ROOT
from results.published import THESIS_SOLVERS
from results.reader import ERRORS, ResultError, Run

NEEDS = {
    "accuracy": ["max_relative_error"],
    "break_even": ["cpu_time"],
    "frontier": ["cpu_time"],
    "many_sources": ["cpu_time"],
    "paths_compared": ["paths"],
    "phases": ["phase_seconds"],
    "wavefront_quality": ["wavefront_sd_edges"],
    "overview": ["window_limit", "cpu_time"],
    "peers_overview": ["cpu_time"],
    "performance_profile": ["cpu_time"],
    "speedup": ["cpu_time"],
    "time_over_vertices": ["cpu_time"],
    "windows_over_limit": ["window_propagations"],
}
"""Numbers of a row that a figure needs, by figure. Other figures are drawn from recordings."""
SHOWN: dict[str, set[str]] = {
    "break_even": set(), "error_map": set(), "frontier": set(THESIS_SOLVERS) - {"fwp-ch"},
    "wavefront_and_isoline": {"edge-based"}, "isolines": set(), "paths": set(), "cells": set(),
    "wavefront_edge_based": {"edge-based"}, "wavefront_mmp": {"mmp"}, "wavefront_fwp_mmp": {"fwp-mmp"},
    "wavefront_ich": {"ich"}, "wavefront_fwp_ch": {"fwp-ch"}, "speedup": set(THESIS_SOLVERS) - {"mmp"},
    "time_over_vertices": set(THESIS_SOLVERS) - {"fwp-ch"},
}  # fmt: skip
"""Solvers of the thesis that a figure shows, by figure. Other figures show all of them."""
SERIES = {"horse": "surface-48k", "rocker-arm": "surface-10k", "flat-grid": "surface-400"}


def with_number(run: Run, solver: str, mesh: str, key: str, value: Any) -> Run:
    def change(row: Data) -> Data:
        mine = (row["solver"], row["mesh"], row["outcome"]) == (solver, mesh, "ok")
        return row | {key: value} if mine else row

    return changed_rows(run, change)


def renamed(run: Run, meshes: dict[str, str], solvers: dict[str, str] | None = None) -> Run:
    """Returns the run with other names of meshes and solvers."""
    named = {mesh.name: mesh.name for mesh in run.meshes.values()} | meshes
    called = {name: name for name in run.solvers} | (solvers or {})
    return with_rows(
        run,
        [row | {"mesh": named[row["mesh"]], "solver": called[row["solver"]]} for row in data_of(run)],
        meshes={named[m.name]: replace(m, name=named[m.name]) for m in run.meshes.values()},
        solvers={called[s.name]: replace(s, name=called[s.name]) for s in run.solvers.values()},
        sources={named.get(name, name): sources for name, sources in run.sources.items()},
    )


def suited(name: str, run: Run) -> Run:
    """Returns the run with the meshes, solvers and values that this figure needs."""
    grown: dict[str, Callable[[Run], Run]] = {
        "break_even": lambda run: with_inexact(run, "my-heat"),
        "peers_overview": with_peers,
        "frontier": lambda run: with_inexact(run, "my-heat", "steiner?points=7"),
        "many_sources": with_sets,
        "paths_compared": with_paths,
        "time_over_vertices": lambda run: renamed(run, SERIES),
    }
    return grown[name](run) if name in grown else run


PATHS = {
    "targets": 100, "alone_time": 20.0, "first_time": 50.0, "further_time": 0.0125,
    "max_excess": 1e-15, "mean_excess": 0.0, "shortest": 100, "off_surface": 0, "failed": 0,
}  # fmt: skip
LONGER = PATHS | {"further_time": 1.5, "max_excess": 0.04, "mean_excess": 1e-3, "shortest": 40}


def with_paths(run: Run) -> Run:
    """Returns the run with paths of all solvers, exact or not."""
    return changed_rows(
        run,
        lambda row: row | {"paths": PATHS if run.solvers[row["solver"]].exact else LONGER}
        if row["outcome"] == "ok" else row,
    )  # fmt: skip


def with_sets(run: Run) -> Run:
    """Returns the run with two sources on each mesh: the first one and a set of sources."""
    first = {mesh: sources[0] for mesh, sources in run.sources.items()}
    rows = [without_recordings(row) for row in data_of(run) if row["source"] == first[row["mesh"]]]
    of_sets = [row | {"source": "random:8"} for row in rows]
    sets = {"random:8": {"vertices": 8, "file": "sources/m.json"}}
    of_any_mesh: dict[str, Any] = defaultdict(lambda: sets)
    return with_rows(
        run, rows + of_sets,
        context=run.context | {"geodesic_bench": run.ours | {"source_sets": of_any_mesh}},
        sources={mesh: [vertex, "random:8"] for mesh, vertex in first.items()},
    )  # fmt: skip


def with_peers(run: Run) -> Run:
    """Returns the run with two public codes: an exact solver and a heat method."""
    rows = [row | {"solver": "vtp"} for row in data_of(run) if row["solver"] == "mmp"]
    grown = with_inexact(run, "gc-heat")
    vtp = replace(run.solvers["mmp"], name="vtp")
    plugins = [{"file": f"/peers/{name}/lib{name}.so", "solvers": [name]} for name in ("vtp", "gc-heat")]
    return with_rows(
        grown,
        [*data_of(grown), *rows],
        context=run.context | {"geodesic_bench": run.ours | {"plugins": plugins}},
        solvers=grown.solvers | {"vtp": vtp},
    )


def with_inexact(run: Run, *names: str) -> Run:
    """Returns the run with inexact solvers that prepare for 10 s and then take almost no time."""
    numbers = {"max_relative_error": 0.1, "mean_relative_error": 0.01, "prepare_time": 1e4, "cpu_time": 1e-6}
    rows = [
        row | numbers | {"solver": name}
        for name in names
        for row in data_of(run)
        if (row["solver"], row["outcome"]) == ("edge-based", "ok")
    ]
    like = replace(run.solvers["edge-based"], exact=False, exactness="unbounded")
    more = {name: replace(like, name=name) for name in names}
    return with_rows(run, data_of(run) + rows, solvers=run.solvers | more)


def figure_of(name: str, run: Run) -> Figure:
    return FIGURES[name](suited(name, run)).figure


def legend(figure: Figure) -> list[str]:
    (legend,) = figure.legends
    return [text.get_text() for text in legend.get_texts()]


def cut_texts(figure: Figure) -> list[str]:
    """Returns the texts that extend beyond the edge of the page by more than a pixel."""
    figure.canvas.draw()
    figure.set_layout_engine("none")  # the layout takes half of the time of a drawing, and stays
    page = figure.bbox.padded(1)
    renderer = figure.canvas.get_renderer()
    hidden = beyond_the_axis(figure)
    texts = [
        text
        for text in figure.findobj(Text)
        if text.get_visible() and text.get_text().strip() and text not in hidden
    ]
    boxes = [(text.get_text(), text.get_window_extent(renderer)) for text in texts]
    assert len(boxes) >= 2
    return [
        name
        for name, box in boxes
        if not (page.x0 <= box.x0 and box.x1 <= page.x1 and page.y0 <= box.y0 and box.y1 <= page.y1)
    ]


def touching_labels(figure: Figure) -> list[tuple[str, str]]:
    """Returns neighbouring labels on an axis of a drawn figure with less than a pixel between them."""
    renderer = figure.canvas.get_renderer()
    hidden = beyond_the_axis(figure)
    found = []
    for axis in [axis for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)]:
        end = 0 if axis.axis_name == "x" else 1
        labels = [tick.label1 for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks())]
        boxes = sorted(
            (*text.get_window_extent(renderer).get_points()[:, end], text.get_text())
            for text in labels
            if text.get_text() and text.get_visible() and text not in hidden
        )
        found += [(a[2], b[2]) for a, b in pairwise(boxes) if b[0] - a[1] < 1]
    return found


def beyond_the_axis(figure: Figure) -> set[Text]:
    """Returns the labels of ticks that exist but are not drawn."""
    labels = {text for axes in figure.axes if not axes.axison for text in axes.findobj(Text)}
    labels -= {axes.title for axes in figure.axes}
    for axis in [axis for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)]:
        low, high = sorted(axis.get_view_interval())
        for tick in (*axis.majorTicks, *axis.minorTicks):
            if not low <= tick.get_loc() <= high:
                labels |= {tick.label1, tick.label2}
    return labels


def drawn_numbers(figure: Figure) -> list[float]:
    numbers: list[float] = []
    for axes in figure.axes:
        for line in axes.lines:
            numbers += [*map(float, line.get_xdata()), *map(float, line.get_ydata())]
        for patch in axes.patches:
            if isinstance(patch, Rectangle):
                numbers += [patch.get_x(), patch.get_width()]
        numbers += [*axes.get_xlim(), *axes.get_ylim()]
    return numbers


def drawn_texts(figure: Figure) -> list[str]:
    """Returns the visible texts: every text of the page as SVG, with typeset mathematics."""
    file = io.BytesIO()
    with matplotlib.rc_context({"svg.fonttype": "none"}):
        figure.savefig(file, format="svg")
    texts = ElementTree.fromstring(file.getvalue()).iter("{http://www.w3.org/2000/svg}text")
    # Pieces that begin with a line break are indentation. Some versions write one line per glyph.
    return ["".join(piece for piece in text.itertext() if piece[:1] != "\n" or piece.strip()).strip()
            for text in texts]  # fmt: skip


def dots_of(figure: Figure, marker: str) -> list[Line2D]:
    return [line for line in figure.axes[0].lines if line.get_marker() == marker]


@pytest.fixture(scope="module", params=FIGURES)
def drawn(request: pytest.FixtureRequest, complete_run: Run) -> tuple[str, Drawing]:
    """Name and drawing of every figure."""
    return request.param, FIGURES[request.param](suited(request.param, complete_run))


def test_no_text_is_cut_or_touched_and_nothing_drawn_is_infinite(
    drawn: tuple[str, Drawing],
) -> None:
    figure = drawn[1].figure
    assert cut_texts(figure) == []
    assert touching_labels(figure) == []
    assert all(map(math.isfinite, drawn_numbers(figure)))
    assert all(axes.lines or axes.patches or axes.collections for axes in figure.axes)


def test_a_figure_has_a_series_for_each_of_the_thesis_s_solvers(
    drawn: tuple[str, Drawing],
) -> None:
    name, drawing = drawn
    axes = drawing.figure.axes
    ticks = {label.get_text() for one in axes for label in one.get_yticklabels()}
    found = {text.split(":")[0].split()[-1] for text in legend(drawing.figure)} | ticks
    assert SHOWN.get(name, set(THESIS_SOLVERS)) <= found


def test_a_figure_says_what_it_shows(drawn: tuple[str, Drawing]) -> None:
    caption = drawn[1].caption
    assert caption.endswith(".") and "  " not in caption


@pytest.mark.parametrize("name", FIGURES)
class TestEveryFigure:
    @pytest.fixture
    def run(self, complete_run: Run) -> Run:
        """The completed golden run. Tests must not change it."""
        return complete_run

    def test_without_its_numbers_it_is_refused_in_one_line(self, name: str, run: Run) -> None:
        def drop(row: Data) -> Data:
            kept = {k: v for k, v in row.items() if k not in NEEDS.get(name, [])}
            return without_recordings(kept)

        with pytest.raises(ResultError, match=r"run\.json: no [^\n]*$"):
            FIGURES[name](changed_rows(suited(name, run), drop))

    def test_a_run_in_which_everything_failed_is_refused(self, name: str, run: Run) -> None:
        def fail(row: Data) -> Data:
            kept = {k: v for k, v in row.items() if k not in ERRORS}
            return without_recordings(kept | {"outcome": "crashed", "error_message": "signal 11"})

        with pytest.raises(ResultError):
            FIGURES[name](changed_rows(suited(name, run), fail))

    def test_long_names_with_markup_and_many_solvers_fit_and_are_drawn_as_they_are(
        self, name: str, run: Run
    ) -> None:
        long = "-is-a-model-with-a-long-name"
        ends = [long, long, ""]
        odd = {mesh: f"a$b_{i}%{{c$d_{end}" for (i, end), mesh in zip(enumerate(ends), run.meshes, strict=True)}
        if name == "time_over_vertices":
            odd = {mesh: f"a$b_%{{c$d_{long}-{i}" for i, mesh in enumerate(run.meshes)}
        names = {"dijkstra": "my$own_%{v$", "fwp-ch": "f$w{", "ich": r"i\$c{"}
        if name in ("wavefront_ich", "wavefront_fwp_ch"):
            names = {}
        whole = run if name == "time_over_vertices" else suited(name, run)
        run = renamed(whole, odd, names)
        more = {
            f"my-own-variant-{i}": replace(run.solvers["mmp"], name=f"my-own-variant-{i}")
            for i in range(4)
        }
        copies = [
            row | {"solver": name} for row in data_of(run) if row["solver"] == "mmp" for name in more
        ]
        grown = with_rows(run, [*data_of(run), *copies], solvers=run.solvers | more)
        figure = FIGURES[name](grown).figure
        assert cut_texts(figure) == []
        drawn = drawn_texts(figure)
        assert len(drawn) >= 2
        for text in drawn:
            for known in sorted([*odd.values(), *names.values()], key=len, reverse=True):
                text = text.replace(known, "")
            assert not set(text) & set("$\\{}"), text


def test_the_same_run_gives_the_same_bytes_in_any_process(run: Run, tmp_path: Path) -> None:
    for seed in ["1", "2"]:
        subprocess.run(
            [sys.executable, "-m", "plots", "speedup", "--run", str(run.file.parent),
             "--out", str(tmp_path / seed)],
            check=True, capture_output=True, cwd=ROOT,
            env=os.environ | {"PYTHONHASHSEED": seed},
        )  # fmt: skip
    for extension in [".png", ".pdf", ".md"]:
        first, second = (tmp_path / seed / f"speedup{extension}" for seed in ["1", "2"])
        assert first.read_bytes() == second.read_bytes()


def test_all_draws_what_it_can_and_says_what_it_leaves_out(golden_run: Run) -> None:
    drawn, why = catalogue.draw(golden_run)
    assert "phase_seconds" in why.pop("phases") and why.pop("wavefront_quality")
    for words, names in {
        "of one surface": ["table_growth", "table_growth_exponents", "time_over_vertices"],
        "run --corpus robustness": ["robustness", "robustness_counts", "robustness_failures"],
        "public code": ["twins", "twins_overall", "peers_overview"],
        "run --corpus break-even": ["break_even", "break_even_numbers"],
        "run --corpus frontier": ["frontier", "which_to_take", "which_to_take_mean"],
        "run --source-sets": ["many_sources_errors", "many_sources_numbers", "many_sources"],
        "run --path-targets": ["path_costs", "path_numbers", "paths_compared"],
        "run --further-sources": ["further_sources"],
    }.items():
        assert all(words in why.pop(name) for name in names)
    assert list(why) == [
        "wavefront_and_isoline", "windows_on_wavefront", "wavefront_quality_over_progress", "isolines", "paths",
        "cells", "error_map", "wavefront_edge_based", "wavefront_mmp", "wavefront_fwp_mmp", "wavefront_ich",
        "wavefront_fwp_ch",
    ]  # fmt: skip
    assert all("no recordings" in words for words in why.values())
    assert {"performance", "speedup", "overview"} <= drawn.keys()


@pytest.mark.parametrize("name", ["overview", "speedup", "time_over_vertices"])
def test_labels_of_a_wide_range_do_not_touch(name: str, run: Run) -> None:
    far = with_number(run, "ch", "flat-grid", "cpu_time", 1e5)
    far = with_number(far, "ch", "flat-grid", "window_propagations", 1e6)
    figure = figure_of(name, far)
    figure.canvas.draw()
    assert touching_labels(figure) == []


@pytest.mark.parametrize("inches", [0.7, 1.5, 6])
@pytest.mark.parametrize(("low", "high"), [(0.9, 1.2), (0.5, 40), (0.4, 4e3), (1e-17, 1e9)])
def test_a_logarithmic_axis_has_labels_as_far_as_there_is_room(
    low: float, high: float, inches: float
) -> None:
    figure = style.new_figure(inches + 1, inches + 1)
    axes = figure.subplots()
    axes.plot([low, high], [low, high])
    for axis in (axes.xaxis, axes.yaxis):
        logarithmic(axis)
    figure.canvas.draw()
    assert touching_labels(figure) == []
    for axis in (axes.xaxis, axes.yaxis):
        shown = set(axis.get_ticklabels()) - beyond_the_axis(figure)
        assert sum(bool(text.get_text()) for text in shown) >= (1 if inches < 1 else 2)


def test_solvers_differ_in_colour_mark_and_most_of_all_in_grey() -> None:
    names = [*THESIS_SOLVERS, "ch", "cgal", "dijkstra", "new-one", "newer-one"]
    looks = style.solver_styles(names)
    for what in ["color", "marker"]:
        assert len({getattr(look, what) for look in looks.values()}) == len(names)

    def grey(solver: str) -> float:
        return float(np.dot(to_rgb(looks[solver].color), [0.299, 0.587, 0.114]))

    for family in [("mmp", "fwp-mmp"), ("ich", "fwp-ch")]:
        assert grey(family[1]) - grey(family[0]) > 0.15


def test_a_known_solver_looks_the_same_beside_unknown_ones() -> None:
    assert style.solver_styles(["zzz", "ich"])["ich"] == style.solver_styles(["ich"])["ich"]


def test_phases_and_rest_make_up_the_timed_solve(run: Run) -> None:
    one = phases.split(run, "horse", "ich")
    assert one is not None
    shares = {name: value / one.time for (name, _, _), value in one.parts()}
    assert shares == pytest.approx(
        {"window propagation": 0.45, "window trimming": 0.2, "queue maintenance": 0.3, "rest": 0.05},
        rel=0.02,
    )
    axes = figure_of("phases", run).axes[0]
    row = [bar for bar in axes.patches if round(bar.get_y() + bar.get_height() / 2) == 2]
    assert sum(bar.get_width() for bar in row) == pytest.approx(1e3 * one.time)


@pytest.mark.parametrize("name", ["overview", "phases", "speedup"])
def test_times_of_one_mesh_are_drawn_with_their_intervals(run: Run, name: str) -> None:
    """Without them, a mesh with two sources would have dots that look exact."""
    one = run.of_meshes(["horse"])
    over = {"overview": "edge-based", "phases": "", "speedup": "ich"}[name]
    ratio = Ratio("", "", ("mmp", TIME), (over, TIME))
    wanted = ratio.mean(one, "horse", "mmp") if over else median_of(one, "horse", "mmp", TIME)
    assert wanted and wanted.high > wanted.low
    axes = figure_of(name, one).axes[0]
    lines = [line.get_xdata() for line in axes.lines]
    lines += [part[:, 0] for each in axes.collections if isinstance(each, LineCollection) for part in each.get_segments()]
    lengths = [line[1] / line[0] for line in lines if len(line) == 2 and line[0] > 0]  # of any unit
    assert np.isclose(lengths, wanted.high / wanted.low, rtol=1e-9).any()


def test_errors_that_all_solvers_share_are_called_those_of_the_reference(run: Run) -> None:
    solvers = [solver for solver in run.solvers if run.solvers[solver].exact]

    def alike(row: Data) -> Data:
        here = row["solver"] in solvers and row["mesh"] == "horse" and "max_relative_error" in row
        return row | {"max_relative_error": 5.9e-14, "reference": "cgal"} if here else row

    changed = changed_rows(run, alike)
    assert dot_figures.of_the_reference(changed, solvers)["cgal"] == ["horse"]
    assert "On horse all differ from cgal by the same amount" in dot_figures.accuracy(changed).caption
    assert "cgal" not in dot_figures.of_the_reference(run, solvers)


@pytest.mark.parametrize("factor", [0.85, 0.95, 1.05, 1.15])
def test_a_bar_whose_phases_do_not_add_up_to_the_timed_solve_is_not_drawn(run: Run, factor: float) -> None:
    timed = phases.split(run, "horse", "ich")
    assert timed is not None
    seconds = {key: factor * timed.time / 3 for key in phases.PHASES} | {"timer_overhead": 0.001}
    changed = with_number(run, "ich", "horse", "phase_seconds", seconds)
    one = phases.split(changed, "horse", "ich")
    assert one is not None and sum(value for _, value in one.parts()) == pytest.approx(one.time)
    drawn = "ich" in [one.solver for one in phases.splits(changed, "horse")]
    assert drawn == (0.9 < factor < 1.1)
    assert (f"ich on horse ({factor - 1:+.0%})" in phases.figure(changed).caption) != drawn


def test_the_split_is_shown_for_two_models_of_the_thesis_or_those_asked_for(run: Run) -> None:
    titles = [axes.get_title("left") for axes in figure_of("phases", run).axes]
    assert titles == [
        "horse, 48,485 vertices", "rocker-arm (stand-in for rocker arm), 10,044 vertices",
    ]  # fmt: skip
    drawn = phases.figure(run.of_meshes(["flat-grid"]))
    assert [axes.get_title("left")[:9] for axes in drawn.figure.axes] == ["flat-grid"]


def test_a_solver_without_phases_is_named(run: Run) -> None:
    def drop(row: Data) -> Data:
        kept = {k: v for k, v in row.items() if k != "phase_seconds"}
        return kept if row["solver"] == "ich" else row

    drawn = phases.figure(changed_rows(run, drop))
    assert f"Without phases: ich on horse ({phases.ABSENT})" in drawn.caption


def test_wavefront_quality_is_drawn_where_it_is(run: Run) -> None:
    marks = dots_of(figure_of("wavefront_quality", run), "^")
    assert [float(mark.get_xdata()[0]) for mark in marks] == pytest.approx([0.4] * 3)


def test_a_solver_far_beyond_the_thesis_s_is_written_at_the_edge(run: Run) -> None:
    far = with_number(run, "ch", "flat-grid", "wavefront_sd_edges", 1000 * BEYOND)
    figure = figure_of("wavefront_quality", far)
    assert figure.axes[0].get_xlim()[1] < 2
    assert [text.get_text()[:5] for text in figure.axes[0].texts] == ["2,500"]
    assert cut_texts(figure) == []


def test_speedups_are_ratios_with_their_numbers_and_stand_ins_are_hollow(run: Run) -> None:
    figure = figure_of("speedup", run)
    diamonds = dots_of(figure, "D")
    assert [mark.get_markerfacecolor() for mark in diamonds][:2] == ["#000000", "white"]
    times = {
        solver: [row.time for row in run.cell("horse", solver)]
        for solver in ["mmp", "edge-based"]
    }
    ratio = float(np.exp(np.mean(np.log(np.divide(times["mmp"], times["edge-based"])))))
    assert float(diamonds[0].get_xdata()[0]) == pytest.approx(ratio)
    assert f"{ratio:.3g}" in {text.get_text() for text in figure.axes[0].texts}
    published = [float(mark.get_xdata()[0]) for mark in dots_of(figure, "d")]
    assert pytest.approx(4.948, abs=0.001) in published


def test_a_mean_says_over_how_many_meshes_it_is(run: Run) -> None:
    """ich crashed from one source of rocker-arm only; fwp-ch has no time on flat-grid."""
    numbers = [text.get_text() for text in figure_of("speedup", run).axes[0].texts]
    assert sum(number.endswith(" (2 of 3 meshes)") for number in numbers) == 1


def test_without_mmp_another_solver_is_the_baseline(run: Run) -> None:
    drawn = FIGURES["speedup"](of_solvers(run, *(name for name in run.solvers if name != "mmp")))
    assert drawn.title == "Speed-up over fwp-mmp"
    assert "fwp-mmp" not in legend(drawn.figure)


def test_published_marks_are_filled_for_models_and_hollow_for_stand_ins(run: Run) -> None:
    marks = dots_of(figure_of("windows_over_limit", run), "d")
    by_row: dict[int, set[str]] = {}
    for mark in marks:
        row = round(float(mark.get_ydata()[0]))
        by_row.setdefault(row, set()).add(to_hex(mark.get_markerfacecolor()))
    assert len(marks) == 2 * len(THESIS_SOLVERS)
    assert "#ffffff" not in by_row[0] and by_row[1] == {"#ffffff"}


def test_truth_is_filled_and_the_word_of_a_solver_hollow(run: Run) -> None:
    def on_truth(row: Data) -> Data:
        return row | {"reference": "closed-form"} if row["mesh"] == "flat-grid" else row

    figure = figure_of("accuracy", changed_rows(run, on_truth))
    faces = [to_hex(mark.get_markerfacecolor()) for mark in dots_of(figure, "D")]
    assert faces == ["#ffffff", "#ffffff", "#000000"]


def test_no_error_at_all_is_drawn_at_the_floor_and_the_bound_is_always_in_sight(run: Run) -> None:
    run.columns.arrays["max_relative_error"] *= 0
    axes = figure_of("accuracy", run).axes[0]
    assert {float(mark.get_xdata()[0]) for mark in axes.lines if mark.get_marker() == "D"} == {
        dot_figures.FLOOR
    }
    low, high = axes.get_xlim()
    assert low < dot_figures.FLOOR < dot_figures.BOUND < high


def test_a_solver_with_too_few_sizes_for_a_fit_is_named(run: Run) -> None:
    drawn = growth.figure(renamed(run, SERIES))
    assert "Without: fwp-ch, ch, dijkstra (fewer than 3 sizes" in drawn.caption


def test_the_legend_has_the_exponents_of_the_growth_table(run: Run) -> None:
    fits = growth.exponents(renamed(run, SERIES))
    exponents = {row[0].text: row[-2].value for row in fits.rows}
    labels = dict(text.split(": ") for text in legend(figure_of("time_over_vertices", run)))
    assert set(labels) == set(exponents)
    for solver, value in exponents.items():
        assert labels[solver].startswith(f"$n^{{{value:.2f}}}$")
