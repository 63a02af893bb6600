"""The manifest, read and checked: against its schema, then for what a schema cannot say."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import jsonschema

FOLDER = Path(__file__).resolve().parent.parent
DEFAULT_MANIFEST = FOLDER / "manifest.json"
SCHEMA = FOLDER / "manifest.schema.json"

Mesh = dict[str, Any]


class ManifestError(Exception):
    """The manifest says something it must not; the message names the place."""


class Manifest:
    """A checked manifest.

    Raises ManifestError when the file cannot be read, breaks the schema (unknown keys included),
    uses a name or file twice, or names a mesh or source that is not there.
    """

    def __init__(self, path: Path = DEFAULT_MANIFEST) -> None:
        self._path = path
        data = _read(path)
        self._check_schema(data)
        self.meshes: list[Mesh] = data["meshes"]
        self.corpora: dict[str, list[str]] = data["corpora"]
        self.sources: dict[str, dict[str, str]] = data["sources"]
        self._check_names()

    def select(self, corpora: Iterable[str], names: Iterable[str]) -> list[Mesh]:
        """The meshes of the corpora, then those named, each once.

        Raises ManifestError for an unknown corpus or mesh, listing the known ones.
        """
        wanted: dict[str, None] = {}
        for corpus in corpora:
            if corpus not in self.corpora:
                raise ManifestError(f"no corpus '{corpus}'; there are: {_listed(self.corpora)}")
            wanted.update(dict.fromkeys(self.corpora[corpus]))
        wanted.update(dict.fromkeys(names))
        by_name = {mesh["name"]: mesh for mesh in self.meshes}
        for name in wanted:
            if name not in by_name:
                raise ManifestError(f"no mesh '{name}'; there are: {_listed(by_name)}")
        return [by_name[name] for name in wanted]

    def _check_schema(self, data: Any) -> None:
        validator = jsonschema.Draft202012Validator(json.loads(SCHEMA.read_text("utf-8")))
        error = jsonschema.exceptions.best_match(validator.iter_errors(data))
        if error is not None:
            self._refuse(_place(data, list(error.absolute_path)), error.message)

    def _check_names(self) -> None:
        for key in ("name", "file"):
            for value, times in Counter(mesh[key] for mesh in self.meshes).items():
                if times > 1:
                    self._refuse("meshes", f"{key} '{value}' is used {times} times")
        names = {mesh["name"] for mesh in self.meshes}
        for corpus, members in self.corpora.items():
            for member in members:
                if member not in names:
                    self._refuse(f"corpora/{corpus}", f"there is no mesh '{member}'")
        for mesh in self.meshes:
            source = mesh["path"].split("/")[0] if "path" in mesh else None
            if source is not None and source not in self.sources:
                self._refuse(f"mesh {mesh['name']}: path", f"there is no source '{source}'")

    def _refuse(self, place: str, message: str) -> None:
        raise ManifestError(f"{self._path}: at {place}: {message}")


def _read(path: Path) -> Any:
    try:
        return json.loads(path.read_text("utf-8"))
    except OSError as error:
        raise ManifestError(f"{path}: {error.strerror}") from error
    except ValueError as error:
        raise ManifestError(f"{path}: not JSON: {error}") from error


def _place(data: Any, path: list[str | int]) -> str:
    """'mesh horse: licence' where the mesh has a name, otherwise 'meshes/3/licence'."""
    if len(path) >= 2 and path[0] == "meshes":
        mesh = data["meshes"][path[1]]
        if isinstance(mesh, dict) and isinstance(mesh.get("name"), str):
            return ": ".join([f"mesh {mesh['name']}", *map(str, path[2:])])
    return "/".join(map(str, path)) or "the top level"


def _listed(names: Iterable[str]) -> str:
    return ", ".join(sorted(names))
