#include "solvers/core/queues/vertex_heap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "meshes/random.h"

namespace geodesic {
namespace {

TEST(VertexHeap, is_as_new_when_cleared) {
  VertexHeap heap(3);
  heap.push_or_decrease(1, 1);
  heap.clear();
  EXPECT_TRUE(heap.empty());
  EXPECT_FALSE(heap.contains(1));
  heap.push_or_decrease(1, 5);
  EXPECT_EQ(heap.least_key(), 5);
}

// Among equal keys, the smaller vertex number comes first. Larger keys change nothing.
TEST(VertexHeap, equals_a_search_for_the_least_while_keys_decrease) {
  Random random(2);
  VertexHeap heap(200);
  std::map<Index, double> model;
  for (int i = 0; i < 20000; ++i) {
    if (random.below(3) != 0 || model.empty()) {
      const Index v = random.below(200);
      const double key = random.below(100);
      ASSERT_EQ(heap.contains(v), model.contains(v));
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
    ASSERT_EQ(heap.empty(), model.empty());
  }
}

}  // namespace
}  // namespace geodesic
