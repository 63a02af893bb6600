"""The shortest paths along edges, by SciPy: dijkstra.py VERTICES FACES SOURCES DISTANCES"""

import sys
import time

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

vertices, faces, sources, distances = sys.argv[1:]
points, corners = np.load(vertices), np.load(faces).astype(int)
if not sources:
    sys.exit()

start = time.perf_counter()
ends = np.sort(np.vstack([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]))
low, high = np.divmod(np.unique(ends[:, 0] * len(points) + ends[:, 1]), len(points))
lengths = np.linalg.norm(points[low] - points[high], axis=1)
graph = csr_matrix((lengths, (low, high)), shape=(len(points), len(points)))
print("prepare_time", time.perf_counter() - start)

start = time.process_time()
found = dijkstra(graph, False, [int(source) for source in sources.split(",")], min_only=True)
print("solve_time", time.process_time() - start)
np.save(distances, found)
