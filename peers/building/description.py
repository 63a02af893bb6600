"""The contents of peers/NAME/peer.json (peers/peer.schema.json)."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import jsonschema
from fetching.program import find
from fetching.reporting import FetchError

from results.console import reason_of
from results.text import NotText, read_text

PEERS = Path(__file__).resolve().parents[1]


@dataclass(frozen=True)
class Edit:
    """A change of a file before it is compiled: replaces every match of a regular expression. It
    quotes no line of the authors."""

    file: str
    """Path of the file in the repository."""
    pattern: str
    replacement: str
    why: str


@dataclass(frozen=True)
class Repository:
    """A repository at a commit, and its files that are compiled."""

    repository: str
    commit: str
    licence: str | None
    files: Mapping[str, str]
    """SHA-256 sums of the files, by path."""
    edits: Sequence[Edit] = ()

    @property
    def name(self) -> str:
        return self.repository.split("/")[1]

    @property
    def archive(self) -> str:
        """Path of its archive on github.com and in a mirror."""
        return f"{self.repository}/archive/{self.commit}.tar.gz"


@dataclass(frozen=True)
class Peer:
    """A public code, and the folder with its description and adapter."""

    folder: Path
    upstream: Sequence[Repository]
    authors_flags: str
    our_flags: str
    packages: Sequence[str]

    @property
    def name(self) -> str:
        return self.folder.name


def read_peer(folder: Path) -> Peer:
    """Reads a description. Raises FetchError with the fault of the description and its place."""
    file = folder / "peer.json"
    try:
        data = json.loads(read_text(file))
        jsonschema.validate(data, json.loads((PEERS / "peer.schema.json").read_text("utf-8")))
    except OSError as error:
        raise FetchError(reason_of(error)) from error
    except NotText as error:
        raise FetchError(str(error)) from error
    except ValueError as error:
        raise FetchError(f"{file} is not JSON: {error}") from error
    except jsonschema.ValidationError as error:
        where = "/".join(map(str, error.absolute_path)) or "the description"
        raise FetchError(f"{file}: {where}: {error.message}") from error
    return Peer(
        folder=folder,
        upstream=[_repository(**each) for each in data["upstream"]],
        authors_flags=data["flags"]["authors"],
        our_flags=data["flags"]["ours"],
        packages=data.get("packages", []),
    )


def _repository(edits: Iterable[dict[str, str]] = (), **data: Any) -> Repository:
    return Repository(**data, edits=[Edit(**edit) for edit in edits])


def select_peers(folder: Path, names: Iterable[str]) -> list[Peer]:
    """Returns the named peers, or all. Raises FetchError with all names for an unknown one."""
    known = {file.parent.name: file.parent for file in sorted(folder.glob("*/peer.json"))}
    chosen = [find(known, name, "peer") for name in dict.fromkeys(list(names) or known)]
    return [read_peer(folder) for folder in chosen]
