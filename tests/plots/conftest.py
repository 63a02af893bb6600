"""The golden run with all data that figures need, and with recordings. Makes the helpers of this folder importable."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from plots import report, surface
from results.published import THESIS_SOLVERS
from results.reader import Run, read_run
from view import three
from view.three import Unavailable

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from synthetic import INEXACT, mean_edge_length, plane, record, torus  # noqa: E402  (needs the path above)

GOLDEN = HERE / "golden"
PHASES = {"propagation": 0.45, "trimming": 0.2, "queue": 0.3, "timer_overhead": 0.1}
"""Shares of the timed solve. Without timer_overhead, their sum is 0.95."""
SHAPES = {"rocker-arm": torus(108, 93), "flat-grid": plane(21, 21)}
"""Recorded meshes. Their numbers of vertices and faces are those of the golden run."""


@pytest.fixture
def golden_tables() -> Path:
    return GOLDEN / "tables"


@pytest.fixture(scope="session")
def reported(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder of the golden run with its report. Some words of the run would be markup."""
    folder = tmp_path_factory.mktemp("a run")
    data = json.loads((GOLDEN / "run" / "run.json").read_text())
    data["context"]["geodesic_bench"]["processor"] = "<script>alert(1)</script>"
    for row in data["benchmarks"]:
        if row["outcome"] != "ok":
            row["error_message"] = "a < b & </table><img src=x>"
    (folder / "run.json").write_text(json.dumps(data))
    assert report.main([str(folder)]) == 0
    return folder


@cache
def mean_edge_of(mesh: str) -> float:
    return mean_edge_length(*SHAPES[mesh])


def complete(data: dict[str, Any]) -> None:
    """Adds the values that the old rows of the golden run lack."""
    for row in data["benchmarks"]:
        if row["outcome"] == "ok" and row["solver"] in THESIS_SOLVERS:
            seconds = row["cpu_time"] / 1000
            row["phase_seconds"] = {key: share * seconds for key, share in PHASES.items()}
            row["wavefront_sd_edges"] = 0.2 + 0.1 * THESIS_SOLVERS.index(row["solver"])
    like = next(row for row in data["benchmarks"] if row["name"] == "mmp/rocker-arm/src:7")
    name = "fwp-mmp/rocker-arm/src:7"
    data["benchmarks"].append({**like, "name": name, "run_name": name, "solver": "fwp-mmp"})
    ours = data["context"]["geodesic_bench"]
    sources = ours["sources"]
    for mesh in ours["meshes"]:
        if mesh["name"] in SHAPES:
            mesh["mean_edge_length"] = mean_edge_of(mesh["name"])
    for row in data["benchmarks"]:
        mesh, source, solver = row["mesh"], row["source"], row["solver"]
        known = solver in (*THESIS_SOLVERS, INEXACT)
        recorded = mesh in SHAPES and source == sources[mesh][0] and known
        if row["outcome"] == "ok" and recorded:
            row["recordings"] = f"recordings/{mesh}/src{source}/{solver}"


@pytest.fixture(scope="session")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder with recordings of SHAPES, with the source vertices 7 and 0."""
    folder = tmp_path_factory.mktemp("recorded")
    for source, (mesh, geometry) in zip([7, 0], SHAPES.items(), strict=True):
        vertices, _ = geometry
        distances = np.linalg.norm(vertices - vertices[source], axis=1)
        record(folder, mesh, source, geometry, distances)
    return folder / "recordings"


def completed(folder: Path, recorded: Path) -> Run:
    """Returns the golden run with all data that figures need, with recordings, written to `folder`."""
    data = json.loads((GOLDEN / "run" / "run.json").read_text())
    complete(data)
    (folder / "run.json").write_text(json.dumps(data))
    (folder / "recordings").symlink_to(recorded)
    return read_run(folder)


@pytest.fixture(scope="session", autouse=True)
def coarse_pictures() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(surface, "PIXELS_PER_INCH", 60)
        yield


@pytest.fixture(scope="session")
def complete_run(recorded: Path, tmp_path_factory: pytest.TempPathFactory) -> Run:
    """The completed golden run. Tests must not change it."""
    return completed(tmp_path_factory.mktemp("complete"), recorded)


@pytest.fixture
def run(tmp_path: Path, recorded: Path) -> Run:
    return completed(tmp_path, recorded)


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    pytest.importorskip("selenium", reason="python3-selenium is not installed")
    import chromium

    if not chromium.is_installed():
        pytest.skip("chromium or chromium-driver is not installed")
    started = chromium.start()
    yield started
    started.quit()


@pytest.fixture
def page(browser: Any, address: str) -> Iterator[Any]:
    """The browser with the page at the module's address. The console must be empty after the test."""
    browser.get(address)
    yield browser
    assert browser.get_log("browser") == []


@pytest.fixture
def with_width(browser: Any) -> Iterator[Callable[[int], None]]:
    """with_width(pixels) sets the width of the screen. A width below 500 pixels emulates a phone."""

    def resize(width: int) -> None:
        metrics = {"width": width, "height": 800, "deviceScaleFactor": 1, "mobile": width < 500}
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)

    yield resize
    browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


@pytest.fixture(scope="session")
def with_three() -> None:
    """Makes three.js available or skips the test."""
    if not three.is_there():
        try:
            three.fetch(None)
        except Unavailable as error:
            pytest.skip(f"three.js: {error}")
