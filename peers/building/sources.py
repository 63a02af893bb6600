"""The authors' sources: fetched at the pinned commit, checked file by file, edited."""

from __future__ import annotations

import re
import shutil
from dataclasses import dataclass
from pathlib import Path

from fetching.archive import extract
from fetching.cache import check_sha256
from fetching.download import Downloader, Origin
from fetching.reporting import Unavailable

from .description import Edit, Peer, Repository


def github(path: str) -> str:
    return f"https://github.com/{path}"


@dataclass(frozen=True)
class Sources:
    """Where sources come from, and where archives are kept."""

    origin: Origin
    downloader: Downloader
    archives: Path

    def prepare(self, peer: Peer, target: Path) -> None:
        """Fills a folder with the files of the description, one folder a repository, edited.

        Raises Unavailable where a file cannot be had or is another one than described, or where a
        pattern of an edit matches nothing.
        """
        shutil.rmtree(target, ignore_errors=True)
        for repository in peer.upstream:
            self._unpack(repository, target / repository.name)
            for edit in repository.edits:
                _apply(edit, target / repository.name)

    def _unpack(self, repository: Repository, target: Path) -> None:
        archive = self._archive(repository)
        top = f"{repository.name}-{repository.commit}"
        targets = {f"{top}/{path}": target / path for path in repository.files}
        for file in targets.values():
            file.parent.mkdir(parents=True, exist_ok=True)
        extract(archive, targets)
        # The sums are the files': the same archive is compressed differently from year to year.
        for path, expected in repository.files.items():
            check_sha256(target / path, expected, f"{path} of {repository.repository}", "peer.json")

    def _archive(self, repository: Repository) -> Path:
        place = self.origin(repository.archive)
        if isinstance(place, Path):
            return place
        whole = self.archives / repository.archive
        if not whole.is_file():
            whole.parent.mkdir(parents=True, exist_ok=True)
            part = whole.with_suffix(".part")
            self.downloader.transfer(place, part, repository.repository)
            part.replace(whole)
        return whole


def _apply(edit: Edit, folder: Path) -> None:
    file = folder / edit.file
    # As bytes: line ends and encodings stay the authors'.
    text, times = re.subn(edit.pattern.encode(), edit.replacement.encode(), file.read_bytes())
    if times == 0:
        raise Unavailable(f"the edit {edit.pattern!r} matches nothing in {edit.file}")
    file.write_bytes(text)
