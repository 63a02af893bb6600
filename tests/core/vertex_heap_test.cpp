#include "solvers/core/queues/vertex_heap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "meshes/random.h"

namespace geodesic {
namespace {

std::vector<Index> drain(VertexHeap& heap) {
  std::vector<Index> vertices;
  while (!heap.empty()) vertices.push_back(heap.pop());
  return vertices;
}

TEST(VertexHeap, pops_in_order_of_keys_and_the_smaller_id_among_equals) {
  VertexHeap heap(10);
  for (const Index v : {7u, 3u, 9u, 1u}) heap.push_or_decrease(v, v < 5 ? 2.0 : 1.0);
  EXPECT_EQ(drain(heap), (std::vector<Index>{7, 9, 1, 3}));
}

TEST(VertexHeap, a_smaller_key_moves_a_vertex_forward_and_a_larger_one_does_not_move_it) {
  VertexHeap heap(4);
  heap.push_or_decrease(0, 1);
  heap.push_or_decrease(1, 2);
  heap.push_or_decrease(2, 3);
  heap.push_or_decrease(2, 0.5);
  heap.push_or_decrease(0, 9);
  EXPECT_EQ(heap.least_key(), 0.5);
  EXPECT_EQ(drain(heap), (std::vector<Index>{2, 0, 1}));
}

TEST(VertexHeap, knows_what_it_contains) {
  VertexHeap heap(3);
  heap.push_or_decrease(1, 1);
  EXPECT_TRUE(heap.contains(1));
  EXPECT_FALSE(heap.contains(2));
  heap.pop();
  EXPECT_FALSE(heap.contains(1));
}

TEST(VertexHeap, is_as_new_when_cleared) {
  VertexHeap heap(3);
  heap.push_or_decrease(1, 1);
  heap.clear();
  EXPECT_TRUE(heap.empty());
  EXPECT_FALSE(heap.contains(1));
  heap.push_or_decrease(1, 5);
  EXPECT_EQ(heap.least_key(), 5);
}

TEST(VertexHeap, equals_a_search_for_the_least_while_keys_decrease) {
  Random random(2);
  VertexHeap heap(200);
  std::map<Index, double> model;
  for (int i = 0; i < 20000; ++i) {
    if (random.below(3) != 0 || model.empty()) {
      const Index v = random.below(200);
      const double key = random.below(100);
      heap.push_or_decrease(v, key);
      const auto [at, added] = model.try_emplace(v, key);
      if (!added) at->second = std::min(at->second, key);
    } else {
      const auto least = std::ranges::min_element(model, [](const auto& a, const auto& b) {
        return std::pair(a.second, a.first) < std::pair(b.second, b.first);
      });
      ASSERT_EQ(heap.least_key(), least->second);
      ASSERT_EQ(heap.pop(), least->first);
      model.erase(least);
    }
  }
}

}  // namespace
}  // namespace geodesic
