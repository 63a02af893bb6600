"""The shortest paths along edges, by VTK: dijkstra.py MESH SOURCE DISTANCES"""

import sys
import time

from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath
from vtkmodules.vtkIOGeometry import vtkOBJReader

mesh, sources, distances = sys.argv[1:]
reader = vtkOBJReader()
reader.SetFileName(mesh)
reader.Update()
if not sources:
    sys.exit()
if "," in sources:
    sys.exit("vtkDijkstraGraphGeodesicPath takes one source")

path = vtkDijkstraGraphGeodesicPath()
path.SetInputConnection(reader.GetOutputPort())
path.SetStartVertex(int(sources))
path.SetEndVertex(0)
path.StopWhenEndReachedOff()
start = time.process_time()
path.Update()
print("solve_time", time.process_time() - start)
found = vtkDoubleArray()
path.GetCumulativeWeights(found)
with open(distances, "w", encoding="ascii") as file:
    file.writelines(f"{found.GetValue(v)!r}\n" for v in range(found.GetNumberOfTuples()))
