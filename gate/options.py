"""The options that every comparison has: `geodesic-bench compare` and ./check_performance.sh."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Collection
from pathlib import Path

from results.console import Parser

MARGIN = 1.10


def number(accepts: Callable[[float], bool], what: str) -> Callable[[str], float]:
    """Returns a type of argparse. @param what the message for other values"""

    def parse(text: str) -> float:
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not accepts(value):
            raise argparse.ArgumentTypeError(f"'{text}': {what}")
        return value

    return parse


def _levels(known: Collection[int]) -> Callable[[str], tuple[int, ...]]:
    def parse(text: str) -> tuple[int, ...]:
        names = [str(level) for level in known]
        chosen = set(text.split(","))
        if not chosen <= set(names):
            words = f"{', '.join(names[:-1])} and {names[-1]}"
            raise argparse.ArgumentTypeError(f"'{text}': levels are {words}, as in 0,1")
        return tuple(sorted(map(int, chosen)))

    return parse


def add_to(parser: Parser, levels: tuple[int, ...]) -> None:
    """@param levels those that there are"""
    parser.add_argument(
        "--levels", type=_levels(levels), default=levels, metavar="A,B",
        help="only these levels, as in 0,1 (0 is always judged)",
    )  # fmt: skip
    parser.add_argument(
        "--margin", type=number(lambda value: 1 < value < 10, "a margin is a ratio above 1, as in 1.10"),
        default=MARGIN, metavar="RATIO", help=f"the ratio of times that level 4 accepts ({MARGIN:.2f})",
    )  # fmt: skip
    parser.add_argument("--strict", action="store_true", help="exit with 4 when a row is not resolved")
    parser.add_argument(
        "--out", type=Path, metavar="DIR", help="folder for verdict.md and verdict.json"
    )
