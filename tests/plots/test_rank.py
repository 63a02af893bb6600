"""The figure of a ranking, and what rank.json must be for it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import rank
from rankings import read_ranking
from results import ResultError
from test_figures import cut_texts, dots_of, drawn_numbers, legend

Folder = Callable[..., Path]
MESHES = ["horse", "rocker-arm", "flat-grid"]
RATIOS = {"edge-based": [2.0, 3.0, 2.5], "ich": [0.99, 1.02, 1.01], "mmp": [0.5, 0.4, 0.6]}
"""Of the candidate's time, on each mesh."""


def time(value: float, *, resolved: bool = True) -> dict[str, Any]:
    return {"value": value, "low": 0.95 * value, "high": 1.05 * value, "pairs": 9,
            "resolved": resolved}  # fmt: skip


def standing(solver: str, ratios: list[float]) -> dict[str, Any]:
    on = [
        {"mesh": mesh, "time": time(ratio, resolved=solver != "ich"), "least": 0.9 * ratio,
         "most": 1.1 * ratio, "windows": None, "memory": 1.5}
        for mesh, ratio in zip(MESHES, ratios, strict=False)
    ]  # fmt: skip
    return {
        "solver": solver, "time": time(ratios[0]) if ratios else None, "windows": None,
        "memory": None, "max_relative_error": 1e-15, "right": 3, "all": 3, "meshes": on,
    }  # fmt: skip


@pytest.fixture
def folder(golden_folder: Path, tmp_path: Path) -> Folder:
    """folder(ratios, change) has a rank.json of fwp-mmp against those solvers."""

    def make(
        ratios: dict[str, list[float]], change: Callable[[dict[str, Any]], object] = len
    ) -> Path:
        data = json.loads((golden_folder / "run.json").read_text())
        candidate: dict[str, list[float]] = {"fwp-mmp": []}
        data["ranking"] = {
            "candidate": "fwp-mmp", "verdict": "fwp-mmp is a solver.",
            "standings": [standing(*each) for each in (candidate | ratios).items()],
            "pairs": [], "unfinished": [], "remarks": [],
        }  # fmt: skip
        change(data)
        (tmp_path / "rank.json").write_text(json.dumps(data))
        return tmp_path

    return make


def test_every_mesh_and_the_mean_has_a_row_and_every_rival_a_mark_in_it(folder: Folder) -> None:
    figure = rank.draw(read_ranking(folder(RATIOS)))
    (axes,) = figure.axes
    assert [label.get_text() for label in axes.get_yticklabels()] == [*MESHES, rank.MEAN]
    for marker, solver in [("D", "edge-based"), ("o", "mmp")]:
        values = [float(mark.get_xdata()[0]) for mark in dots_of(figure, marker)]
        assert values == [*RATIOS[solver], RATIOS[solver][0]]
    assert axes.get_xscale() == "log"
    assert legend(figure) == ["edge-based", "ich", "mmp", "not resolved"]
    assert cut_texts(figure) == []
    assert drawn_numbers(figure)


def test_what_is_not_resolved_is_hollow(folder: Folder) -> None:
    figure = rank.draw(read_ranking(folder(RATIOS)))
    faces = [mark.get_markerfacecolor() for mark in dots_of(figure, "^")]
    assert faces[:3] == ["white"] * 3 and faces[3] != "white"
    assert all(mark.get_markerfacecolor() != "white" for mark in dots_of(figure, "D"))


def test_1_is_in_sight_and_close_ratios_have_ticks_around_it(folder: Folder) -> None:
    (axes,) = rank.draw(read_ranking(folder({"mmp": [1.05, 1.1, 1.2]}))).axes
    low, high = axes.get_xlim()
    assert low < 1 < high
    assert sum(low <= tick <= high for tick in axes.get_xticks()) >= 3


def test_one_mesh_has_no_mean(folder: Folder) -> None:
    (axes,) = rank.draw(read_ranking(folder({"mmp": [0.5]}))).axes
    assert [label.get_text() for label in axes.get_yticklabels()] == ["horse"]


def test_many_rivals_with_long_names_still_fit(folder: Folder) -> None:
    def lengthen(data: dict[str, Any]) -> None:
        like = data["context"]["geodesic_bench"]["solvers"][0]
        for number in range(6):
            name = f"a-variant-with-a-long-name-{number}"
            data["context"]["geodesic_bench"]["solvers"].append({**like, "name": name})
            data["ranking"]["standings"].append(standing(name, [1.1, 0.9, 30]))

    assert cut_texts(rank.draw(read_ranking(folder(RATIOS, lengthen)))) == []


def test_without_any_time_there_is_no_figure_and_one_line(
    folder: Folder, capsys: pytest.CaptureFixture[str]
) -> None:
    assert rank.main(["--rank", str(folder({"mmp": []}))]) == 1
    error = capsys.readouterr().err
    assert "fwp-mmp has no time beside a rival's" in error and error.count("\n") == 1


def test_the_same_ranking_gives_the_same_bytes(folder: Folder) -> None:
    where = folder(RATIOS)

    def drawn() -> list[bytes]:
        assert rank.main(["--rank", str(where)]) == 0
        return [(where / f"rank{extension}").read_bytes() for extension in (".pdf", ".png")]

    assert drawn() == drawn()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda data: data.pop("ranking"), "no ranking"),
        (lambda data: data["ranking"].pop("candidate"), "candidate"),
        (lambda data: data["ranking"]["standings"][1]["time"].update(value=0), "standings"),
        (lambda data: data["ranking"]["standings"].pop(), "standings"),
        (lambda data: data["context"].pop("geodesic_bench"), "geodesic_bench"),
    ],
)
def test_a_broken_file_is_refused_in_one_line(
    folder: Folder, change: Callable[[dict[str, Any]], object], words: str
) -> None:
    with pytest.raises(ResultError, match=rf"rank\.json: [^\n]*{words}[^\n]*$"):
        read_ranking(folder({"mmp": [0.5]}, change))


def test_a_folder_without_a_ranking_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ResultError, match="no such file"):
        read_ranking(tmp_path)
