"""Fetches the authors' sources at the pinned commit, checks each file, and applies the edits."""

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
    """The origin of the sources, and the folder of downloaded archives."""

    origin: Origin
    downloader: Downloader
    archives: Path

    def prepare(self, peer: Peer, target: Path) -> None:
        """Fills a folder with the edited files of the description, in one folder per repository.

        Raises Unavailable if a file cannot be obtained or differs from its description, or if the pattern
        of an edit matches nothing.
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
        try:
            extract(archive, targets)
            # Sums of the files, because the compression of the same archive may change over the years.
            for path, expected in repository.files.items():
                check_sha256(target / path, expected, f"{path} of {repository.repository}", "peer.json")
        except Unavailable:
            if archive.is_relative_to(self.archives):  # the next build downloads it again
                archive.unlink()
            raise

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
    # Bytes, so that line ends and encodings do not change.
    text, times = re.subn(edit.pattern.encode(), edit.replacement.encode(), file.read_bytes())
    if times == 0:
        raise Unavailable(f"the edit {edit.pattern!r} matches nothing in {edit.file}")
    file.write_bytes(text)
