"""Makes datasets/ and the helpers of this folder importable."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "datasets")]

from fetch_world import Missing, World  # noqa: E402  (needs the path above)
from http_site import Site, serving  # noqa: E402

# The mirror with the real files. It is read before a test changes the variable.
REAL_MIRROR = os.environ.get("GEODESIC_DATASETS_MIRROR")


@pytest.fixture
def world(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> World:
    monkeypatch.setenv("GEODESIC_DATASETS_MIRROR", "")  # restored afterwards
    monkeypatch.setenv("NO_PROXY", "127.0.0.1")
    monkeypatch.setattr(sys, "argv", ["fetch.py"])  # messages begin with this name
    return World(tmp_path)


@pytest.fixture
def missing(world: World, capsys: pytest.CaptureFixture[str]) -> Missing:
    """missing(MIRROR) fetches the only mesh of the world, which must fail and leave no file. It returns
    the reason, one line."""

    def reason(mirror: str = "") -> str:
        assert world.fetch(mirror=mirror) == 3
        assert (world.cached(), world.leftovers()) == ([], [])
        (line,) = capsys.readouterr().err.splitlines()
        begin = f"{world.meshes[0]['name']}: missing: "
        assert line.startswith(begin)
        return line.removeprefix(begin)

    return reason


@pytest.fixture
def site(world: World) -> Iterator[Site]:
    """The mirror of the world, served over HTTP."""
    with serving(world.mirror) as served:
        yield served


@pytest.fixture
def real_mirror(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder that the environment names as a mirror of the real files."""
    if not REAL_MIRROR or not Path(REAL_MIRROR).is_dir():
        pytest.skip("GEODESIC_DATASETS_MIRROR names no folder")
    monkeypatch.setenv("NO_PROXY", "127.0.0.1")
    return Path(REAL_MIRROR)
