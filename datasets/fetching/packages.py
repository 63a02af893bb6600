"""Upstream files in packages: npm packages through the client of npm, and installed Python packages."""

from __future__ import annotations

import importlib
import importlib.util
import json
import shutil
import subprocess
from pathlib import Path

from .archive import extract, points_outside
from .program import Package
from .reporting import Unavailable

NPM_SECONDS = 600  # a package of 11 MB takes one second
WITH_DATA_PATH = ("matplotlib",)
"""Python packages whose get_data_path() returns the folder of their data, which Debian moves."""


def file_of_package(package: Package, scratch: Path) -> Path:
    """Returns a copy in the scratch folder, or the installed file.

    Raises Unavailable if the package or its file cannot be obtained.
    """
    return _from_npm(package, scratch) if package.manager == "npm" else _from_python(package)


def _from_npm(package: Package, scratch: Path) -> Path:
    target = scratch / Path(package.file).name
    tarball = npm_package(package.name, package.version, scratch)
    extract(tarball, {f"package/{package.file}": target})
    return target


def npm_package(name: str, version: str, scratch: Path) -> Path:
    """Returns the package's .tgz file. npm packs it into the scratch folder and checks the hash of its
    registry; no script of the package is run. Raises Unavailable."""
    npm = shutil.which("npm")
    if npm is None:
        raise Unavailable(
            f"is in the npm package {name}, and there is no npm: install it (Debian: npm)"
        )
    what = f"{name}@{version}"
    options = ["--json", "--ignore-scripts", "--prefer-offline", "--fetch-retries=0"]
    command = [npm, "pack", what, *options, "--pack-destination", str(scratch)]
    try:
        done = subprocess.run(
            command,
            cwd=scratch,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=NPM_SECONDS,
        )
    except subprocess.TimeoutExpired:
        raise Unavailable(f"npm pack {what} took over {NPM_SECONDS} s") from None
    tarballs = list(scratch.glob("*.tgz"))
    if done.returncode != 0 or len(tarballs) != 1:
        raise Unavailable(f"npm pack {what} failed: {_npm_reason(done)}")
    return tarballs[0]


def _npm_reason(done: subprocess.CompletedProcess[str]) -> str:
    """Returns the reason of a failure from npm's JSON, or else the last line of its errors."""
    try:
        error = json.loads(done.stdout)["error"]
        words = f"{error['code']} {error['summary']}"
    except (ValueError, LookupError, TypeError):
        words = done.stderr.strip().split("\n")[-1]
    return " ".join(words.split()) or f"exit code {done.returncode}"


def _from_python(package: Package) -> Path:
    """Returns the file below the package's data folder, or else below the package.

    A manifest is only data, so a package is not imported unless it is one of WITH_DATA_PATH.
    """
    name, file = package.name, package.file
    spec = importlib.util.find_spec(name) if name.isidentifier() else None
    folders = list(spec.submodule_search_locations or []) if spec else []
    if not folders:
        raise Unavailable(
            f"is in the Python package {name}, which is not installed: "
            f"install it (Debian: python3-{name})"
        )
    if name in WITH_DATA_PATH:
        folders = [importlib.import_module(name).get_data_path()]
    if points_outside(file):
        raise Unavailable(f"'{file}' points outside the Python package {name}: not used")
    path = Path(folders[0]) / file
    if not path.is_file():
        raise Unavailable(f"the Python package {name} has no {path}")
    return path
