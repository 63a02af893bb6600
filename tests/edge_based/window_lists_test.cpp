#include "solvers/edge_based/window_lists.h"

#include <gtest/gtest.h>

#include <vector>

namespace geodesic::edge_based {
namespace {

TEST(WindowLists, use_all_blocks_again_those_of_long_segments_too) {
  WindowLists lists(1, fields_with(Carried::nothing));
  const auto solve = [&] {
    std::vector<Segment*> segments;
    for (const std::size_t windows : {3u, 1000u, 600u, 400u, 400u, 9000u, 700u}) {
      segments.push_back(lists.allocate(windows));
    }
    lists.clear();
    return segments;
  };
  const std::vector<Segment*> first = solve();
  EXPECT_EQ(solve(), first);
  EXPECT_EQ(solve(), first);
}

}  // namespace
}  // namespace geodesic::edge_based
