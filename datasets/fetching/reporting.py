"""What a fetch reports: errors, by how far they reach, and progress bars on a terminal."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TextIO

import tqdm

EXIT_MISSING = 3
"""Something could not be had."""


class FetchError(Exception):
    """Concerns all of the fetch: nothing more can be had. The message says what to do."""


class Unavailable(Exception):
    """One mesh or elevation grid cannot be had; the message says why and what to do."""


class Progress:
    """Draws on a terminal; anything else gets nothing."""

    def __init__(self, terminal: TextIO) -> None:
        self._terminal = terminal

    @contextmanager
    def download(self, label: str, total: int | None, done: int) -> Iterator[Callable[[int], object]]:
        """A bar of bytes; the caller says how many more there are."""
        with self._bar(desc=label, total=total, initial=done, unit="B", unit_scale=True) as bar:
            yield bar.update

    @contextmanager
    def working(self, label: str) -> Iterator[None]:
        """A line that is shown while something of unknown length runs."""
        with self._bar(desc=f"{label} ...", bar_format="{desc}"):
            yield

    def _bar(self, **options: Any) -> tqdm.tqdm[Any]:
        terminal = self._terminal
        return tqdm.tqdm(**options, leave=False, file=terminal, disable=not terminal.isatty())
