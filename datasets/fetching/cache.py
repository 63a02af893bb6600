"""The folder of mesh files that are ready to use: a file with its final name is complete and checked.

Unfinished files lie in the subfolder `.fetch`: one scratch folder for each file that is being made,
partial downloads, and the locks that prevent two processes from fetching the same file.
"""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from results.console import reason_of

from .program import ROOT
from .reporting import FetchError, Unavailable

WORK = ".fetch"


def default_cache() -> Path:
    """Returns $GEODESIC_DATASETS, by default datasets/cache in the checkout."""
    return Path(os.environ.get("GEODESIC_DATASETS") or ROOT / "datasets" / "cache")


def sha256_of(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def check_sha256(path: Path, expected: str, what: str) -> None:
    """Raises Unavailable for a file with another sum than the manifest's."""
    found = sha256_of(path)
    if found != expected:
        raise Unavailable(f"{what} has sha256 {found}, the manifest says {expected}: not used")


class Cache:
    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def holds(self, file: str, sha256: str, recipe: dict[str, Any] | None = None) -> bool:
        """Whether the cache has the file with these contents and, if generated, from this recipe.

        The contents are hashed each time. A cache has about 10^8 bytes, whose hashes take less time
        than the start of the first solve, and no stored result can become out of date.
        """
        path = self.folder / file
        try:
            if not path.is_file() or sha256_of(path) != sha256:
                return False
        except OSError as error:
            raise FetchError(
                f"cannot read the dataset cache {self.folder} ({reason_of(error)}): make it"
                " readable, or name another with --cache or GEODESIC_DATASETS"
            ) from error
        return recipe is None or self._recipe_of(file) == recipe

    @contextmanager
    def workspace(self, file: str, waits: Callable[[], None]) -> Iterator[Path]:
        """Yields an empty folder for making a file, on the file system of the cache; removed afterwards.

        Only one process at a time has the folder of a file. `waits` is called before waiting for
        another process. The rest of a killed process is removed. Raises FetchError if the cache cannot
        be written.
        """
        with self._locked(file, waits):
            folder = self.folder / WORK / "scratch" / file
            shutil.rmtree(folder, ignore_errors=True)
            self._make(folder)
            try:
                # A new name, because a generator may outlive its killed fetch and still write.
                yield Path(tempfile.mkdtemp(dir=folder))
            finally:
                shutil.rmtree(folder, ignore_errors=True)

    @contextmanager
    def partial(self, sha256: str, waits: Callable[[], None]) -> Iterator[Path]:
        """Yields the path of the partial download of the upstream file with this sha256.

        The file may not exist yet. It is kept for the next fetch unless it is removed or renamed.
        """
        folder = self.folder / WORK / "parts"
        self._make(folder)
        with self._locked(sha256, waits):
            yield folder / f"{sha256}.part"

    def adopt(self, whole: Path, file: str, recipe: dict[str, Any] | None = None) -> None:
        """Moves a finished file from the scratch folder to its final name, atomically."""
        os.replace(whole, self.folder / file)
        if recipe is not None:
            note = whole.with_name("recipe.json")
            note.write_text(json.dumps(recipe, indent=1, sort_keys=True) + "\n", "utf-8")
            os.replace(note, self._recipe_path(file))

    @contextmanager
    def _locked(self, name: str, waits: Callable[[], None]) -> Iterator[None]:
        """Holds a lock, which also ends if the process is killed. The empty lock file is kept: if it
        were removed, a third process could enter together with a waiting second one."""
        folder = self.folder / WORK / "locks"
        self._make(folder)
        with self._writing():
            file = (folder / f"{name}.lock").open("ab")  # writes nothing, because it may be a link
        with file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                waits()
                fcntl.flock(file, fcntl.LOCK_EX)
            yield

    def _make(self, folder: Path) -> None:
        with self._writing():
            folder.mkdir(parents=True, exist_ok=True)

    @contextmanager
    def _writing(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            raise FetchError(
                f"cannot write to the dataset cache {self.folder} ({reason_of(error)}): "
                "make it writable, or name another with --cache or GEODESIC_DATASETS"
            ) from error

    def _recipe_path(self, file: str) -> Path:
        return self.folder / f"{file}.recipe.json"

    def _recipe_of(self, file: str) -> Any:
        try:
            return json.loads(self._recipe_path(file).read_text("utf-8"))
        except (OSError, ValueError):
            return None
