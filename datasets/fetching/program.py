"""Calls geodesic-bench to read the manifest and to generate meshes."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any, TypeVar

from results.names import unknown_name

from .reporting import FetchError, Unavailable

ROOT = Path(__file__).resolve().parents[2]
"""Folder of the checkout, or of an installed copy: PREFIX/share/geodesic-bench."""
IS_CHECKOUT = (ROOT / "CMakeLists.txt").exists()
DEFAULT_BENCH = (
    ROOT / "build" / "release" / "geodesic-bench"
    if IS_CHECKOUT
    else ROOT.parent.parent / "bin" / "geodesic-bench"
)
DEFAULT_MANIFEST = ROOT / "datasets" / "manifest.json"

Value = TypeVar("Value")


@dataclass(frozen=True)
class Package:
    """A file in an npm package or in an installed Python package. The latter has no `version`."""

    manager: str
    name: str
    file: str
    version: str = ""


@dataclass(frozen=True)
class Entry:
    """A mesh or an elevation grid of the manifest (datasets/README.md), with the origin of its file.

    `kind` is generated, downloaded or package, and determines which other members are set.
    """

    name: str
    kind: str
    file: str
    sha256: str
    generator: str = ""
    parameters: Mapping[str, float | str] = field(default_factory=dict)
    inputs: Mapping[str, str] = field(default_factory=dict)
    path: str = ""
    package: Package | None = None
    upstream_sha256: str = ""
    archive_member: str = ""

    @staticmethod
    def of(data: dict[str, Any]) -> Entry:
        """Converts an entry in JSON. Its other keys are ignored."""
        own = {each.name: data[each.name] for each in fields(Entry) if each.name in data}
        if "package" in data:
            own["package"] = Package(**data["package"])
        return Entry(**own)


class Manifest:
    """The manifest, read and checked by `geodesic-bench list --json`.

    Raises FetchError if the program is missing, or with its message about a faulty manifest.
    """

    def __init__(self, bench: Path, path: Path = DEFAULT_MANIFEST) -> None:
        if not os.access(bench, os.X_OK):
            raise FetchError(
                f"geodesic-bench reads the list of meshes and is not at {bench}: "
                "build it (./run_all.sh build) or name it with --bench"
            )
        done = _run(bench, "list", "--json", "--manifest", str(path))
        if done.returncode != 0:
            raise FetchError(last_line(done).removeprefix("geodesic-bench: "))
        data = json.loads(done.stdout)
        self._sources: dict[str, str] = {
            name: source["base"] for name, source in data["sources"].items()
        }
        self.corpora: dict[str, list[str]] = data["corpora"]
        entries = map(Entry.of, data["meshes"] + data["elevation_grids"])
        self._entries = {entry.name: entry for entry in entries}

    def address(self, path: str) -> str:
        """Returns the address of an entry's `path`, whose first folder names a source."""
        source, file = path.split("/", 1)
        return self._sources[source] + file

    def entry(self, name: str) -> Entry:
        """Returns a mesh or elevation grid. Raises FetchError with all names for an unknown one."""
        return find(self._entries, name, "mesh")

    def select(self, corpora: Iterable[str], names: Iterable[str]) -> list[Entry]:
        """Returns the meshes of the corpora, then the named ones, each once. Raises FetchError."""
        chosen: dict[str, None] = {}
        for corpus in corpora:
            chosen.update(dict.fromkeys(find(self.corpora, corpus, "corpus")))
        chosen.update(dict.fromkeys(names))
        return [self.entry(name) for name in chosen]


def generate(bench: Path, mesh: Entry, inputs: Mapping[str, Path], target: Path) -> None:
    """Generates a mesh. `inputs`: the input file of each parameter that names one.

    Raises Unavailable with the program's message.
    """
    given: dict[str, object] = {**inputs, **mesh.parameters}
    parameters = [f"--{name}={value}" for name, value in given.items()]
    done = _run(bench, "generate", mesh.generator, *parameters, "-o", str(target))
    if done.returncode != 0:
        raise Unavailable(f"could not be generated: {last_line(done)}")


def _run(bench: Path, *words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(bench), *words], capture_output=True, text=True, check=False)


def last_line(done: subprocess.CompletedProcess[str]) -> str:
    """Returns the last line of the errors of a failed program, or else its exit code."""
    return (done.stderr.strip().splitlines() or [f"exit code {done.returncode}"])[-1]


def find(known: Mapping[str, Value], name: str, kind: str) -> Value:
    """Returns the value of a name. Raises FetchError with all names for an unknown one."""
    if name not in known:
        raise FetchError(unknown_name(kind, name, known))
    return known[name]
