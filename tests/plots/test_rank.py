"""The figure of a ranking."""

from __future__ import annotations

from pathlib import Path

import pytest
from test_figures import cut_texts, dots_of, drawn_numbers, legend

from plots import rank
from plots.dots import Dot
from results.reader import ResultError

MESHES = ["horse", "rocker-arm", "flat-grid"]
RATIOS = {"edge-based": [0.5, 0.33, 0.4], "ich": [0.99, 1.02, 1.01], "mmp": [2.0, 2.5, 1.6]}
"""Time divided by that of the candidate, on each mesh."""


def dot(value: float, *, resolved: bool = True) -> Dot:
    return Dot(value, 0.95 * value, 1.05 * value, not resolved, (0.9 * value, 1.1 * value))


def ranking(
    ratios: dict[str, list[float]],
) -> tuple[str, dict[str, dict[str, Dot]], dict[str, Dot]]:
    """Returns the arguments of draw. The mean of each solver is its value on the first mesh."""
    meshes = {
        mesh: {
            solver: dot(values[i], resolved=solver != "ich")
            for solver, values in ratios.items()
            if i < len(values)
        }
        for i, mesh in enumerate(MESHES)
    }
    return "fwp-mmp", meshes, {s: dot(values[0]) for s, values in ratios.items() if values}


def test_every_mesh_and_the_mean_has_a_row_and_every_rival_a_mark_in_it() -> None:
    figure = rank.draw(*ranking(RATIOS))
    (axes,) = figure.axes
    assert [label.get_text() for label in axes.get_yticklabels()] == [*MESHES, rank.MEAN]
    for marker, solver in [("D", "edge-based"), ("o", "mmp")]:
        values = [float(mark.get_xdata()[0]) for mark in dots_of(figure, marker)]
        assert values == [*RATIOS[solver], RATIOS[solver][0]]
    assert axes.get_xscale() == "log"
    assert legend(figure) == ["edge-based", "ich", "mmp", "undecided"]
    assert cut_texts(figure) == []
    assert drawn_numbers(figure)


def test_what_is_undecided_is_hollow() -> None:
    figure = rank.draw(*ranking(RATIOS))
    faces = [mark.get_markerfacecolor() for mark in dots_of(figure, "^")]
    assert faces[:3] == ["white"] * 3 and faces[3] != "white"
    assert all(mark.get_markerfacecolor() != "white" for mark in dots_of(figure, "D"))


def test_1_is_in_sight_and_close_ratios_have_ticks_around_it() -> None:
    (axes,) = rank.draw(*ranking({"mmp": [1.05, 1.1, 1.2]})).axes
    low, high = axes.get_xlim()
    assert low < 1 < high
    assert sum(low <= tick <= high for tick in axes.get_xticks()) >= 3


def test_one_mesh_has_no_mean() -> None:
    (axes,) = rank.draw(*ranking({"mmp": [0.5]})).axes
    assert [label.get_text() for label in axes.get_yticklabels()] == ["horse"]


def test_many_rivals_with_long_names_still_fit() -> None:
    others = {f"a-variant-with-a-long-name-{number}": [1.1, 0.9, 30] for number in range(6)}
    assert cut_texts(rank.draw(*ranking(RATIOS | others))) == []


def test_without_any_time_there_is_no_figure() -> None:
    with pytest.raises(ResultError, match="fwp-mmp was timed against no other solver"):
        rank.draw(*ranking({"mmp": []}))


def test_the_same_ranking_gives_the_same_bytes(tmp_path: Path) -> None:
    def drawn() -> list[bytes]:
        return [file.read_bytes() for file in rank.write(rank.draw(*ranking(RATIOS)), tmp_path)]

    assert drawn() == drawn()
