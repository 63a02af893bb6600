"""Reports of a fetch: errors about one file or about all, and progress bars on a terminal."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TextIO

import tqdm

EXIT_MISSING = 3
"""Exit code if a file could not be obtained."""


class FetchError(Exception):
    """An error that ends the whole fetch. The message suggests what to do."""


class Unavailable(Exception):
    """One mesh or elevation grid cannot be obtained. The message has the reason and a suggestion."""


class Bars:
    """Progress on a terminal. Nothing is written to other streams."""

    def __init__(self, terminal: TextIO) -> None:
        self._terminal = terminal

    @contextmanager
    def download(self, label: str, total: int | None, done: int) -> Iterator[Callable[[int], object]]:
        """Shows a bar of bytes. Yields a function that adds a number of bytes."""
        with self._bar(desc=label, total=total, initial=done, unit="B", unit_scale=True) as bar:
            yield bar.update

    @contextmanager
    def working(self, label: str) -> Iterator[None]:
        """Shows a line during a task of unknown duration."""
        with self._bar(desc=f"{label} ...", bar_format="{desc}"):
            yield

    def _bar(self, **options: Any) -> tqdm.tqdm[Any]:
        terminal = self._terminal
        return tqdm.tqdm(**options, leave=False, file=terminal, disable=not terminal.isatty())
