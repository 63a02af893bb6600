// Building the mesh that solvers share from what a reader hands over.
#include "solvers/core/mesh.h"

#include <benchmark/benchmark.h>

#include "benchmarks/per_item.h"
#include "meshes/generators/generators.h"

namespace geodesic {
namespace {

/// A terrain of range(0) by range(0) cells.
void mesh_construction(benchmark::State& state) {
  const ParameterValue cells = state.range(0);
  const TriangleSoup soup = generate("terrain", {{"columns", cells}, {"rows", cells}});
  for (auto _ : state) {
    const Mesh mesh(soup);
    benchmark::DoNotOptimize(&mesh);
  }
  microbench::report_per_item(state, "per_face", static_cast<std::int64_t>(soup.triangles.size()));
}
BENCHMARK(mesh_construction)->Arg(30)->Arg(300)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace geodesic
