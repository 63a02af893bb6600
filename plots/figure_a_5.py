#!/usr/bin/python3
"""Figure A.5: shape of the wavefront of fwp-ch."""

from __future__ import annotations

import sys

import console  # noqa: F401  first: it tells what cannot be imported

from command_line import draw
from drawing import Drawing
from results import Run
from wavefront_shape import shape


def figures(run: Run) -> list[Drawing]:
    return [shape(run, 5, "fwp-ch")]


if __name__ == "__main__":
    sys.exit(draw(__doc__, figures))
