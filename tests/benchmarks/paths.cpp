// Paths, traced over the faces that they cross.
#include "solvers/paths/paths.h"

#include <benchmark/benchmark.h>

#include "meshes/generators/generators.h"
#include "meshes/random.h"
#include "solvers/core/registry.h"
#include "tests/benchmarks/microbench.h"

namespace geodesic {
namespace {

/// From one vertex of a terrain of range(0) by range(0) cells to others by chance, which no path
/// has made the cache know.
void trace_path(benchmark::State& state) {
  const auto cells = static_cast<Index>(state.range(0));
  const Mesh mesh(generate("terrain", {{"columns", cells}, {"rows", cells}}),
                  Numbering::along_surface);
  const auto solver = make_solver("fwp-ch", mesh);
  const Paths paths = solve_paths(*solver, mesh, {.sources = {{.at = 0}}});
  Random random(1);
  std::int64_t faces = 0;
  for (auto _ : state) {
    faces +=
        static_cast<std::int64_t>(paths.to_vertex(random.below(mesh.vertex_count())).points.size());
  }
  state.counters["per_face"] = benchmark::Counter(
      static_cast<double>(faces), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(trace_path)->Arg(32)->Arg(224);

}  // namespace
}  // namespace geodesic
