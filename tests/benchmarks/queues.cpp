// Queues under the load of a wavefront: as many pops as pushes, with advancing keys.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "solvers/core/queues/bucket_queue.h"
#include "solvers/core/queues/calendar_queue.h"
#include "solvers/core/queues/fifo_queue.h"
#include "solvers/core/queues/vertex_heap.h"

namespace geodesic {
namespace {

constexpr double kEdge = 1;              // mean edge length of the imagined mesh
constexpr double kVertices = 50000;      // its size, which determines the bucket width
constexpr std::size_t kSteps = 1 << 16;  // random numbers, used cyclically

/// Random differences between the keys of a window and of its children, up to an edge length.
const std::vector<double>& steps_ahead() {
  static const std::vector<double> steps = [] {
    std::mt19937 random(1);
    std::vector<double> all(kSteps);
    for (double& step : all) step = kEdge * static_cast<double>(random()) / 4294967296.0;
    return all;
  }();
  return steps;
}

/// One pop and one push per iteration, with range(0) items waiting.
template <class Queue>
void pop_and_push(benchmark::State& state, Queue queue) {
  const std::vector<double>& steps = steps_ahead();
  std::vector<double> keys(static_cast<std::size_t>(state.range(0)));
  for (std::size_t i = 0; i < keys.size(); ++i) {
    keys[i] = steps[i % kSteps];
    queue.push(keys[i], static_cast<Index>(i));
  }
  std::size_t at = keys.size();
  const auto turn = [&] {
    const Index item = queue.pop();
    keys[item] += steps[at++ % kSteps];
    queue.push(keys[item], item);
  };
  for (std::size_t i = 0; i < 2 * keys.size(); ++i) turn();  // to the state of a long solve
  for (auto _ : state) turn();
}

void calendar_queue(benchmark::State& state) {
  pop_and_push(state, CalendarQueue<Index>({kEdge / std::sqrt(kVertices) / 16, 1 << 14}));
}
void bucket_queue(benchmark::State& state) {
  pop_and_push(state, BucketQueue<Index>(kEdge / std::sqrt(kVertices)));
}
void fifo_queue(benchmark::State& state) { pop_and_push(state, FifoQueue<Index>()); }

BENCHMARK(calendar_queue)->Arg(1000)->Arg(20000)->Arg(400000);
BENCHMARK(bucket_queue)->Arg(1000)->Arg(20000)->Arg(400000);
BENCHMARK(fifo_queue)->Arg(20000);

/// One pop, one push and two decreases per iteration, with range(0) vertices waiting.
void vertex_heap(benchmark::State& state) {
  const std::vector<double>& steps = steps_ahead();
  const auto waiting = static_cast<Index>(state.range(0));
  const Index vertices = 16 * waiting;
  VertexHeap heap(vertices);
  std::vector<double> keys(vertices);
  const auto reach = [&](Index v, double key) {
    keys[v] = key;
    heap.push_or_decrease(v, key);
  };
  for (Index v = 0; v < waiting; ++v) reach(v, steps[v % kSteps]);
  std::size_t at = waiting;
  Index fresh = waiting;
  for (auto _ : state) {
    const double now = heap.least_key();
    benchmark::DoNotOptimize(heap.pop());
    while (heap.contains(fresh)) fresh = (fresh + 1) % vertices;
    reach(fresh, now + steps[at++ % kSteps]);
    for (const Index back : {waiting / 3, waiting / 2}) {
      const Index v = (fresh + vertices - back) % vertices;
      if (heap.contains(v)) reach(v, now + 0.9 * (keys[v] - now));
    }
    fresh = (fresh + 1) % vertices;
  }
}
BENCHMARK(vertex_heap)->Arg(700)->Arg(5000);

}  // namespace
}  // namespace geodesic
