"""Exact geodesic distances on triangle meshes.

>>> import geodesic_bench as gb
>>> mesh = gb.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
>>> mesh.distances([0]).round(6)
array([0.      , 1.      , 1.414214, 1.      ])

Distances are in the unit of the vertices' coordinates. Invalid arguments raise a ValueError with a message
of one sentence; an unknown name of an argument is a TypeError, an index out of range also an IndexError. Ctrl-C ends every call immediately; a solve that has begun continues in its own thread.
"""

from geodesic_bench._native import Defect, Solver, __version__
from geodesic_bench.arrays import Place
from geodesic_bench.field import Field
from geodesic_bench.functions import benchmark, verify
from geodesic_bench.lines import Isoline, LogMap, Path, StraightestLine, save_lines
from geodesic_bench.mesh import Mesh, defects, read_mesh, solvers
from geodesic_bench.prepared import Certificate, Prepared
from geodesic_bench.program import Results, run

__all__ = [
    "Certificate", "Defect", "Field", "Isoline", "LogMap", "Mesh", "Path", "Place", "Prepared", "Results", "Solver",
    "StraightestLine", "__version__", "benchmark", "defects", "read_mesh", "run", "save_lines", "solvers", "verify",
]  # fmt: skip
