#include "solvers/core/queues/vertex_calendar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "meshes/random.h"

namespace geodesic {
namespace {

std::vector<Index> drain(VertexCalendar& calendar) {
  std::vector<Index> vertices;
  while (!calendar.empty()) vertices.push_back(calendar.pop());
  return vertices;
}

TEST(VertexCalendar, pops_bucket_by_bucket_and_in_order_of_arrival_inside_of_one) {
  VertexCalendar calendar(10, 1.0);
  for (const Index v : {7u, 3u, 9u, 1u}) calendar.push_or_decrease(v, v < 5 ? 2.5 : 1.5);
  EXPECT_EQ(drain(calendar), (std::vector<Index>{7, 9, 3, 1}));
}

TEST(VertexCalendar, a_key_behind_what_was_popped_is_next) {
  VertexCalendar calendar(3, 1.0);
  calendar.push_or_decrease(0, 5);
  calendar.push_or_decrease(1, 6);
  EXPECT_EQ(calendar.pop(), 0u);
  calendar.push_or_decrease(2, 0);
  EXPECT_EQ(drain(calendar), (std::vector<Index>{2, 1}));
}

TEST(VertexCalendar, keys_that_share_a_slot_wait_for_their_lap) {
  VertexCalendar calendar(4, 1.0);
  calendar.push_or_decrease(0, 128 * 128 + 0.5);
  calendar.push_or_decrease(1, 1e300);
  calendar.push_or_decrease(2, 128.5);
  calendar.push_or_decrease(3, 0.5);
  EXPECT_EQ(drain(calendar), (std::vector<Index>{3, 2, 0, 1}));
}

TEST(VertexCalendar, a_vertex_that_was_popped_waits_again_once) {
  VertexCalendar calendar(2, 1.0);
  calendar.push_or_decrease(0, 200.5);
  calendar.push_or_decrease(0, 3.5);
  calendar.push_or_decrease(1, 300.5);
  EXPECT_EQ(calendar.pop(), 0u);
  calendar.push_or_decrease(0, 2.5);
  EXPECT_EQ(drain(calendar), (std::vector<Index>{0, 1}));
}

TEST(VertexCalendar, without_a_width_is_first_in_first_out) {
  VertexCalendar calendar(3, 0.0);
  for (const Index v : {2u, 0u, 1u}) calendar.push_or_decrease(v, 9.0 - v);
  EXPECT_EQ(calendar.least_key(), 0);
  EXPECT_EQ(drain(calendar), (std::vector<Index>{2, 0, 1}));
}

TEST(VertexCalendar, is_as_new_when_cleared) {
  VertexCalendar calendar(3, 1.0);
  calendar.push_or_decrease(1, 1000);
  calendar.push_or_decrease(2, 1001);
  calendar.pop();
  calendar.clear();
  EXPECT_TRUE(calendar.empty());
  EXPECT_EQ(calendar.least_key(), 0);
  calendar.push_or_decrease(0, 7);
  calendar.push_or_decrease(2, 5);
  EXPECT_EQ(drain(calendar), (std::vector<Index>{2, 0}));
}

TEST(VertexCalendar, differs_from_a_search_for_the_least_by_a_bucket_at_most_while_keys_decrease) {
  for (const double width : {1e9, 7.0, 0.3, 1e-3}) {
    Random random(2);
    VertexCalendar calendar(200, width);
    for (int round = 0; round < 200; ++round) {
      std::map<Index, double> waiting, keys;  // keys: of all vertices that had one
      double last = 0;                        // the greatest key popped
      for (int i = 0; i < 200 || !waiting.empty(); ++i) {
        if (i < 200 && (random.below(3) != 0 || waiting.empty())) {
          const Index v = random.below(200);
          const double key = last + random.below(100);
          const auto [at, added] = keys.try_emplace(v, key);
          if (!added && !(key < at->second)) continue;
          calendar.push_or_decrease(v, key);
          at->second = waiting[v] = key;
        } else {
          const double least = std::ranges::min_element(waiting, {}, [](const auto& entry) {
                                 return entry.second;
                               })->second;
          ASSERT_LE(calendar.least_key(), least);
          ASSERT_LE(calendar.first_key(), least);
          ASSERT_GE(calendar.first_key(), least - width * (1 + 1e-9));
          const auto popped = waiting.find(calendar.pop());
          ASSERT_NE(popped, waiting.end());
          ASSERT_LE(popped->second, least + width) << "width " << width;
          ASSERT_GE(calendar.least_key(), popped->second - width * (1 + 1e-9));
          last = std::max(last, popped->second);
          waiting.erase(popped);
        }
        ASSERT_EQ(calendar.empty(), waiting.empty());
      }
      calendar.clear();
    }
  }
}

TEST(VertexCalendar, announces_the_next_vertex_of_a_bucket) {
  VertexCalendar calendar(4, 1.0);
  calendar.push_or_decrease(0, 0.5);
  calendar.push_or_decrease(1, 0.25);
  calendar.push_or_decrease(2, 7.0);
  EXPECT_EQ(calendar.pop(), 0u);
  EXPECT_EQ(calendar.upcoming(), 1u);
  EXPECT_EQ(calendar.pop(), 1u);
  EXPECT_EQ(calendar.upcoming(), kNone);
  EXPECT_EQ(calendar.pop(), 2u);
}

}  // namespace
}  // namespace geodesic
