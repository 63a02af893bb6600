"""Logarithmic axes with as many ticks as fit, labelled with plain numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache

import numpy as np
from matplotlib import rcParams
from matplotlib.axis import Axis
from matplotlib.textpath import TextPath
from matplotlib.ticker import (
    FuncFormatter, Locator, LogLocator, MaxNLocator, NullFormatter, NullLocator,
)  # fmt: skip

from plots import style

NARROW = 4.0
"""If the ratio of an axis's ends is smaller, its ticks have equal distances: 1, 2, 5 would be too few."""
MOST = 6
"""Largest number of such ticks."""
GAP = 9.0
"""Least distance between two labels in points."""


def logarithmic(*these: Axis) -> None:
    for axis in these:
        axis.axes.set(**{f"{axis.axis_name}scale": "log"})
        axis.set_major_locator(RoomyLocator())
        axis.set_major_formatter(FuncFormatter(lambda value, _: _label(value)))
        axis.set_minor_formatter(NullFormatter())


def ratio_axis(axis: Axis) -> None:
    """Makes a horizontal axis of ratios logarithmic, with a line at 1, which the axis always contains."""
    logarithmic(axis)
    axis.axes.autoscale(axis="x")
    low, high = axis.get_view_interval()
    low, high = min(low, 0.97), max(high, 1.03)
    if high < NARROW * low:
        axis.set_minor_locator(NullLocator())
    axis.axes.set_xlim(low, high)
    axis.axes.axvline(1, color=style.INK, linewidth=0.8, zorder=1)


def _label(value: float) -> str:
    return f"{value:,.10g}"


class RoomyLocator(Locator):  # type: ignore[misc]  # matplotlib has no types
    """Places the largest number of ticks whose labels do not touch."""

    def __call__(self) -> Sequence[float]:
        return self.tick_values(*sorted(self.axis.get_view_interval()))

    def tick_values(self, low: float, high: float) -> Sequence[float]:
        for ticks in _choices(low, high):
            shown = [tick for tick in ticks if low <= tick <= high]
            if self._has_room(shown):
                break
        return shown

    def _has_room(self, ticks: Sequence[float]) -> bool:
        across = self.axis.axis_name == "x"
        points = 72 / self.axis.figure.dpi * self.axis.axes.bbox.size[0 if across else 1]
        low, high = self.axis.get_view_interval()
        places = points * np.log(np.divide(ticks, low)) / np.log(high / low)
        sizes = np.array([_size(_label(tick))[0 if across else 1] for tick in ticks])
        return bool(np.all(np.diff(places) > (sizes[1:] + sizes[:-1]) / 2 + GAP))


def _choices(low: float, high: float) -> Iterator[Sequence[float]]:
    """Yields positions of ticks, from many ticks to few."""
    if high < NARROW * low:
        for most in range(MOST, 1, -1):
            yield MaxNLocator(most, steps=[1, 2, 5, 10]).tick_values(low, high)
    for digits in ((1, 2, 5), (1, 3), (1,)):
        yield LogLocator(subs=digits, numticks=99).tick_values(low, high)
    for decades in range(2, 20):
        yield LogLocator(base=10**decades, numticks=99).tick_values(low, high)


@cache
def _size(text: str) -> tuple[float, float]:
    """Returns the width and the height of a tick's label in points."""
    box = TextPath((0, 0), text, size=rcParams["xtick.labelsize"]).get_extents()
    return float(box.width), float(box.height)
