"""The page of `geodesic-bench view` without a browser: its arrays, text and messages."""

from __future__ import annotations

import base64
import json
import re
import shutil
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from plots.recordings import FRAMES, SNAPSHOT, recordings
from results import console
from results.published import THESIS_SOLVERS
from results.reader import Run
from view import __main__ as command
from view import three
from view.page import page
from view.scene import PARTS, Edges, _segments, scene, with_frames

FACES = np.array([[0, 1, 2], [2, 1, 3], [0, 2, 4]])


def unpacked(array: dict[str, str]) -> Any:
    return np.frombuffer(zlib.decompress(base64.b64decode(array["data"])), "<" + array["type"])


def covered(half_edge: int, low: float, high: float) -> set[tuple[int, int, int]]:
    """Returns the parts of an edge that a segment covers, as (smaller vertex, larger vertex, part)."""
    a, b = FACES.ravel()[half_edge], np.roll(FACES, -1, axis=1).ravel()[half_edge]
    ends = sorted([round(low), round(high)] if a < b else [PARTS - round(high), PARTS - round(low)])
    return {(min(a, b), max(a, b), part) for part in range(*ends)}


def test_the_segments_of_a_frame_cover_what_its_windows_do() -> None:
    random = np.random.default_rng(5)
    edges = np.unique(np.sort(FACES[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)), axis=0)
    frame = np.zeros(60, SNAPSHOT)
    which = edges[random.integers(len(edges), size=len(frame))]
    turned = random.random(len(frame)) < 0.5
    frame["origin"], frame["head"] = np.where(turned[:, None], which[:, ::-1], which).T
    begin = random.integers(PARTS - 12, size=len(frame))
    frame["begin"], frame["end"] = begin / PARTS, (begin + random.integers(12, size=60)) / PARTS
    numbers = Edges(FACES)
    windows = set[tuple[int, int, int]]()
    for window in frame:
        (edge,), (backwards,) = numbers.numbers(window["origin"][None], window["head"][None])
        ends = PARTS * window["begin"], PARTS * window["end"]
        windows |= covered(edge, *((PARTS - ends[1], PARTS - ends[0]) if backwards else ends))
    steps, low, high = _segments(frame, numbers)
    segments = [
        covered(*one) for one in zip(np.cumsum(steps).tolist(), low.tolist(), high.tolist(), strict=True)
    ]
    assert set.union(*segments) == windows
    assert sum(map(len, segments)) == len(windows) and len(segments) < len(frame)


def test_a_frame_without_windows_has_no_segments() -> None:
    assert [len(one) for one in _segments(np.empty(0, SNAPSHOT), Edges(FACES))] == [0, 0, 0]


def test_the_scene_has_every_solver_frame_by_frame(complete_run: Run) -> None:
    recording = recordings(complete_run)[0]
    solvers = with_frames(recording)
    assert solvers == list(THESIS_SOLVERS)
    shown = scene(recording, solvers)
    assert unpacked(shown["faces"]).tolist() == recording.surface.faces.ravel().tolist()
    for solver in shown["solvers"]:
        frames = recording.frames(solver["name"])
        assert solver["windows"] == [len(frame) for frame in frames]
        assert len(solver["segments"]) == FRAMES and sum(solver["segments"]) == len(
            unpacked(solver["steps"])
        )
        first = unpacked(solver["first"])
        reached = [int((first < frame).sum()) for frame in range(FRAMES + 1)]
        shares = np.array(reached) / len(first)
        assert shares == pytest.approx(np.arange(FRAMES + 1) / FRAMES, abs=2 / FRAMES)


def test_the_axis_that_is_named_points_up(complete_run: Run) -> None:
    recording = recordings(complete_run)[0]
    for up in range(3):
        shown = scene(recording, [], up)
        assert shown["up"] == up and np.argmax(np.abs(shown["axes"][1])) == up


def test_no_name_ends_the_script_that_holds_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(three, "import_map", dict)
    monkeypatch.setattr(three, "licence", lambda: "a licence")
    evil = "</script><script>alert(1)</script>"
    text = page(evil, evil, evil, {"solvers": [{"name": evil}]})
    assert "<script>alert" not in text and "a licence" in text
    held = re.search(r'<script type="application/json" id="scene">(.*?)</script>', text)
    assert held and json.loads(held[1]) == {"solvers": [{"name": evil}]}


def test_another_three_js_is_not_taken(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(three, "FOLDER", tmp_path / "three")
    for file in three.FILES:
        (tmp_path / "package" / file).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "package" / file).write_text("alert(1)")
    archive = shutil.make_archive(str(tmp_path / "three"), "gztar", tmp_path, "package")
    assert three.main([archive]) == 3
    assert "is not that of three.js" in capsys.readouterr().err
    assert not three.is_there() and not (tmp_path / "three").exists()
    assert three.main([str(tmp_path / "none.tgz")]) == 1
    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.usefixtures("with_three")
@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["nothing.ply"], "not built; ./run_all.sh build makes it"),
        (["{run}", "--mesh", "cow"], "cow"),
        (["{run}", "--solvers", "mmp,dijkstra"], "no frames of dijkstra (those with frames: "),
        (["{run}", "--output", "/no/such/folder/page.html"], "cannot write"),
    ],
)
def test_what_cannot_be_shown_is_one_line(
    run: Run, words: list[str], says: str, capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    monkeypatch.delenv("GEODESIC_BENCH", raising=False)
    monkeypatch.setattr(console, "ROOT", run.file.parent)
    assert command.main([word.format(run=run.file.parent) for word in words]) == 1
    error = capsys.readouterr().err
    assert says in error and error.count("\n") == 1


def test_the_first_view_fetches_three_js_and_without_npm_a_line_says_how_to_get_it(
    run: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(three, "FOLDER", tmp_path / "three")
    monkeypatch.setenv("PATH", str(tmp_path))
    assert command.main([str(run.file.parent)]) == 1
    error = capsys.readouterr().err
    assert "there is no npm" in error and "three.py --help" in error and error.count("\n") == 1
