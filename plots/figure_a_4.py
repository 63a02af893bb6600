"""Figure A.4: shape of the wavefront of ich."""

from __future__ import annotations


from plots.drawing import Drawing
from results.reader import Run
from plots.wavefront_shape import shape


def figures(run: Run) -> list[Drawing]:
    return [shape(run, 4, "ich")]
