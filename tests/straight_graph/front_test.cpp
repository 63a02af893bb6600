// The order in which vertices leave the front.
#include "solvers/straight_graph/front.h"

#include <gtest/gtest.h>

#include <vector>

namespace geodesic::straight_graph {
namespace {

using Buckets = std::vector<std::vector<Index>>;

Buckets take_all(Front& front) {
  Buckets buckets;
  while (front.advance()) buckets.push_back(front.bucket());
  return buckets;
}

TEST(Front, hands_out_vertices_bucket_by_bucket) {
  Front front(2);
  for (const auto& [v, distance] : {std::pair<Index, double>{7, 4.5}, {8, 0}, {9, 5.9}}) {
    front.push(v, front.bucket_of(distance));
  }
  EXPECT_EQ(take_all(front), (Buckets{{8}, {7, 9}}));
}

TEST(Front, grows_the_current_bucket_while_it_is_read) {
  Front front(1);
  front.push(1, 0);
  ASSERT_TRUE(front.advance());
  front.push(2, 0);
  EXPECT_EQ(front.bucket(), (std::vector<Index>{1, 2}));
  EXPECT_FALSE(front.advance());
}

// An initial distance may be any number of edges long.
TEST(Front, skips_any_number_of_empty_buckets_at_once) {
  Front front(1);
  front.push(1, front.bucket_of(1e300));
  front.push(2, front.bucket_of(1e15 + 300));
  front.push(3, front.bucket_of(1e15));
  front.push(4, 5);
  EXPECT_EQ(take_all(front), (Buckets{{4}, {3}, {2}, {1}}));
}

TEST(Front, has_one_bucket_without_a_width) {
  Front front(0);
  front.push(1, front.bucket_of(1e300));
  front.push(2, front.bucket_of(0));
  EXPECT_EQ(take_all(front), (Buckets{{1, 2}}));
}

TEST(Front, begins_anew_when_it_is_cleared) {
  Front front(1);
  for (const std::int64_t bucket : {3, 4, 1000}) front.push(1, bucket);
  ASSERT_TRUE(front.advance());
  front.clear();
  EXPECT_FALSE(front.advance());
  front.push(5, 0);
  EXPECT_EQ(take_all(front), (Buckets{{5}}));
}

}  // namespace
}  // namespace geodesic::straight_graph
