"""Obtains the checked file of an entry of the manifest for the cache."""

from __future__ import annotations

import shutil
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from results import console

from .archive import extract, gunzip
from .cache import Cache, check_sha256
from .download import Downloader, Origin
from .packages import file_of_package
from .program import Entry, Manifest, generate
from .reporting import Bars, Unavailable


@dataclass(frozen=True)
class Fetcher:
    """Fills a cache, each entry at most once."""

    manifest: Manifest
    cache: Cache
    bench: Path
    """The program geodesic-bench."""
    origin: Origin
    """The place of upstream files that are downloaded."""
    progress: Bars
    downloader: Downloader
    _outcomes: dict[str, bool | Unavailable] = field(default_factory=dict)

    def fetch(self, entry: Entry) -> bool:
        """Ensures that the file of an entry is in the cache. Returns False if it was there before.

        Raises Unavailable if the file cannot be obtained, and FetchError if no file can.
        """
        if entry.name not in self._outcomes:
            try:
                self._outcomes[entry.name] = self._ensure(entry)
            except Unavailable as error:
                self._outcomes[entry.name] = error
        outcome = self._outcomes[entry.name]
        if isinstance(outcome, Unavailable):
            raise outcome
        return outcome

    def _ensure(self, entry: Entry) -> bool:
        recipe = self._recipe_of(entry)
        if self._is_there(entry, recipe):
            return False
        inputs = self._fetch_inputs(entry)
        began = time.monotonic()
        with self.cache.workspace(entry.file, self._waiting(entry)) as scratch:
            if self._is_there(entry, recipe):  # another process fetched it
                return False
            try:
                whole = self._obtain(entry, inputs, scratch)
                self.cache.adopt(whole, entry.file, recipe)
            except OSError as error:
                raise Unavailable(console.reason_of(error)) from error
        console.say(f"{entry.name}: fetched in {time.monotonic() - began:.1f} s")
        return True

    def _is_there(self, entry: Entry, recipe: dict[str, Any] | None) -> bool:
        return self.cache.holds(entry.file, entry.sha256, recipe)

    def _waiting(self, entry: Entry) -> Callable[[], None]:
        return lambda: console.say(f"{entry.name}: waiting for another fetch that is at it")

    def _recipe_of(self, entry: Entry) -> dict[str, Any] | None:
        """Returns the recipe of a generated mesh, with the sha256 of its inputs; None for other meshes."""
        if entry.kind != "generated":
            return None
        recipe: dict[str, Any] = {"generator": entry.generator, "parameters": entry.parameters}
        inputs = {key: self.manifest.entry(name).sha256 for key, name in entry.inputs.items()}
        return {**recipe, "inputs": inputs} if inputs else recipe

    def _fetch_inputs(self, entry: Entry) -> dict[str, Path]:
        files = {}
        for parameter, name in entry.inputs.items():
            source = self.manifest.entry(name)
            try:
                self.fetch(source)
            except Unavailable as error:
                raise Unavailable(f"needs {name}, which is missing: {error}") from error
            files[parameter] = self.cache.folder / source.file
        return files

    def _obtain(self, entry: Entry, inputs: dict[str, Path], scratch: Path) -> Path:
        """Generates or unpacks the file into the scratch folder, and checks it."""
        whole = scratch / entry.file
        if entry.kind == "generated":
            with self.progress.working(f"{entry.name}: generating"):
                generate(self.bench, entry, inputs, whole)
            check_sha256(whole, entry.sha256, f"what {self.bench.name} generated")
            return whole
        folder = scratch / "upstream"
        folder.mkdir()
        upstream = self._upstream_file(entry, folder)
        if entry.archive_member:
            extract(upstream, {entry.archive_member: whole})
        elif upstream.suffix == ".gz":
            gunzip(upstream, whole)
        else:
            shutil.copyfile(upstream, whole)
        check_sha256(whole, entry.sha256, f"{entry.file} out of {upstream.name}")
        return whole

    def _upstream_file(self, entry: Entry, folder: Path) -> Path:
        """Returns the checked upstream file, which may be outside the scratch folder."""
        if package := entry.package:
            with self.progress.working(f"{entry.name}: package {package.name}"):
                file = file_of_package(package, folder)
            what = f"{package.file} in the {package.manager} package {package.name}"
        else:
            place = self.origin(entry.path)
            if isinstance(place, str):
                return self._download(entry, place, folder)
            file, what = place, str(place)
        check_sha256(file, entry.upstream_sha256, what)
        return file

    def _download(self, entry: Entry, url: str, folder: Path) -> Path:
        target = folder / url.rsplit("/", 1)[1]
        sha256 = entry.upstream_sha256
        with self.cache.partial(sha256, self._waiting(entry)) as part:
            self.downloader.complete(url, part, sha256, entry.name)
            part.replace(target)
        return target
