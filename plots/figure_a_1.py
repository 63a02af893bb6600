#!/usr/bin/python3
"""Figure A.1: shape of the wavefront of edge-based."""

from __future__ import annotations

import sys

import console  # noqa: F401  first: it tells what cannot be imported

from command_line import draw
from drawing import Drawing
from results import Run
from wavefront_shape import shape


def figures(run: Run) -> list[Drawing]:
    return [shape(run, 1, "edge-based")]


if __name__ == "__main__":
    sys.exit(draw(__doc__, figures))
