"""Style of all figures: page width, type, and a colour, mark and line for each solver.

Importing this module sets matplotlib's defaults. Colours are those of Okabe and Ito, which
colour-blind readers can distinguish. They follow the families: blue is MMP, orange Chen-Han, black
edge-based; the variant with a bucket queue is lighter. Marks and lines distinguish the solvers in
grey prints too.

matplotlib reads text between dollars as mathematics: `plain` prepares a name for a drawn text.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure

from results.statistics import Estimate

WIDTH = 6.3
"""Width of the text of an A4 page in inches."""
DPI = 200

INK, PALE, GRID = "#222222", "#767676", "#dddddd"
ISOLINE, WAVEFRONT = "#EE442F", "#08407F"
"""Red and blue as in the thesis; in a grey print the isoline is lighter."""

matplotlib.rcParams.update(
    {
        "font.family": "STIXGeneral",
        "mathtext.fontset": "stix",
        "font.size": 10,
        "axes.titlesize": 10.5,
        "axes.edgecolor": INK,
        "axes.linewidth": 0.7,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.axisbelow": True,
        "grid.color": GRID,
        "grid.linewidth": 0.6,
        "hatch.linewidth": 0.6,
        "legend.frameon": False,
        "legend.fontsize": 9,
        "legend.handletextpad": 0.5,
        "legend.columnspacing": 1.4,
        "lines.linewidth": 1.2,
        "lines.scale_dashes": False,
        "lines.markersize": 5,
        "xtick.labelsize": 9,
        "ytick.labelsize": 9,
        "pdf.fonttype": 42,
    }
)

Dashes = tuple[int, tuple[float, ...]]
SOLID: Dashes = (0, ())


@dataclass(frozen=True)
class SolverStyle:
    color: str
    marker: str
    line: Dashes


_FIXED = {
    "mmp": SolverStyle("#0072B2", "o", SOLID),
    "fwp-mmp": SolverStyle("#56B4E9", "s", (0, (5, 2))),
    "ich": SolverStyle("#D55E00", "^", (0, (6, 2, 1, 2))),
    "fwp-ch": SolverStyle("#E69F00", "v", (0, (2, 1.5))),
    "edge-based": SolverStyle("#000000", "D", SOLID),
    "ch": SolverStyle("#CC79A7", "<", (0, (1, 2))),
    "cgal": SolverStyle("#009E73", "P", (0, (8, 2))),
    "dijkstra": SolverStyle("#999999", "X", (0, (1, 1))),
}
_SPARE = [
    SolverStyle("#882255", "p", (0, (5, 1, 1, 1, 1, 1))),
    SolverStyle("#B8A000", "h", (0, (3, 3))),
    SolverStyle("#332288", "*", (0, (10, 2))),
    SolverStyle("#44AA99", ">", (0, (4, 1))),
    SolverStyle("#661100", "8", (0, (7, 1, 1, 1))),
    SolverStyle("#6699CC", "H", (0, (1, 1, 4, 1))),
    SolverStyle("#AA4499", "P", (0, (2, 1))),
    SolverStyle("#117733", "X", (0, (9, 1, 2, 1))),
    SolverStyle("#A65628", "<", (0, (6, 1))),
]
"""Styles of the other solvers in the order of the run. Further settings of a solver come last."""
PALER = 0.65
"""Share of a spare colour that remains, beside white, each time the spare styles start again."""


def plain(name: str) -> str:
    """Returns a name as part of a drawn text, with its dollars escaped."""
    return name.replace("$", r"\$")


def solver_styles(solvers: Iterable[str]) -> dict[str, SolverStyle]:
    """Returns a style for each solver: its own, or the next spare one. The style of a solver's first
    setting does not depend on the number of settings."""
    names = list(solvers)
    others = [name for name in names if name not in _FIXED]
    first = set({name.split("?")[0]: name for name in reversed(others)}.values())
    order = sorted(others, key=lambda name: name not in first)
    spare = {name: _spare(number) for number, name in enumerate(order)}
    return {name: _FIXED.get(name) or spare[name] for name in names}


def _spare(number: int) -> SolverStyle:
    """Returns a spare style. After the last colour, the colours start again paler and with other marks."""
    again, place = divmod(number, len(_SPARE))
    style = _SPARE[place]
    share = PALER**again
    color = to_hex([1 - share * (1 - part) for part in to_rgb(style.color)])
    return replace(style, color=color, marker=_SPARE[(place + again) % len(_SPARE)].marker)


PUBLISHED: dict[str, Any] = {
    "marker": "d", "markersize": 7.5, "linestyle": "", "markeredgewidth": 0.9, "zorder": 2.5,
}  # fmt: skip
"""Mark of a number that the thesis prints, drawn behind ours. No other mark is a thin diamond."""


def published_mark(color: str, *, context: bool) -> dict[str, Any]:
    """@param context whether a stand-in was measured: the number is context only, and the mark hollow"""
    return PUBLISHED | {
        "markeredgecolor": color if context else INK,
        "markerfacecolor": "white" if context else color,
    }


def bars(estimates: Sequence[Estimate]) -> list[list[float]]:
    """Returns the lengths of the intervals below and above the values, as `errorbar` expects them."""
    return [[one.value - one.low for one in estimates], [one.high - one.value for one in estimates]]


def new_figure(height: float, width: float = WIDTH) -> Figure:
    """Returns a figure of a size in inches. pyplot does not hold it, so its last reference frees it."""
    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def legend_above(figure: Figure, handles: list[Any], columns: int = 5) -> None:
    """Draws a legend above all axes, with fewer columns if it would be too wide."""
    renderer = figure.canvas.get_renderer()
    for count in range(min(columns, len(handles)), 0, -1):
        legend = figure.legend(
            handles=handles, loc="upper center", ncols=count, borderaxespad=0.2
        )
        box = legend.get_window_extent(renderer)
        if box.width <= figure.bbox.width or count == 1:
            break
        legend.remove()
    share = (box.height + 0.08 * figure.dpi) / figure.bbox.height
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - share))


def save(figure: Figure, file: Path) -> None:
    """Writes PDF or PNG, by the file's extension. The same figure always gives the same bytes."""
    undated = {
        ".pdf": {"CreationDate": None, "Creator": None, "Producer": None},
        ".png": {"Software": None},
    }
    figure.savefig(file, dpi=DPI, metadata=undated[file.suffix])
