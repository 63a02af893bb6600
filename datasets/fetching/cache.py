"""The folder of mesh files ready to use: what has its final name is whole and checked."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

CHECKOUT = Path(__file__).resolve().parents[2]


class CacheError(Exception):
    """The cache cannot be written; nothing can be fetched."""


def default_cache() -> Path:
    """$GEODESIC_DATASETS, by default datasets/cache in the checkout."""
    return Path(os.environ.get("GEODESIC_DATASETS") or CHECKOUT / "datasets" / "cache")


def sha256_of(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


class Cache:
    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def holds(self, file: str, sha256: str, recipe: dict[str, Any] | None = None) -> bool:
        """Whether the file is there with these contents and, if generated, from this recipe."""
        path = self.folder / file
        if not path.is_file() or sha256_of(path) != sha256:
            return False
        return recipe is None or self._recipe_of(file) == recipe

    @contextmanager
    def scratch(self) -> Iterator[Path]:
        """A folder inside the cache, so that files can be renamed out of it; removed afterwards.

        Raises CacheError when the cache cannot be written.
        """
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            folder = Path(tempfile.mkdtemp(prefix=".fetch-", dir=self.folder))
        except OSError as error:
            raise CacheError(
                f"cannot write to the dataset cache {self.folder} ({error.strerror}): "
                "make it writable, or name another with --cache or GEODESIC_DATASETS"
            ) from error
        try:
            yield folder
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def adopt(self, whole: Path, file: str, recipe: dict[str, Any] | None = None) -> None:
        """Moves a finished file out of the scratch folder to its final name, in one step."""
        os.replace(whole, self.folder / file)
        if recipe is not None:
            note = whole.with_name("recipe.json")
            note.write_text(json.dumps(recipe, indent=1, sort_keys=True) + "\n", "utf-8")
            os.replace(note, self._recipe_path(file))

    def _recipe_path(self, file: str) -> Path:
        return self.folder / f"{file}.recipe.json"

    def _recipe_of(self, file: str) -> Any:
        try:
            return json.loads(self._recipe_path(file).read_text("utf-8"))
        except (OSError, ValueError):
            return None
