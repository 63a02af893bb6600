#include "solvers/core/pool.h"

#include <gtest/gtest.h>

#include <vector>

namespace geodesic {
namespace {

TEST(Pool, gives_the_slot_released_last_to_the_next_item) {
  Pool<double> pool;
  for (const double item : {1.0, 2.0, 3.0}) pool.add(item);
  pool.release(0);
  EXPECT_EQ(pool.take(2), 3);
  EXPECT_EQ(pool.add(4), 2u);
  EXPECT_EQ(pool.add(5), 0u);
  EXPECT_EQ(pool.add(6), 3u);
  const double items[] = {5, 2, 4, 6};
  for (Index slot = 0; slot < 4; ++slot) EXPECT_EQ(pool[slot], items[slot]);
}

TEST(Pool, shows_the_items_that_are_not_released) {
  Pool<Index> pool;
  for (Index item = 0; item < 10; ++item) pool.add(item);
  for (const Index slot : {0u, 9u, 4u}) pool.release(slot);
  std::vector<Index> items;
  pool.for_each([&](Index item) { items.push_back(item); });
  EXPECT_EQ(items, (std::vector<Index>{1, 2, 3, 5, 6, 7, 8}));
  pool.clear();
  pool.for_each([&](Index) { FAIL() << "an item after clear"; });
  EXPECT_EQ(pool.add(7), 0u);
}

TEST(SegmentPool, has_two_capacities_to_a_doubling) {
  std::vector<std::uint32_t> capacities;
  for (std::uint32_t items = 1; items <= 24; ++items) {
    const std::uint32_t capacity = SegmentPool<int>::capacity_for(items);
    EXPECT_GE(capacity, items);
    if (capacities.empty() || capacities.back() != capacity) capacities.push_back(capacity);
  }
  EXPECT_EQ(capacities, (std::vector<std::uint32_t>{4, 6, 8, 12, 16, 24}));
}

TEST(SegmentPool, hands_out_segments_that_do_not_overlap_and_uses_them_again) {
  SegmentPool<int> pool;
  std::vector<int*> segments;
  for (int i = 0; i < 5000; ++i) {
    segments.push_back(pool.take(24));
    std::fill_n(segments.back(), 24, i);
  }
  for (int i = 0; i < 5000; ++i) {
    for (int k = 0; k < 24; ++k) ASSERT_EQ(segments[static_cast<std::size_t>(i)][k], i);
  }
  pool.give_back(segments[17], 24);
  EXPECT_EQ(pool.take(20 + 4), segments[17]);
}

}  // namespace
}  // namespace geodesic
