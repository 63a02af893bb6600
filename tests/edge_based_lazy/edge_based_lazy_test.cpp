// Chunks of windows that cross faces as a whole lie where unfolding them face by face puts them,
// and lists keep their order. What the solver promises besides, the conformance properties check.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "meshes/random.h"
#include "solvers/variants/edge_based_lazy/chunk_lists.h"

namespace geodesic::edge_based_lazy {
namespace {

FaceFrame face(double length, double apex_x, double apex_y) {
  const double left = std::hypot(apex_x, apex_y), right = std::hypot(length - apex_x, apex_y);
  return {.length = length,
          .apex_x = apex_x,
          .apex_y = apex_y,
          .left = left,
          .right = right,
          .left_x = apex_x / left,
          .left_y = apex_y / left,
          .right_x = (length - apex_x) / right,
          .right_y = -apex_y / right};
}

/// A chunk without a list.
struct Chunk {
  explicit Chunk(const std::vector<Window>& windows) : count(windows.size()) {
    for (std::size_t i = 0; i < count; ++i) {
      fields[edge_based::kBegin][i] = windows[i].begin;
      fields[edge_based::kEnd][i] = windows[i].end;
      fields[edge_based::kX][i] = windows[i].x;
      fields[edge_based::kY][i] = windows[i].y;
    }
  }
  double* array(unsigned field) { return fields[field].data(); }
  const double* array(unsigned field) const { return fields[field].data(); }

  std::size_t count;
  std::array<std::array<double, 8>, 5> fields{};
};

/// Where the lines of a window pass the apex.
Side side_of(const Window& w, const FaceFrame& f) {
  if (apex_side(w, w.end, f) > 0) return Side::left;
  return apex_side(w, w.begin, f) < 0 ? Side::right : Side::both;
}

Window unfolded(const Window& w, const FaceFrame& f, Side side) {
  if (side == Side::left) {
    const Point2 source = f.to_left(w.x, w.y);
    return {f.on_left(w, w.begin), f.on_left(w, w.end), source.x, source.y, w.sigma};
  }
  const Point2 source = f.to_right(w.x, w.y);
  return {f.on_right(w, w.begin), f.on_right(w, w.end), source.x, source.y, w.sigma};
}

TEST(Passage, puts_windows_where_unfolding_face_by_face_does) {
  Random random(7);
  int crossings = 0, refused = 0;
  for (int strip = 0; strip < 2000; ++strip) {
    std::vector<Window> windows;
    const double x = random.between(-1, 2), depth = random.between(0.5, 4.5);
    for (double begin = 0.3; begin < 0.6; begin += 0.05) {
      const double end = begin + random.between(0, 0.05);
      windows.push_back({begin, end, x + random.between(0, 0.1), -depth, 0});
    }
    Chunk chunk(windows);
    Passage passage(chunk);
    double length = 1;
    for (int k = 0; k < 40; ++k) {
      const FaceFrame f =
          face(length, random.between(-0.5, 1.5) * length, random.between(0.2, 1.2));
      const Side side = side_of(windows.front(), f);
      bool together = side != Side::both;
      for (const Window& w : windows) together &= side_of(w, f) == side;
      if (!together) {
        EXPECT_FALSE(passage.carry(f, Side::left) || passage.carry(f, Side::right));
        break;
      }
      EXPECT_FALSE(passage.carry(f, side == Side::left ? Side::right : Side::left));
      if (!passage.carry(f, side)) {
        ++refused;
        break;
      }
      ++crossings;
      for (Window& w : windows) w = unfolded(w, f, side);
      length = side == Side::left ? f.left : f.right;
    }
    if (passage.faces() > 0) passage.arrive(chunk);
    for (std::size_t i = 0; i < windows.size(); ++i) {
      // A line that meets the edge at a small angle moves along it.
      const double near = 1e-11 * (length + std::hypot(windows[i].x, windows[i].y));
      EXPECT_NEAR(chunk.array(edge_based::kBegin)[i], windows[i].begin, near) << passage.faces();
      EXPECT_NEAR(chunk.array(edge_based::kEnd)[i], windows[i].end, near) << passage.faces();
      EXPECT_NEAR(chunk.array(edge_based::kX)[i], windows[i].x, 1e-3 * near);
      EXPECT_NEAR(chunk.array(edge_based::kY)[i], windows[i].y, 1e-3 * near);
    }
  }
  EXPECT_GT(crossings, 2000);
  EXPECT_LT(refused, crossings / 5) << "the bounds leave room for nothing";
}

TEST(Passage, takes_no_line_whose_direction_is_uncertain) {
  for (const double depth : {0.0, 1e-12, 1e-5}) {
    EXPECT_FALSE(Passage(Chunk({{0.2, 0.4, 0.3, -depth, 0}})).carry(face(1, 5, 1), Side::left));
  }
  EXPECT_TRUE(Passage(Chunk({{0.2, 0.4, 0.3, -1, 0}})).carry(face(1, 5, 1), Side::left));
}

TEST(Passage, ends_after_the_most_faces) {
  Passage passage(Chunk({{0.4, 0.41, 0.4, -1e6, 0}}));
  // A strip of rectangles, each cut along its diagonal: the lines pass the end of the diagonal on
  // the left and then the corner at its other side on the right.
  const double height = 1e-3, diagonal = std::hypot(1, height);
  const FaceFrame below = face(1, 1, height);
  const FaceFrame above = face(diagonal, height * height / diagonal, height / diagonal);
  std::uint32_t faces = 0;
  while (faces < 2 * kMostFaces) {
    if (!(faces % 2 == 0 ? passage.carry(below, Side::left) : passage.carry(above, Side::right))) {
      break;
    }
    ++faces;
  }
  EXPECT_EQ(faces, kMostFaces);
}

using Lists = ChunkLists<edge_based::Note::depth>;
using edge_based::Place;

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
    lists.carry(h, face(1, 0.5, 0.5));
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

TEST(ChunkLists, drop_what_is_carried_over_the_boundary) {
  Lists lists(4);
  add_windows(lists, 0, 64, 0, 1, 0, Place::back);
  lists.carry(0, face(1, 0.5, 0.5));
  lists.land_carried(kNone, 2);
  EXPECT_EQ(lists.size(), 32u);
  EXPECT_EQ(consumed(lists, 2).numbers, numbers(32, 64));
}

}  // namespace
}  // namespace geodesic::edge_based_lazy
