// The steps of edge-based propagation over one list of windows, for every instruction set.
#include "solvers/edge_based/kernels.h"

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "tests/benchmarks/microbench.h"

namespace geodesic::edge_based {
namespace {

/// A batch of `range(0)` windows, the face that it crosses and memory for the results.
struct Crossing {
  Crossing(const benchmark::State& state, InstructionSet set)
      : kernels(kernels_of(set, Carried::nothing)) {
    const auto count = static_cast<std::size_t>(state.range(0));
    segment = lists.allocate(count);
    for (const Window& w : microbench::windows_in_order(count)) segment->add(w);
    to_left = lists.allocate(count);
    to_right = lists.allocate(count);
    gather();
  }

  void gather() {
    batch.count = 0;
    kernels.gather(*segment, EndpointBounds(face.length, 2.2, 2.2), batch);  // removes no window
  }

  const Kernels& kernels;
  const FaceFrame face = microbench::crossed_face_frame();
  WindowLists lists{1, fields_with(Carried::nothing)};
  Batch batch{fields_with(Carried::nothing), kernels.lanes};
  Segment *segment, *to_left, *to_right;
};

void add(const std::string& name, InstructionSet set, void (*step)(Crossing&)) {
  const auto time_step = [=](benchmark::State& state) {
    Crossing crossing(state, set);
    for (auto _ : state) {
      step(crossing);
      benchmark::DoNotOptimize(crossing.batch.count);
      benchmark::ClobberMemory();
    }
    microbench::report_per_item(state, "per_window", state.range(0));
  };
  auto* benchmark = benchmark::RegisterBenchmark(name.c_str(), time_step);
  for (const int windows : {1, 4, 8, 17, 64}) benchmark->Arg(windows);
}

void add(const std::string& path, InstructionSet set) {
  add("gather/" + path, set, [](Crossing& c) { c.gather(); });
  add("trim/" + path, set, [](Crossing& c) { c.kernels.trim(c.batch, {1, 0.5, -0.8}); });
  add("unfold/" + path, set,
      [](Crossing& c) { c.kernels.unfold(c.batch, c.face, *c.to_left, *c.to_right); });
}

/// Two overlapping windows whose sources are not in order: one trims the other.
void trim_overlapping_pair(benchmark::State& state) {
  const EdgeBelow edge{1, 0.5, -0.8};
  const Window near{0.1, 0.7, 0.4, -1, 0}, far{0.4, 0.9, 0.2, -1.2, 0.3};
  for (auto _ : state) {
    Window first = near, second = far;
    benchmark::DoNotOptimize(first);
    trim_pair(first, second, edge);
    benchmark::DoNotOptimize(first);
    benchmark::DoNotOptimize(second);
  }
}
BENCHMARK(trim_overlapping_pair);

const bool added = [] {
  for (const InstructionSet set : kInstructionSets) {
    if (compiled_for(set) == set && why_unavailable(set).empty()) {
      add(std::string(name_of(set)), set);
    }
  }
  return true;
}();

}  // namespace
}  // namespace geodesic::edge_based
