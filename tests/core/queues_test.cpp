#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "solvers/core/queues/calendar_queue.h"
#include "solvers/core/queues/concepts.h"
#include "solvers/core/queues/fifo_queue.h"

#include "meshes/random.h"

namespace geodesic {
namespace {

template <class Queue>
std::vector<int> drain(Queue& queue) {
  std::vector<int> items;
  while (!queue.empty()) items.push_back(queue.pop());
  return items;
}

// Widths from "all items in one bucket" to "most items beyond the ring".
TEST(CalendarQueue, equals_a_stable_sort_whatever_the_width_while_items_come_and_go) {
  for (const double width : {0.0, 1e9, 3.0, 0.1, 1e-3, 1e-300}) {
    Random random(1);
    CalendarQueue<int> queue({width, 16});
    std::vector<std::pair<double, int>> model;  // key, item: kept in order
    for (int i = 0; i < 5000; ++i) {
      if (random.below(3) != 0 || model.empty()) {
        const double key = random.below(50) * (random.below(10) == 0 ? 1000.0 : 1.0);
        queue.push(key, i);
        model.insert(std::upper_bound(model.begin(), model.end(), std::pair(key, i)), {key, i});
      } else {
        ASSERT_EQ(queue.pop(), model.front().second) << "width " << width;
        model.erase(model.begin());
      }
      ASSERT_EQ(queue.size(), model.size());
    }
  }
}

TEST(CalendarQueue, an_item_is_due_when_no_other_has_a_smaller_key) {
  for (const double width : {0.0, 1e9, 3.0, 0.1}) {
    CalendarQueue<int> queue({width, 16});
    for (const double key : {1.0, 2.0, 4.0}) queue.push(key, 0);
    queue.pop();
    EXPECT_TRUE(queue.is_due(1)) << "width " << width;
    EXPECT_FALSE(queue.is_due(3)) << "width " << width;
  }
}

// Keys as in a wavefront: pushed items are not nearer than the last popped item.
TEST(CalendarQueue, knows_a_key_below_all_to_come_and_less_than_a_bucket_behind) {
  for (const double width : {3.0, 0.1}) {
    Random random(1);
    CalendarQueue<double> queue({width, 16});
    queue.push(1, 1);
    for (int i = 0; i < 3000 && !queue.empty(); ++i) {
      const double bound = queue.least_key();
      const double key = queue.pop();
      ASSERT_LE(bound, key);
      ASSERT_GT(queue.least_key(), key - 1.001 * width);  // rounding
      for (int k = 0; k < 2; ++k) {
        const double ahead = key + random.below(100) / 40.0;
        queue.push(ahead, ahead);
      }
    }
  }
}

TEST(CalendarQueue, shows_items_before_their_turn_each_once) {
  CalendarQueue<int> queue({1, 128});
  for (int i = 0; i < 400; ++i) queue.push(i / 4.0, i);
  std::vector<int> shown;
  for (int popped = 0; popped < 400; ++popped) {
    ASSERT_EQ(queue.pop(), popped);
    if (const int* item = queue.upcoming()) {
      EXPECT_GT(*item, popped);
      shown.push_back(*item);
    }
  }
  EXPECT_GT(shown.size(), 350u);
  std::sort(shown.begin(), shown.end());
  EXPECT_EQ(std::adjacent_find(shown.begin(), shown.end()), shown.end());
}

TEST(CalendarQueue, is_as_new_when_cleared) {
  CalendarQueue<int> queue({1e-3, 16});
  queue.push(1, 1);
  queue.push(1e6, 2);
  queue.clear();
  EXPECT_TRUE(queue.empty());
  for (int i = 0; i < 3; ++i) queue.push(7, i);
  EXPECT_EQ(drain(queue), (std::vector{0, 1, 2}));
}

TEST(FifoQueue, pops_in_order_of_insertion_whatever_the_keys) {
  FifoQueue<int> queue;
  for (const int i : {5, 1, 4, 2, 3}) queue.push(i, i);
  EXPECT_EQ(queue.size(), 5u);
  EXPECT_EQ(drain(queue), (std::vector{5, 1, 4, 2, 3}));
}

// A queue of a user, with only the functions that the concept requires.
struct Lifo {
  std::vector<Index> items;
  bool empty() const { return items.empty(); }
  void clear() { items.clear(); }
  void push(double /*key*/, Index item) { items.push_back(item); }
  Index pop() {
    const Index last = items.back();
    items.pop_back();
    return last;
  }
};

TEST(WindowQueue, may_leave_out_upcoming) {
  static_assert(WindowQueue<Lifo> && WindowQueue<FifoQueue<Index>>);
  static_assert(WindowQueueByKey<CalendarQueue<Index>> && !WindowQueueByKey<Lifo>);
  Lifo lifo;
  for (Index i = 0; i < 9; ++i) lifo.push(0, i);
  EXPECT_EQ(upcoming(lifo), kNone);
}

}  // namespace
}  // namespace geodesic
