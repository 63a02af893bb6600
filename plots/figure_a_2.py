"""Figure A.2: shape of the wavefront of mmp."""

from __future__ import annotations


from plots.drawing import Drawing
from results.reader import Run
from plots.wavefront_shape import shape


def figures(run: Run) -> list[Drawing]:
    return [shape(run, 2, "mmp")]
