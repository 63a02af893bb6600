// Distances over the surface of a unit cube from one of its corners.
#include <cstdio>
#include <memory>
#include <vector>

#include "solvers/core/registry.h"

int main() {
  using namespace geodesic;
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                    {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<Triangle> triangles{{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7},
                                        {0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5},
                                        {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  const Mesh mesh(positions, triangles);
  const std::unique_ptr<Solver> solver = make_solver("edge-based", mesh);
  std::vector<double> distances(mesh.vertex_count());
  solver->solve({.sources = {{.at = 0}}}, distances);
  for (const double d : distances) std::printf("%.17g\n", d);
}
