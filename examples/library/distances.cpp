// distances MESH_FILE: prints the distance of each vertex from vertex 0 over the surface, one per
// line, and the shortest path to the farthest one.
#include <geodesic/geodesic.h>

#include <cstdio>
#include <exception>

using namespace geodesic;

int main(int argument_count, char** arguments) try {
  if (argument_count != 2) {
    std::fprintf(stderr, "Usage: distances MESH_FILE\n");
    return 1;
  }
  const SurfaceMesh mesh = read_mesh(arguments[1]);
  DistanceSolver solver(mesh);
  const Field field = solver.from({0});
  Index farthest = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    std::printf("%.17g\n", field[v]);
    if (field[v] < kInfinity && field[v] > field[farthest]) farthest = v;
  }
  const Path path = field.path_to(farthest);
  std::fprintf(stderr, "vertex %u is the farthest: %.17g, by a path over %zu faces\n", farthest,
               path.length(), path.points.size() - 1);
} catch (const std::exception& error) {
  std::fprintf(stderr, "distances: %s\n", error.what());
  return 1;
}
