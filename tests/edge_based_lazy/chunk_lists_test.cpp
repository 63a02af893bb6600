// Lists keep their windows, and the order of windows, whether chunks are carried or not.
#include "solvers/variants/edge_based_lazy/chunk_lists.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace geodesic::edge_based_lazy {
namespace {

using Lists = ChunkLists<edge_based::kDepth + 1>;
using edge_based::Place;

/// A face whose apex is seen by lines straight up through 0.5 of its edge.
const FaceFrame kFace{.length = 1,
                      .apex_x = 0.5,
                      .apex_y = 0.5,
                      .left = std::sqrt(0.5),
                      .right = std::sqrt(0.5),
                      .left_x = std::sqrt(0.5),
                      .left_y = std::sqrt(0.5),
                      .right_x = std::sqrt(0.5),
                      .right_y = -std::sqrt(0.5)};

/// Narrow windows whose lines go straight up through [from, to]; sigma numbers them.
void add_windows(Lists& lists, Index h, int count, double from, double to, int first, Place place) {
  Lists::Segment* segment = lists.allocate(static_cast<std::size_t>(count));
  segment->count = static_cast<std::uint32_t>(count);
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double t = from + (to - from) * (i + 0.5) / count;
    segment->array(edge_based::kBegin)[k] = t - 1e-4;
    segment->array(edge_based::kEnd)[k] = t + 1e-4;
    segment->array(edge_based::kX)[k] = t;
    segment->array(edge_based::kY)[k] = -1e3;
    segment->array(edge_based::kSigma)[k] = first + i;
    segment->array(edge_based::kDepth)[k] = 5;
  }
  lists.add(h, segment, place);
}

struct Seen {
  std::vector<int> numbers;
  std::vector<double> begins, depths;
  std::size_t longest = 0;
};
template <class Segment>
void see(const Segment& chunk, Seen& seen) {
  for (std::size_t i = 0; i < chunk.count; ++i) {
    seen.numbers.push_back(static_cast<int>(chunk.array(edge_based::kSigma)[i]));
    seen.begins.push_back(chunk.array(edge_based::kBegin)[i]);
    seen.depths.push_back(chunk.array(edge_based::kDepth)[i]);
  }
  seen.longest = std::max<std::size_t>(seen.longest, chunk.count);
}
Seen consumed(Lists& lists, Index h) {
  Seen seen;
  lists.consume(h, [&](const auto& chunk) { see(chunk, seen); });
  return seen;
}
std::vector<int> numbers(int from, int to) {
  std::vector<int> all;
  for (int i = from; i < to; ++i) all.push_back(i);
  return all;
}

TEST(ChunkLists, keep_the_order_of_batches_put_at_both_ends) {
  Lists lists(4);
  add_windows(lists, 1, 20, 0.4, 0.6, 20, Place::back);
  add_windows(lists, 1, 20, 0.0, 0.4, 0, Place::front);
  add_windows(lists, 1, 3, 0.6, 1.0, 40, Place::back);
  EXPECT_EQ(lists.size(), 43u);
  const Seen seen = consumed(lists, 1);
  EXPECT_EQ(seen.numbers, numbers(0, 43));
  EXPECT_EQ(seen.longest, 7u) << "20 windows are three chunks";
  EXPECT_TRUE(lists.empty(1));
  EXPECT_EQ(lists.size(), 0u);
}

TEST(ChunkLists, carry_what_passes_the_apex_on_one_side) {
  Lists lists(4);
  add_windows(lists, 0, 64, 0, 1, 0, Place::back);  // eight chunks, none of which sees the apex
  add_windows(lists, 1, 72, 0, 1, 0, Place::back);  // nine, the middle one does
  for (const Index h : {0u, 1u}) {
    lists.carry(h, kFace);
    const int middle = h == 0 ? 0 : 8, carried = 32;
    EXPECT_EQ(consumed(lists, h).numbers, numbers(carried, carried + middle));
    std::size_t set_apart = 0;
    lists.for_each_carried([&](const auto& chunk, std::uint32_t faces) {
      set_apart += chunk.count;
      EXPECT_EQ(faces, 1u);
    });
    EXPECT_EQ(set_apart, 64u);
    lists.land_carried(2, 3);
    Seen sampled;
    lists.for_each_segment(2, [&](const auto& chunk) { see(chunk, sampled); });
    const Seen left = consumed(lists, 2), right = consumed(lists, 3);
    EXPECT_EQ(left.numbers, numbers(0, carried));
    EXPECT_EQ(right.numbers, numbers(carried + middle, 64 + middle));
    EXPECT_EQ(sampled.begins, left.begins) << "looking moved windows, or did not";
    EXPECT_EQ(left.depths, std::vector<double>(32, 6));
    // Straight up onto an edge at 45 degrees.
    const double first_line = 0.5 / (h == 0 ? 64 : 72) - 1e-4;
    EXPECT_NEAR(left.begins.front(), std::sqrt(2) * first_line, 1e-6);
    EXPECT_EQ(lists.size(), h == 0 ? 72u : 0u);
  }
}

TEST(ChunkLists, keep_chunks_on_the_wrong_side_of_one_that_stays) {
  Lists lists(4);
  add_windows(lists, 0, 8, 0.4, 0.6, 0, Place::back);  // sees the apex
  add_windows(lists, 0, 8, 0.1, 0.3, 8, Place::back);  // goes left, but lies to its right
  lists.carry(0, kFace);
  EXPECT_EQ(consumed(lists, 0).numbers, numbers(0, 16));
}

TEST(ChunkLists, drop_what_is_carried_over_the_boundary) {
  Lists lists(4);
  add_windows(lists, 0, 64, 0, 1, 0, Place::back);
  lists.carry(0, kFace);
  lists.land_carried(kNone, 2);
  EXPECT_EQ(lists.size(), 32u);
  EXPECT_EQ(consumed(lists, 2).numbers, numbers(32, 64));
}

}  // namespace
}  // namespace geodesic::edge_based_lazy
