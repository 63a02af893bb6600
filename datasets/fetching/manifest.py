"""The manifest, read and checked: against its schema, then for what a schema cannot say."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import jsonschema

from .errors import FetchError

FOLDER = Path(__file__).resolve().parent.parent
DEFAULT_MANIFEST = FOLDER / "manifest.json"
SCHEMA = FOLDER / "manifest.schema.json"

Entry = dict[str, Any]  # a mesh or an elevation grid


class ManifestError(FetchError):
    """The manifest says something it must not; the message names the place."""


class Manifest:
    """A checked manifest.

    Raises ManifestError when the file cannot be read, breaks the schema (unknown keys included),
    uses a name or file twice, names a mesh, input or source that is not there, or makes a mesh
    from itself.
    """

    def __init__(self, path: Path = DEFAULT_MANIFEST) -> None:
        self._path = path
        data = _read(path)
        self._check_texts(data, [])
        self._check_schema(data)
        self.meshes: list[Entry] = data["meshes"]
        self.elevation_grids: list[Entry] = data["elevation_grids"]
        self.corpora: dict[str, list[str]] = data["corpora"]
        self.sources: dict[str, dict[str, str]] = data["sources"]
        self._entries = {entry["name"]: entry for entry in self.meshes + self.elevation_grids}
        self._check_names()
        self._check_corpora()
        for entry in self.meshes + self.elevation_grids:
            self._check_origin(entry)
            self._check_lineage(entry["name"], [])

    def entry(self, name: str) -> Entry:
        """A mesh or elevation grid. Raises ManifestError for an unknown one, listing the known."""
        if name not in self._entries:
            raise ManifestError(f"no mesh '{name}'; there are: {_listed(self._entries)}")
        return self._entries[name]

    def select(self, corpora: Iterable[str], names: Iterable[str]) -> list[Entry]:
        """The meshes of the corpora, then those named, each once.

        Raises ManifestError for an unknown corpus or mesh, listing the known ones.
        """
        wanted: dict[str, None] = {}
        for corpus in corpora:
            if corpus not in self.corpora:
                raise ManifestError(f"no corpus '{corpus}'; there are: {_listed(self.corpora)}")
            wanted.update(dict.fromkeys(self.corpora[corpus]))
        wanted.update(dict.fromkeys(names))
        return [self.entry(name) for name in wanted]

    def _check_texts(self, value: Any, place: list[str | int]) -> None:
        """No text has control characters: names become those of files, and all is shown."""
        if isinstance(value, str) and not value.isprintable():
            self._refuse("/".join(map(str, place)), f"{value!r} has a control character in it")
        elif isinstance(value, dict | list):
            for key, part in value.items() if isinstance(value, dict) else enumerate(value):
                self._check_texts(part, [*place, key])

    def _check_schema(self, data: Any) -> None:
        validator = jsonschema.Draft202012Validator(json.loads(SCHEMA.read_text("utf-8")))
        errors = list(validator.iter_errors(data))
        # An entry with any other error has all its keys called unevaluated.
        telling = [error for error in errors if error.validator != "unevaluatedProperties"]
        error = jsonschema.exceptions.best_match(telling or errors)
        if error is not None:
            self._refuse(_place(data, list(error.absolute_path)), error.message)

    def _check_names(self) -> None:
        for key in ("name", "file"):
            values = Counter(entry[key] for entry in self.meshes + self.elevation_grids)
            for value, times in values.items():
                if times > 1:
                    self._refuse("meshes", f"{key} '{value}' is used {times} times")

    def _check_corpora(self) -> None:
        meshes = {mesh["name"] for mesh in self.meshes}
        for corpus, members in self.corpora.items():
            for member in members:
                if member not in meshes:
                    self._refuse(f"corpora/{corpus}", f"there is no mesh '{member}'")

    def _check_origin(self, entry: Entry) -> None:
        place = f"mesh {entry['name']}"
        source = entry["path"].split("/")[0] if "path" in entry else None
        if source is not None and source not in self.sources:
            self._refuse(f"{place}: path", f"there is no source '{source}'")
        for parameter, name in entry.get("inputs", {}).items():
            if name not in self._entries:
                self._refuse(f"{place}: inputs/{parameter}", f"there is no mesh '{name}'")
            if parameter in entry["parameters"]:
                self._refuse(f"{place}: inputs/{parameter}", "is among the parameters too")

    def _check_lineage(self, name: str, below: list[str]) -> None:
        """No mesh is, at any remove, an input of itself. `below`: what `name` is an input of."""
        if name in below:
            loop = " from ".join([*below[below.index(name) :], name])
            self._refuse(f"mesh {name}: inputs", f"it is made from itself: {loop}")
        for source in self._entries[name].get("inputs", {}).values():
            self._check_lineage(source, [*below, name])

    def _refuse(self, place: str, message: str) -> None:
        raise ManifestError(f"{self._path}: at {place}: {message}")


def _read(path: Path) -> Any:
    try:
        return json.loads(path.read_text("utf-8"))
    except OSError as error:
        raise ManifestError(
            f"{path}: {error.strerror}: --manifest names a list of meshes such as"
            f" {DEFAULT_MANIFEST}"
        ) from error
    except ValueError as error:
        raise ManifestError(f"{path}: not JSON: {error}") from error
    except RecursionError:
        raise ManifestError(f"{path}: nested far deeper than a manifest is") from None


def _place(data: Any, path: list[str | int]) -> str:
    """'mesh horse: licence' where the mesh has a name, otherwise 'meshes/3/licence'."""
    if len(path) >= 2 and path[0] in ("meshes", "elevation_grids"):
        mesh = data[path[0]][path[1]]
        if isinstance(mesh, dict) and isinstance(mesh.get("name"), str):
            return ": ".join([f"mesh {mesh['name']}", *map(str, path[2:])])
    return "/".join(map(str, path)) or "the top level"


def _listed(names: Iterable[str]) -> str:
    return ", ".join(sorted(names))
