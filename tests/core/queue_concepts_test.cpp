// Propagation calls no member of a queue that its concept does not name. A policy makes the queue.
#include "solvers/core/queues/concepts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "meshes/oracles/random_meshes.h"
#include "solvers/chen_han/recorded.h"
#include "solvers/core/queues/vertex_heap.h"
#include "solvers/edge_based/recorded.h"
#include "solvers/mmp/recorded.h"

namespace geodesic {
namespace {

/// Has the members of WindowQueue only.
class MinimalWindowQueue {
 public:
  bool empty() const { return items_.empty(); }
  void clear() { items_.clear(); }
  void push(double key, Index item) { items_.emplace_back(key, item); }
  Index pop() {
    const auto least = std::ranges::min_element(items_);
    const Index item = least->second;
    items_.erase(least);
    return item;
  }

 protected:
  std::vector<std::pair<double, Index>> items_;
};
static_assert(WindowQueue<MinimalWindowQueue> && !WindowQueueByKey<MinimalWindowQueue>);

/// Has the members of WindowQueueByKey only.
class MinimalWindowQueueByKey : public MinimalWindowQueue {
 public:
  bool is_due(double key) const { return key <= least_key(); }
  double least_key() const { return empty() ? kInfinity : std::ranges::min_element(items_)->first; }
};
static_assert(WindowQueueByKey<MinimalWindowQueueByKey>);

/// Has the members of VertexQueue only.
class MinimalVertexQueue {
 public:
  bool empty() const { return queue_.empty(); }
  double least_key() const { return queue_.least_key(); }
  double first_key() { return queue_.least_key(); }
  void clear() { *this = {}; }
  void push_or_decrease(Index v, double key) {
    keys_.resize(std::max<std::size_t>(keys_.size(), v + std::size_t{1}), kInfinity);
    if (key < keys_[v]) queue_.push(keys_[v] = key, v);
  }
  Index pop() { return queue_.pop(); }

 private:
  MinimalWindowQueueByKey queue_;  // may hold a vertex twice
  std::vector<double> keys_;
};
static_assert(VertexQueue<MinimalVertexQueue>);
static_assert(!VertexQueue<VertexHeap>, "it lacks first_key");

struct Minimal {
  using Filter = chen_han::XinWangFilter;
  using Queue = MinimalWindowQueue;
  static Queue make_queue(const Mesh&) { return {}; }
};

struct MinimalByKey {
  using Queue = MinimalWindowQueueByKey;
  static Queue make_queue(const Mesh&) { return {}; }
};

}  // namespace

// All members are compiled, also those that `run` does not call. Of the edge-based wavefront, some
// compile with one recorder only: the other one that touches the queue is named.
template double
edge_based::Wavefront<edge_based::ListCrossing, MinimalVertexQueue, CountingRecorder>::first_key();
template class mmp::Propagation<MinimalByKey, CountingRecorder>;
template class mmp::WindowsOfEdges<MinimalWindowQueueByKey, CountingRecorder>;
template class chen_han::Propagation<Minimal, StripDepth, CountingRecorder>;

namespace {

/// @param propagation takes a CountingRecorder
template <class MakePropagation>
std::vector<double> distances_of(const Mesh& mesh, const MakePropagation& propagation) {
  Recording recording;
  std::vector<double> distances(mesh.vertex_count(), kInfinity);
  propagation(CountingRecorder(recording))
      .run(Start(mesh, in_internal_numbers(mesh, {.sources = {{0}, {7, 0.5}}})), distances);
  return distances;
}

void expect_the_same(const std::vector<double>& found, const std::vector<double>& expected) {
  for (std::size_t v = 0; v < expected.size(); ++v) {
    ASSERT_NEAR(found[v], expected[v], 1e-12 * expected[v]) << "vertex " << v;
  }
}

class QueueConcepts : public testing::Test {
 protected:
  const Mesh mesh_{rough_terrain(1, 9, 9, 1)};
};

TEST_F(QueueConcepts, name_all_that_edge_based_calls) {
  const auto solve = [&](auto queue) {
    return distances_of(mesh_, [&](CountingRecorder recorder) {
      using namespace edge_based;
      return Wavefront<ListCrossing, decltype(queue), CountingRecorder>(
          mesh_, queue,
          ListCrossing(mesh_, InstructionSet::plain, Carried::depth, coordinate_rounding(mesh_),
                       WindowBudget(mesh_)),
          recorder);
    });
  };
  expect_the_same(solve(MinimalVertexQueue()), solve(edge_based::ByDistance::make_queue(mesh_)));
}

template <template <class> class Propagation, class Policy>
std::vector<double> windows_by(const Mesh& mesh) {
  return distances_of(mesh, [&](CountingRecorder recorder) {
    return Propagation<Policy>(mesh, Policy::make_queue(mesh), recorder);
  });
}
template <class Policy>
using Mmp = mmp::Propagation<Policy, CountingRecorder>;
template <class Policy>
using ChenHan = chen_han::Propagation<Policy, StripDepth, CountingRecorder>;

TEST_F(QueueConcepts, name_all_that_mmp_calls) {
  expect_the_same(windows_by<Mmp, MinimalByKey>(mesh_), windows_by<Mmp, mmp::ByDistance>(mesh_));
}

TEST_F(QueueConcepts, name_all_that_chen_han_calls) {
  expect_the_same(windows_by<ChenHan, Minimal>(mesh_), windows_by<ChenHan, chen_han::Ich>(mesh_));
}

/// A policy whose queue has a parameter. It keeps the value that it read last.
template <class Base>
struct WithWidth : Base {
  static inline double width = 0;
  static typename Base::Queue make_queue(const Mesh& mesh, const Description& description) {
    width = description.real("width");
    return Base::make_queue(mesh);
  }
};

template <template <class> class Family, class Base>
void expect_that_queues_have_the_parameter(const Mesh& mesh) {
  using Policy = WithWidth<Base>;
  const Description description{.name = "variant",
                                .family = "",
                                .paper = "",
                                .parameters = {real_parameter("width", 2, 1, 4, "of a bucket")},
                                .values = {{"width", 3}}};
  Family<Policy> solver(mesh, description);
  EXPECT_EQ(std::exchange(Policy::width, 0), 3) << "timed";
  Recording recording;
  std::vector<double> distances(mesh.vertex_count());
  solver.solve({.sources = {{0}}}, distances, &recording);
  EXPECT_EQ(Policy::width, 3) << "recorded";
}

TEST(Policy, may_read_parameters_of_its_solver_for_its_queue_in_timed_and_recorded_solves) {
  const Mesh mesh{rough_terrain(1, 5, 5, 1)};
  expect_that_queues_have_the_parameter<mmp::Mmp, mmp::ByDistance>(mesh);
  expect_that_queues_have_the_parameter<chen_han::ChenHan, chen_han::Ich>(mesh);
  expect_that_queues_have_the_parameter<edge_based::EdgeBased, edge_based::ByDistance>(mesh);
}

}  // namespace
}  // namespace geodesic
