"""The numbers of the frontier, of the choice of a solver, and of the map of errors."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
import synthetic
from synthetic import EXCESS, INEXACT, Data, data_of, mesh, solver, with_rows

from plots import catalogue, error_map, frontier, report
from plots.drawing import Drawing, Picture
from plots.frontier import COSTS, ERRORS, Point
from results import published
from results.reader import ResultError, Run, Solver
from results.table import Field, Table

ONE, THOUSAND = "1 source", "each of 1,000 sources"
LARGEST = ERRORS["largest relative error"]
MESHES = {"large": mesh("large", 100_000), "small": mesh("small", 1000)}
EXACT = solver("edge-based")
HEAT = solver("heat", "unbounded")
STEINER = [
    solver(f"steiner?points={k}" if k != 3 else "steiner", "upper_bound", values={"points": k})
    for k in (7, 1, 3)
]
BOUNDED = solver("near", "bounded", error_bound=0.03)


def row(of: Solver, time: float, largest: float = 0, mesh: str = "small", **more: float) -> Data:
    errors = {"max_relative_error": largest, "mean_relative_error": largest / 10}
    return synthetic.row(of.name, mesh, cpu_time=time) | errors | more


def run_of(solvers: list[Solver], rows: list[Data], *plugins: str) -> Run:
    return synthetic.run_of(solvers, MESHES.values(), rows, plugins=[{"solvers": plugins}])


def sweep() -> Run:
    """Exact in 10 ms, Steiner points in 2, 4, 30 ms, bounded in 5 ms, and a heat method that prepares for 1 s."""
    return run_of(
        [EXACT, *STEINER, HEAT, BOUNDED],
        [
            row(EXACT, 10), row(STEINER[0], 30, 1e-3), row(STEINER[1], 2, 0.1),
            row(STEINER[2], 4, 0.04), row(HEAT, 1, 0.2, prepare_time=1000), row(BOUNDED, 5, 0.005),
        ],
        "heat",
    )  # fmt: skip


def points(run: Run, mesh: str = "small") -> dict[str, Point]:
    return {point.solver.name: point for point in frontier.measured(run, mesh)}


def test_each_of_many_sources_takes_its_share_of_the_preparation() -> None:
    heat = points(run_of([HEAT], [row(HEAT, 2, 0.1, prepare_time=100, renew_time=1)]))["heat"]
    costs = [1000 * heat.costs[name].value for name in COSTS]
    assert costs == pytest.approx([102, (102 + 9 * 3) / 10, (102 + 99 * 3) / 100, 3.099, 3])


def test_on_the_front_is_what_nothing_beats_in_time_and_error_alike() -> None:
    every = points(sweep()).values()
    assert [p.solver.name for p in frontier.front(every, ONE, LARGEST)] == [
        "edge-based", "near", "steiner", "steiner?points=1",
    ]  # fmt: skip
    assert [p.solver.name for p in frontier.front(every, THOUSAND, LARGEST)][-1] == (
        "steiner?points=1"
    )
    assert frontier.front(every, "each further source", LARGEST)[-1].solver is HEAT


def test_settings_of_one_solver_are_a_curve_in_the_order_of_their_parameter() -> None:
    run = sweep()
    found = {one.label: one for one in frontier.curves(run, list(points(run).values()))}
    assert list(found) == ["edge-based", "steiner: points 1, 3, 7", "heat*", "near"]
    curve = found["steiner: points 1, 3, 7"]
    assert curve.joined and [p.largest for p in curve.points] == [0.1, 0.04, 1e-3]


def test_settings_that_differ_in_two_parameters_are_not_joined() -> None:
    both = [solver(f"s?a={a}&b={b}", "unbounded", values={"a": a, "b": b}) for a, b in [(1, 1), (2, 2)]]
    same = [solver(f"s?a={a}&b=5", "unbounded", values={"a": a, "b": 5}) for a in (2, 1)]
    for solvers, label in [(both, "s: 2 settings"), (same, "s?b=5: a 1, 2")]:
        run = run_of(solvers, [row(each, 1, 0.1) for each in solvers])
        (curve,) = frontier.curves(run, list(points(run).values()))
        assert (curve.label, curve.joined) == (label, solvers is same)


def test_over_meshes_times_are_ratios_and_errors_the_largest_and_the_mean() -> None:
    rows = [
        row(EXACT, 10), row(HEAT, 20, 0.1), row(BOUNDED, 5, 0.02),
        row(EXACT, 100, mesh="large"), row(HEAT, 50, 0.3, mesh="large"),
    ]  # fmt: skip
    run = run_of([EXACT, HEAT, BOUNDED], rows)
    exact, heat = frontier.over_meshes(run, list(run.meshes.values()), "edge-based")
    assert (exact.solver, exact.costs[ONE].value) == (EXACT, 1)
    assert heat.costs[ONE].value == pytest.approx((2 * 0.5) ** 0.5)
    assert (heat.largest, heat.mean) == pytest.approx((0.3, 0.02))
    caption = frontier.figure(run).caption
    assert "Without: near (not right or not timed on every mesh)." in caption


def marks(axes: Axes) -> dict[float, tuple[float, bool]]:
    """Returns the error of each drawn mark and whether it is filled, by time in milliseconds."""
    return {
        round(1000 * float(line.get_ydata()[0]), 6): (
            float(line.get_xdata()[0]), to_hex(line.get_markerfacecolor()) != "#ffffff",
        )
        for line in axes.lines
        if line.get_marker() not in ("", "None")
    }  # fmt: skip


def test_points_are_where_they_were_measured_and_filled_where_the_error_is_bounded() -> None:
    axes = frontier.figure(sweep()).figure.axes[-2]  # the last row has the labels
    found = marks(axes)
    assert found[30] == (1e-3, False) and found[4] == (0.04, False) and found[5] == (0.005, True)
    zero, filled = found[10]
    assert filled and zero < 1e-3 and axes.get_xticklabels()[0].get_text() == "0"
    lines = [(list(line.get_xdata()), list(line.get_ydata())) for line in axes.lines]
    assert ([0.005, 0.03], [0.005, 0.005]) in lines, "from its error to its bound"


def test_a_published_method_is_drawn_by_its_time_over_that_of_a_solver_of_the_run() -> None:
    (gsp,) = published.methods()
    beside = solver(gsp.beside)
    rows = [
        row(of, time, error, mesh)
        for mesh in MESHES
        for of, time, error in [(EXACT, 10, 0), (HEAT, 20, 0.1), (BOUNDED, 5, 0.02), (beside, 60, 0)]
    ]
    drawing = frontier.figure(run_of([EXACT, HEAT, BOUNDED, beside], rows))
    time = 6 * gsp.time_s / gsp.beside_time_s
    largest, mean = drawing.figure.axes[:2]
    assert marks(mean)[round(1000 * time, 6)] == (gsp.mean_relative_error, False)
    assert round(1000 * time, 6) not in marks(largest)
    assert f"{gsp.method} as published" in drawing.caption
    without = [each for each in rows if each["solver"] != gsp.beside]
    assert gsp.method not in frontier.figure(run_of([EXACT, HEAT, BOUNDED], without)).caption


def test_a_wrong_answer_is_not_drawn_and_the_caption_says_so() -> None:
    run = sweep()
    wrong = {"solver": "near", "mesh": "small", "source": 0, "outcome": "wrong answer"}
    run = with_rows(run, [row if row["solver"] != "near" else wrong for row in data_of(run)])
    assert "near" not in points(run)
    assert "near: wrong answer on small" in frontier.figure(run).caption


def test_each_mesh_of_a_run_of_several_has_a_page_of_its_own() -> None:
    run = sweep()
    rows = [row | {"mesh": mesh} for mesh in MESHES for row in data_of(run)]
    both = with_rows(run, rows, meshes=MESHES, sources={m: [0] for m in MESHES})
    drawn, _ = catalogue.draw(both, ["frontier"])
    assert list(drawn) == ["frontier", "frontier_of_large", "frontier_of_small"]
    assert {catalogue.base_name(name) for name in drawn} == {"frontier"}
    assert isinstance(of_all := drawn["frontier"], Drawing)
    texts = [text.get_text() for text in of_all.figure.texts]
    assert texts == ["time of an answer / edge-based"]
    assert list(catalogue.draw(run, ["frontier"])[0]) == ["frontier"]


def test_a_run_of_one_inexact_setting_is_no_frontier() -> None:
    run = run_of([EXACT, HEAT], [row(EXACT, 1), row(HEAT, 1, 0.1)])
    for draw in (frontier.figure, frontier.which_to_take):
        with pytest.raises(ResultError, match="no 2 inexact solvers or settings with a time"):
            draw(run)


# ---- which solver to take


def choices(table: Table) -> dict[float, list[Field]]:
    """Returns the solvers for 1, 10 and 1,000 sources, by level."""
    return {float(str(line[2].value)): line[3::2] for line in table.rows}


def test_the_fastest_that_keeps_the_level_is_taken() -> None:
    largest = choices(frontier.which_to_take(sweep()))
    taken = {level: [cell.text for cell in cells] for level, cells in largest.items()}
    assert taken[0] == ["edge-based"] * 3 and taken[1e-3] == ["edge-based"] * 3
    assert taken[1e-2] == ["near"] * 3 and taken[5e-2] == ["steiner"] * 3
    mean = choices(frontier.which_to_take_mean(sweep()))
    assert [cell.text for cell in mean[5e-2]] == ["steiner?points=1"] * 3


def test_a_footnote_says_where_the_level_is_not_promised() -> None:
    largest = choices(frontier.which_to_take(sweep()))
    assert largest[0][0].note == ""
    for level in (1e-2, 5e-2):  # the bounded solver promises 0.03, Steiner points promise nothing
        assert "does not promise" in largest[level][0].note
    near = run_of([EXACT, HEAT, BOUNDED], [row(EXACT, 9), row(HEAT, 9, 1), row(BOUNDED, 5, 0.005)])
    assert choices(frontier.which_to_take(near))[5e-2][0].note == ""


def test_a_footnote_names_what_may_be_as_fast() -> None:
    noisy = [
        row(of, time, error, repetition_index=i)
        for of, error, times in [(EXACT, 0, (10, 12, 11)), (BOUNDED, 1e-5, (11, 10, 10)),
                                 (HEAT, 1e-5, (20, 21, 20))]
        for i, time in enumerate(times)
    ]  # fmt: skip
    best = choices(frontier.which_to_take(run_of([EXACT, BOUNDED, HEAT], noisy)))[1e-2][0]
    assert best.text == "near" and "Not resolved from edge-based." in best.note


def test_without_an_exact_solver_nothing_is_taken_at_0_and_sizes_rise() -> None:
    run = run_of(
        [HEAT, BOUNDED],
        [row(of, 1, 0.02, mesh=mesh) for of in (HEAT, BOUNDED) for mesh in MESHES],
    )
    rows = frontier.which_to_take(run).rows
    assert [line[0].value for line in rows[::5]] == ["small", "large"]
    assert [cell.text for cell in rows[0][3::2]] == ["none"] * 3


# ---- the map


def test_the_map_says_how_large_errors_are_near_the_source_and_far_from_it(run: Run) -> None:
    caption = error_map.figure(run).caption
    assert f"{INEXACT}: 0.0e+00 in the mean over the tenth of the vertices nearest" in caption
    assert f"{EXCESS:.1e} over the farthest, nowhere too short" in caption


def test_the_map_of_a_solver_is_of_the_setting_nearest_to_one_per_cent(run: Run) -> None:
    """The run has one setting with an error of 5%, and another with distances that are 0.9% too short."""
    folder = run.file.parent / "recordings"
    (first, *_) = [r for r in run.rows if r.solver == INEXACT and r.recordings]
    name = f"{INEXACT}?points=9"
    exact = folder.parent / str(first.recordings) / ".." / "distances.npy"
    better = np.load(exact) * (1 - 0.009)
    own = run.file.parent / "own" / first.mesh / f"src{first.source}" / "better"
    own.mkdir(parents=True)
    for file in ("vertices.npy", "faces.npy"):
        (own.parent.parent / file).symlink_to((folder / first.mesh / file).resolve())
    for each in exact.resolve().parent.iterdir():
        (own.parent / each.name).symlink_to(each)
    np.save(own / "distances.npy", better)
    moved = [
        row | {"recordings": row["recordings"].replace("recordings/", "own/", 1)}
        for row in data_of(run)
        if row["mesh"] == first.mesh and "recordings" in row
    ]
    better_row = {"solver": name, "recordings": f"own/{first.mesh}/src{first.source}/better"}
    swept = with_rows(
        run,
        [*moved, first.data | better_row],
        solvers=run.solvers | {name: replace(run.solvers[INEXACT], name=name)},
    )
    drawing = error_map.figure(swept)
    titles = [axes.get_title().splitlines()[0] for axes in drawing.figure.axes if axes.get_title()]
    assert titles == [name]
    assert "largest 9.0e-03, mean 9.0e-03" in drawing.figure.axes[0].get_title()
    assert "too short at 100% of the vertices" in drawing.caption


def test_the_report_shows_how_each_page_is_drawn(tmp_path: Path, run: Run) -> None:
    file = tmp_path / "frontier_of_small.png"
    file.write_bytes(b"")
    drawn = {"frontier_of_small": Picture.of(frontier.figure(sweep()), file)}
    page = report.page(run, drawn, {})
    assert "python3 -m plots frontier --run" in page and 'id="frontier_of_small"' in page
