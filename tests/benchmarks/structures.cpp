// Memory of solvers for their windows, and the construction of the mesh.
#include <benchmark/benchmark.h>

#include <vector>

#include "meshes/generators/generators.h"
#include "solvers/chen_han/propagation.h"
#include "solvers/core/pool.h"
#include "solvers/core/recorders.h"
#include "solvers/edge_based/window_lists.h"
#include "solvers/mmp/edge_lists.h"
#include "tests/benchmarks/microbench.h"

namespace geodesic {
namespace {

/// Two batches of range(0) windows arrive at an edge, one at each end. The list of an edge that was
/// filled a thousand edges earlier is consumed.
void window_lists(benchmark::State& state) {
  constexpr Index kEdges = 1024;
  edge_based::WindowLists lists(kEdges, fields_with(edge_based::Carried::nothing));
  const auto windows = static_cast<std::size_t>(state.range(0));
  const auto add = [&](Index edge, edge_based::Place place) {
    auto* segment = lists.allocate(windows);
    segment->count = static_cast<std::uint32_t>(windows);
    for (std::size_t i = 0; i < windows; ++i) segment->array(edge_based::kBegin)[i] = 1;
    lists.add(edge, segment, place);
  };
  Index edge = 0;
  double sum = 0;
  for (auto _ : state) {
    lists.consume(edge, [&](const edge_based::Segment& segment) {
      for (std::size_t i = 0; i < segment.count; ++i) sum += segment.array(edge_based::kBegin)[i];
    });
    add(edge, edge_based::Place::front);
    add(edge, edge_based::Place::back);
    edge = (edge + 1) % kEdges;
  }
  benchmark::DoNotOptimize(sum);
  microbench::report_per_item(state, "per_window", 2 * state.range(0));
}
BENCHMARK(window_lists)->Arg(1)->Arg(4)->Arg(8)->Arg(17)->Arg(64);

/// MMP: an edge's list outgrows its segment and moves to the next larger one.
void segment_pool(benchmark::State& state) {
  using Pool = SegmentPool<mmp::ListedWindow>;
  constexpr std::size_t kEdges = 4096;
  struct List {
    mmp::ListedWindow* windows;
    std::uint32_t capacity;
  };
  Pool pool;
  std::vector<List> lists(kEdges);
  for (List& list : lists) {
    list.capacity = Pool::capacity_for(1);
    list.windows = pool.take(list.capacity);
  }
  std::size_t at = 0;
  for (auto _ : state) {
    List& list = lists[at++ % kEdges];
    pool.give_back(list.windows, list.capacity);
    list.capacity = Pool::capacity_for(list.capacity < 64 ? list.capacity + 1 : 1);
    list.windows = pool.take(list.capacity);
    benchmark::DoNotOptimize(list.windows);
  }
}
BENCHMARK(segment_pool);

/// Chen-Han: in each iteration two windows leave their slots and two new ones take slots.
void window_slots(benchmark::State& state) {
  Pool<chen_han::StoredWindow<NoDepth>> pool;
  const chen_han::StoredWindow<NoDepth> window{};
  std::vector<Index> slots(20000);
  for (Index& slot : slots) slot = pool.add(window);
  std::size_t at = 0;
  for (auto _ : state) {
    Index& one = slots[at % slots.size()];
    Index& other = slots[(at + 7919) % slots.size()];
    benchmark::DoNotOptimize(pool.take(one));
    benchmark::DoNotOptimize(pool.take(other));
    one = pool.add(window);
    other = pool.add(window);
    at += 13;
  }
}
BENCHMARK(window_slots);

/// Builds the mesh of a terrain of range(0) by range(0) cells.
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
