#include "solvers/core/queues/bucket_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "meshes/random.h"

namespace geodesic {
namespace {

std::vector<double> random_keys(std::size_t count) {
  Random random(3);
  std::vector<double> keys;
  for (std::size_t i = 0; i < count; ++i) keys.push_back(random.below(100000) / 1000.0);
  return keys;
}

/// A queue whose first phase, at key 0, is over. Before that, pushed items may be sorted by key.
BucketQueue<int> running(double width) {
  BucketQueue<int> queue(width);
  queue.push(0, -1);
  queue.pop();
  return queue;
}

TEST(BucketQueue, pops_in_order_of_buckets_first_in_first_out_inside) {
  const std::vector<double> keys = random_keys(2000);
  BucketQueue<int> queue = running(0.5);
  for (std::size_t i = 0; i < keys.size(); ++i) queue.push(keys[i], static_cast<int>(i));
  std::vector<int> want(keys.size());
  std::iota(want.begin(), want.end(), 0);
  std::ranges::stable_sort(want, {}, [&](int i) { return std::floor(keys[std::size_t(i)] / 0.5); });
  std::vector<int> got;
  while (!queue.empty()) got.push_back(queue.pop());
  EXPECT_EQ(got, want);
}

TEST(BucketQueue, an_item_born_during_a_phase_waits_for_the_next) {
  BucketQueue<int> queue(1);
  for (int i = 0; i < 20; ++i) queue.push(5.5, i);
  EXPECT_EQ(queue.pop(), 0);
  queue.push(5.1, 100);
  for (int i = 1; i < 20; ++i) EXPECT_EQ(queue.pop(), i);
  EXPECT_EQ(queue.pop(), 100);
  EXPECT_TRUE(queue.empty());
}

TEST(BucketQueue, a_width_that_is_negative_or_not_a_number_is_refused) {
  for (const double width : {-1.0, -1e-300, std::nan("")}) {
    EXPECT_THROW(BucketQueue<int>{width}, std::invalid_argument) << width;
  }
}

TEST(BucketQueue, a_mesh_without_vertices_has_one_bucket) {
  const double width = published_bucket_width(Mesh{TriangleSoup{}});
  EXPECT_EQ(width, 0);
  EXPECT_TRUE(BucketQueue<int>(width).empty());
}

// The wavefront grows: each item gives two, behind all that wait.
TEST(BucketQueue, a_phase_stays_short_however_many_items_wait) {
  BucketQueue<int> queue(1);
  double farthest = 0;
  queue.push(farthest, 0);
  const auto grow = [&] {
    for (int k = 0; k < 2; ++k) queue.push(farthest += 0.125, 0);
    return queue.pop();
  };
  while (queue.size() < 20'000) grow();
  queue.push(0, 1);  // the next phase begins with it
  int waited = 0;
  while (grow() == 0) ++waited;
  EXPECT_LE(waited, 1000 + 8);  // the bound of K, and the rest of a bucket
}

TEST(BucketQueue, what_the_phase_covers_is_due) {
  BucketQueue<int> queue(1);
  for (int i = 0; i < 20; ++i) queue.push(5.5, i);
  queue.push(7.5, 20);
  queue.pop();  // starts a phase that covers all items, up to key 8
  EXPECT_TRUE(queue.is_due(7.9));
  EXPECT_FALSE(queue.is_due(8.1));
}

// Keys as in a wavefront: pushed items are not nearer than the last popped item.
TEST(BucketQueue, knows_a_key_below_all_to_come) {
  Random random(1);
  BucketQueue<double> queue(0.1);
  queue.push(1, 1);
  double bound = queue.least_key();
  for (int i = 0; i < 3000; ++i) {
    const double key = queue.pop();
    ASSERT_LE(bound, key);
    ASSERT_GE(queue.least_key(), bound);
    bound = queue.least_key();
    for (int k = 0; k < 2; ++k) {
      const double ahead = key + random.below(100) / 40.0;
      queue.push(ahead, ahead);
    }
  }
  EXPECT_GT(bound, 1);
}

TEST(BucketQueue, shows_the_items_of_a_phase_before_their_turn) {
  BucketQueue<int> queue(1);
  for (int i = 0; i < 20; ++i) queue.push(5.5, i);
  queue.pop();
  ASSERT_NE(queue.upcoming(), nullptr);
  const int distance = *queue.upcoming();
  EXPECT_GT(distance, 0);
  for (int i = 1; i < 20; ++i) {
    EXPECT_EQ(queue.pop(), i);
    const int* item = queue.upcoming();
    if (i + distance < 20) {
      ASSERT_NE(item, nullptr);
      EXPECT_EQ(*item, i + distance);
    } else {
      EXPECT_EQ(item, nullptr);
    }
  }
}

// A propagation as in solvers: each item produces items with larger keys.
std::vector<int> propagate(BucketQueue<int>& queue, double unit) {
  Random random(4);
  std::vector<double> key = {0};
  std::vector<int> order;
  queue.push(0, 0);
  while (!queue.empty()) {
    const int at = queue.pop();
    order.push_back(at);
    for (int child = 0; child < 2 && key.size() < 3000; ++child) {
      key.push_back(key[static_cast<std::size_t>(at)] + unit * (random.below(1000)) / 256.0);
      queue.push(key.back(), static_cast<int>(key.size()) - 1);
    }
  }
  return order;
}

TEST(BucketQueue, gives_every_item_back_once) {
  BucketQueue<int> queue(0.125);
  std::vector<int> order = propagate(queue, 1);
  std::ranges::sort(order);
  std::vector<int> all(order.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(order, all);
  EXPECT_EQ(order.size(), 3000u);
}

TEST(BucketQueue, does_not_depend_on_the_unit_of_the_keys) {
  BucketQueue<int> queue(0.125), other(0.125 * 1024);
  EXPECT_EQ(propagate(queue, 1), propagate(other, 1024));
}

TEST(BucketQueue, is_as_new_when_cleared) {
  BucketQueue<int> fresh(0.125), used(0.125);
  propagate(used, 3);
  used.push(17, 1);
  used.clear();
  EXPECT_TRUE(used.empty());
  EXPECT_EQ(used.size(), 0u);
  EXPECT_EQ(propagate(used, 1), propagate(fresh, 1));
}

TEST(BucketQueue, takes_keys_of_any_range) {
  BucketQueue<int> queue(1e-6);
  const std::vector<double> keys = {1e12, 0, 1e6, 1e300, 3e-6};
  for (std::size_t i = 0; i < keys.size(); ++i) queue.push(keys[i], static_cast<int>(i));
  EXPECT_EQ(queue.size(), 5u);
  for (const int want : {1, 4, 2, 0, 3}) EXPECT_EQ(queue.pop(), want);
}

TEST(BucketQueue, without_a_width_is_first_in_first_out) {
  BucketQueue<int> queue = running(0);
  for (const int i : {5, 1, 4}) queue.push(i, i);
  for (const int want : {5, 1, 4}) EXPECT_EQ(queue.pop(), want);
}

}  // namespace
}  // namespace geodesic
