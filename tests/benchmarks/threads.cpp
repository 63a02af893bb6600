// Predicts the time of a solve by regions on more threads than the machine has.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "meshes/generators/generators.h"
#include "solvers/core/registry.h"
#include "solvers/edge_based/parallel/regional_wavefront.h"

namespace geodesic {
namespace {

/// Time of a step on `threads` threads. Each thread takes the next turn as soon as it is free, and
/// long turns come first.
double time_of_step(std::vector<double> turns, std::size_t threads) {
  std::ranges::sort(turns, std::ranges::greater{});
  std::vector<double> busy(threads);
  for (const double turn : turns) *std::ranges::min_element(busy) += turn;
  return *std::ranges::max_element(busy);
}

/// Solves on a terrain of range(0) by range(0) cells. The turns of one thread are measured and then
/// distributed to more threads, which wait for each other after each step. Contention (caches,
/// memory) is not included: the counters are bounds, relative to the time of the serial solver.
void predicted_threads(benchmark::State& state) {
  const ParameterValue cells = state.range(0);
  const Mesh mesh(generate("terrain", {{"columns", cells}, {"rows", cells}}),
                  Numbering::along_surface);
  const Query query{.sources = {{.at = 0}}};
  std::vector<double> distances(mesh.vertex_count());
  const auto serial = make_solver("edge-based", mesh);
  edge_based::RegionalWavefront regional(mesh, widest_instruction_set(), 1,
                                         edge_based::usual_region_size(mesh));
  const auto seconds = [](const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  constexpr std::size_t kMostThreads = 64;
  std::vector<double> times(kMostThreads + 1);
  double serial_time = 0;
  for (auto _ : state) {
    serial_time += seconds([&] { serial->solve(query, distances); });
    edge_based::RegionalWavefront::TurnTimes turns;
    regional.run(Start(mesh, in_internal_numbers(mesh, query)), distances, &turns);
    for (std::size_t threads = 1; threads <= kMostThreads; threads *= 2) {
      for (const auto& step : turns) times[threads] += time_of_step(step, threads);
    }
  }
  for (std::size_t threads = 1; threads <= kMostThreads; threads *= 2) {
    state.counters["threads_" + std::to_string(threads)] = times[threads] / serial_time;
  }
}
BENCHMARK(predicted_threads)->Arg(100)->Arg(315)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace geodesic
