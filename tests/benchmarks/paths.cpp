// Paths, traced over the faces that they cross.
#include "solvers/paths/paths.h"

#include <benchmark/benchmark.h>

#include "meshes/generators/generators.h"
#include "meshes/random.h"
#include "solvers/core/registry.h"
#include "tests/benchmarks/microbench.h"

namespace geodesic {
namespace {

/// Traces paths from the first vertex to random vertices, whose faces are not in the cache.
/// @param solver name of the solver
void trace_paths(benchmark::State& state, const Mesh& mesh, const char* solver) {
  const auto solve = make_solver(solver, mesh);
  const Paths paths = solve_paths(*solve, mesh, {.sources = {{.at = 0}}});
  Random random(1);
  std::int64_t faces = 0;
  for (auto _ : state) {
    faces +=
        static_cast<std::int64_t>(paths.to_vertex(random.below(mesh.vertex_count())).points.size());
  }
  state.counters["per_face"] = benchmark::Counter(
      static_cast<double>(faces), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// A terrain of range(0) by range(0) cells.
TriangleSoup terrain(const benchmark::State& state) {
  const auto cells = static_cast<Index>(state.range(0));
  return generate("terrain", {{"columns", cells}, {"rows", cells}});
}

void trace_path(benchmark::State& state) {
  trace_paths(state, Mesh(terrain(state), Numbering::along_surface), "fwp-ch");
}
BENCHMARK(trace_path)->Arg(32)->Arg(224);

/// A terrain with a fin on an edge of every second face: paths cross edges of three faces.
void trace_path_over_sheets(benchmark::State& state) {
  TriangleSoup soup = terrain(state);
  const std::size_t faces = soup.triangles.size();
  for (std::size_t f = 0; f < faces; f += 2) {
    const Triangle& face = soup.triangles[f];
    Vec3 top = soup.positions[face[2]];
    top[2] += 1;
    soup.triangles.push_back({face[0], face[1], static_cast<Index>(soup.positions.size())});
    soup.positions.push_back(top);
  }
  trace_paths(state, Mesh(soup, Numbering::along_surface, NonManifoldEdges::crossed), "edge-based");
}
BENCHMARK(trace_path_over_sheets)->Arg(32)->Arg(224);

}  // namespace
}  // namespace geodesic
