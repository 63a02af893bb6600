"""The reader of recordings: its values, and its refusal of truncated and invalid files."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from synthetic import Data, changed_rows, mean_edge_length, plane, record

from plots.isolines import isoline, isolines, levels
from plots.recordings import CURVE, SNAPSHOT, Recording, recordings
from results.reader import Mesh, ResultError, Run

SIDE = 21


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, str]]:
    """Folder of the recording, and its folders by solver. Tests must not change it."""
    folder = tmp_path_factory.mktemp("square")
    vertices, faces = plane(SIDE, SIDE)
    return folder, record(folder, "square", 0, (vertices, faces), np.linalg.norm(vertices, axis=1))


@pytest.fixture
def recording(written: tuple[Path, dict[str, str]], tmp_path: Path) -> Recording:
    """Recording of a square. The source is a corner, and the distances are known."""
    folder, paths = written
    shutil.copytree(folder, tmp_path, dirs_exist_ok=True)
    vertices, faces = plane(SIDE, SIDE)
    edge = mean_edge_length(vertices, faces)
    mesh = Mesh("square", "", len(vertices), len(faces), edge, None, False)
    folders = {solver: tmp_path / path for solver, path in paths.items()}
    return Recording(mesh, 0, [0], tmp_path / "recordings" / "square" / "src0", folders)


def everything(recording: Recording) -> None:
    _ = recording.surface, recording.distances
    _ = recording.paths, recording.cells
    for solver in recording.solvers:
        recording.curve(solver)
        recording.wavefront(solver, 50)
        recording.frames(solver)
        recording.first_frames(solver)


def test_what_was_written_is_read(recording: Recording) -> None:
    everything(recording)
    assert recording.greatest == pytest.approx(np.sqrt(2))
    wavefront = recording.wavefront("mmp", 50)
    assert wavefront.shape[1:] == (2, 3) and len(wavefront) > SIDE


def test_isolines_are_where_the_distance_is_linear_between_vertices(recording: Recording) -> None:
    assert levels(recording) == pytest.approx(np.sqrt(2) * np.arange(1, 40) / 40)
    for level, line in zip(levels(recording), isolines(recording), strict=True):
        assert np.linalg.norm(line, axis=2) == pytest.approx(level, abs=0.02)
        above = recording.distances[recording.surface.faces] >= level
        assert len(line) == np.count_nonzero(above.any(axis=1) & ~above.all(axis=1))


def test_no_isoline_runs_where_a_corner_is_not_reached(recording: Recording) -> None:
    distances = recording.distances.copy()
    distances[1] = np.inf  # next to the source
    np.save(recording.folder / "distances.npy", distances)
    level = 0.5 / (SIDE - 1)
    whole, part = isoline(recording, level), isoline(replace(recording), level)
    assert len(part) == len(whole) - 1


FILES = [
    "../vertices.npy", "../faces.npy", "distances.npy",
    "mmp/curve.npy", "mmp/snapshot-50.npy", "mmp/reached_by.npy",
    "path_points.npy", "path_pieces.npy", "cell_sources.npy", "cells.npy",
]  # fmt: skip


@pytest.mark.parametrize("name", FILES)
class TestEveryFile:
    def test_missing_it_is_named_in_one_line(self, recording: Recording, name: str) -> None:
        (recording.folder / name).unlink()
        self.refused(recording, name, "no such file")

    def test_truncated_it_is_refused(self, recording: Recording, name: str) -> None:
        file = recording.folder / name
        whole = file.read_bytes()
        file.write_bytes(whole[: int(0.6 * len(whole))])
        self.refused(recording, name, "perhaps truncated")

    def test_of_another_kind_it_is_refused(self, recording: Recording, name: str) -> None:
        np.save(recording.folder / name, np.zeros((3, 3), ">i2"))
        self.refused(recording, name, "holds")

    def test_empty_it_is_refused(self, recording: Recording, name: str) -> None:
        data = np.load(recording.folder / name)
        np.save(recording.folder / name, data[:0])
        self.refused(recording, name, "has the shape")

    def refused(self, recording: Recording, name: str, why: str) -> None:
        with pytest.raises(ResultError, match=why) as caught:
            everything(recording)
        assert Path(name).name in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize("kept", [0, 5, 100])
def test_a_file_cut_before_its_numbers_is_refused(recording: Recording, kept: int) -> None:
    file = recording.folder / "distances.npy"
    file.write_bytes(file.read_bytes()[:kept])
    with pytest.raises(ResultError, match="perhaps truncated"):
        everything(recording)


Break = Callable[[np.ndarray[Any, Any]], object]


def put(field: str, value: float, index: int = 5) -> Break:
    def change(data: np.ndarray[Any, Any]) -> None:
        data[field][index] = value

    return change


INVALID: list[tuple[str, Break, str]] = [
    ("../vertices.npy", lambda data: data.fill(np.nan), "not finite"),
    ("../faces.npy", lambda data: data.fill(SIDE * SIDE), "does not exist"),
    ("distances.npy", lambda data: data.fill(np.nan), "not a number"),
    ("distances.npy", lambda data: data.fill(np.inf), "no vertex is reached"),
    ("distances.npy", lambda data: data.fill(0), "no vertex is reached"),
    ("distances.npy", lambda data: data.fill(-1), "negative"),
    ("mmp/curve.npy", put("sd", np.nan), "not a number"),
    ("mmp/curve.npy", put("mean", -1), "not a number"),
    ("mmp/curve.npy", put("reached", 0), "no progress"),
    ("path_pieces.npy", put("first", 1, 1), "fewer than two points"),
    ("path_pieces.npy", put("target", SIDE * SIDE, 0), "a target does not exist"),
    ("cell_sources.npy", lambda data: data.fill(SIDE * SIDE), "a source does not exist"),
    ("cells.npy", lambda data: data.fill(5), "a nearest source does not exist"),
    ("mmp/reached_by.npy", lambda data: data.fill(64), "not in the curve"),
    ("mmp/frame-9.npy", put("begin", np.nan), "beyond its edge"),
    ("mmp/snapshot-50.npy", put("origin", SIDE * SIDE), "not on an edge"),
    ("mmp/snapshot-50.npy", put("end", 1.5), "beyond its edge"),
    ("mmp/snapshot-50.npy", put("begin", -0.5), "beyond its edge"),
    ("mmp/snapshot-50.npy", put("begin", np.nan), "beyond its edge"),
    ("mmp/snapshot-50.npy", put("distance", np.inf), "not a number"),
]


@pytest.mark.parametrize(("name", "change", "why"), INVALID)
def test_invalid_contents_are_refused(
    recording: Recording, name: str, change: Break, why: str
) -> None:
    data = np.load(recording.folder / name)
    change(data)
    np.save(recording.folder / name, data)
    with pytest.raises(ResultError, match=why) as caught:
        everything(recording)
    assert Path(name).name in str(caught.value) and "\n" not in str(caught.value)


def test_a_recording_of_another_mesh_is_refused(recording: Recording) -> None:
    larger = replace(recording, mesh=replace(recording.mesh, vertices=SIDE * SIDE + 1))
    with pytest.raises(ResultError, match="has the shape"):
        everything(larger)


def test_vertices_that_cannot_be_reached_are_no_error(recording: Recording) -> None:
    distances = recording.distances.copy()
    distances[-1] = np.inf
    np.save(recording.folder / "distances.npy", distances)
    again = replace(recording)
    everything(again)
    assert np.isfinite(again.greatest) and again.greatest < np.sqrt(2)


def with_recordings(run: Run, of: dict[str, list[str]], source: int | None = None) -> Run:
    """Returns the run with rows that state recordings of these solvers on these meshes."""

    def change(row: Data) -> Data:
        mine = row["outcome"] == "ok" and row["solver"] in of.get(row["mesh"], ())
        mine = mine and row["source"] == (run.sources[row["mesh"]][0] if source is None else source)
        path = f"recordings/{row['mesh']}/src{row['source']}/{row['solver']}"
        return row | {"recordings": path} if mine else row

    return changed_rows(run, change)


def test_a_run_without_recordings_says_what_makes_them(golden_run: Run) -> None:
    with pytest.raises(ResultError, match=r"no recordings; run --recordings auto makes them$"):
        recordings(golden_run)
    some = with_recordings(golden_run, {"horse": ["mmp"]})
    with pytest.raises(ResultError, match="no recordings of ich and mmp;"):
        recordings(some, "ich", "mmp")


def test_models_of_the_thesis_and_those_with_more_solvers_come_first(golden_run: Run) -> None:
    run = with_recordings(
        golden_run,
        {"flat-grid": ["mmp", "ich", "fwp-mmp"], "horse": ["mmp"], "rocker-arm": ["mmp", "ich"]},
    )
    assert [one.mesh.name for one in recordings(run)] == ["rocker-arm", "horse", "flat-grid"]
    assert [one.mesh.name for one in recordings(run, "ich")] == ["rocker-arm", "flat-grid"]
    (first, *_) = recordings(run)
    assert (first.source, set(first.solvers)) == (7, {"mmp", "ich"})
    assert first.solvers["mmp"] == run.file.parent / "recordings/rocker-arm/src7/mmp"


def test_of_two_meshes_for_one_model_the_better_one_is_shown(golden_run: Run) -> None:
    twins = {
        name: replace(mesh, thesis_model="horse", stand_in=name != "horse")
        for name, mesh in golden_run.meshes.items()
    }
    run = replace(golden_run, meshes=twins)
    run = with_recordings(run, {"horse": ["mmp"], "rocker-arm": ["mmp"]})
    assert [one.mesh.name for one in recordings(run)] == ["horse"]


def test_recordings_of_a_real_run_are_as_the_readme_describes(real_run: Path) -> None:
    rows = json.loads((real_run / "run.json").read_text())["benchmarks"]
    folders = {real_run / row["recordings"] for row in rows if "recordings" in row}
    assert len(folders) >= 5
    for folder in folders:
        vertices = np.load(folder.parent.parent / "vertices.npy")
        faces = np.load(folder.parent.parent / "faces.npy")
        distances = np.load(folder.parent / "distances.npy")
        assert (vertices.dtype, faces.dtype, distances.dtype) == ("<f4", "<u4", "<f8")
        assert vertices.shape == (64, 3) and faces.shape == (98, 3) and distances.shape == (64,)
        if "dijkstra" in folder.as_posix():  # no windows: an inexact solver records its distances
            assert not (folder / "curve.npy").exists()
            continue
        curve = np.load(folder / "curve.npy")
        assert curve.dtype == CURVE and curve["reached"][-1] <= 64
        sides = {frozenset(side) for f in faces for side in zip(f, np.roll(f, 1), strict=True)}
        for moment in (25, 50, 75):
            windows = np.load(folder / f"snapshot-{moment}.npy")
            assert windows.dtype == SNAPSHOT
            assert len(windows) == curve["windows"][curve["reached"] >= 0.64 * moment][0]
            for origin, head in zip(windows["origin"], windows["head"], strict=True):
                assert frozenset((origin, head)) in sides
            assert (windows["begin"] >= 0).all() and (windows["end"] <= 1).all()
