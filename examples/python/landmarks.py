"""landmarks.py FILE COUNT: computes distances from COUNT landmarks of a mesh, each the farthest vertex from the
previous ones, and draws their cells to landmarks.png (docs/python.md)."""

import sys
import time

import geodesic_bench as gb
import numpy as np
from matplotlib import pyplot

file, count = sys.argv[1], int(sys.argv[2])
mesh = gb.read_mesh(file)

landmarks = [0]
nearest = mesh.distances(0)
while len(landmarks) < count:
    landmarks.append(int(np.argmax(np.where(np.isinf(nearest), -1, nearest))))
    nearest = np.minimum(nearest, mesh.distances(landmarks[-1], limit=nearest.max()))

start = time.perf_counter()
matrix = mesh.distance_matrix(landmarks, dtype="float32")
print(f"{matrix.shape} in {time.perf_counter() - start:.1f} s")

rings = np.floor(matrix[0][mesh.faces].mean(axis=1) / matrix[0].max() * 24) % 2
cells = matrix.argmin(axis=0)[mesh.faces[:, 0]] * 7 % 20
colours = pyplot.get_cmap("tab20")(cells.astype(int))[:, :3] * (1 - 0.3 * rings[:, None])
axes = pyplot.figure(figsize=(6, 6)).add_subplot(projection="3d")
surface = axes.plot_trisurf(*mesh.vertices.T, triangles=mesh.faces, linewidth=0, antialiased=False)
surface.set_facecolors(colours)
axes.set_box_aspect(np.ptp(mesh.vertices, axis=0))
axes.view_init(elev=10, azim=60)
axes.set_axis_off()
pyplot.savefig("landmarks.png", dpi=120, bbox_inches="tight")
