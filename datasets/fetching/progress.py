"""Progress bars on a terminal, and nothing where there is none."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TextIO

import tqdm


class Progress:
    """Draws on a terminal; None or anything else that is not a terminal gets nothing."""

    def __init__(self, terminal: TextIO | None) -> None:
        self._terminal = terminal if terminal is not None and terminal.isatty() else None

    @contextmanager
    def download(self, label: str, total: int | None, done: int) -> Iterator[Callable[[int], None]]:
        """A bar of bytes; the caller says how many more there are."""
        with tqdm.tqdm(
            desc=label,
            total=total,
            initial=done,
            unit="B",
            unit_scale=True,
            leave=False,
            file=self._terminal,
            disable=self._terminal is None,
        ) as bar:
            yield lambda count: bar.update(count) and None

    @contextmanager
    def working(self, label: str) -> Iterator[None]:
        """A line that is there for as long as something of unknown length goes on."""
        with tqdm.tqdm(
            desc=f"{label} ...",
            bar_format="{desc}",
            leave=False,
            file=self._terminal,
            disable=self._terminal is None,
        ):
            yield
