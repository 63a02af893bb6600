"""`geodesic-bench view`: a mesh with its distances and wavefronts as one page that moves."""
