"""`geodesic-bench view`: an animated HTML page of a mesh with its distances and wavefronts."""
