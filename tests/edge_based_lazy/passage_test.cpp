// Windows carried across a strip of faces lie where unfolding them face by face puts them.
#include "solvers/variants/edge_based_lazy/passage.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "meshes/random.h"

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

TEST(Passage, of_one_source_is_refused_only_where_the_apex_is_seen_or_nearly) {
  const Chunk chunk({{0.25, 0.5, 0.25, -1, 0}, {0.5, 0.75, 0.25, -1, 0}});
  const double left = 0.25, right = 0.25 + 2 * (0.75 - 0.25);  // bounds at height 1
  const auto carries = [&](double apex_x, Side side) {
    return Passage(chunk).carry(face(1, apex_x, 1), side);
  };
  for (const double off : {1e-6, 0.1}) {
    EXPECT_TRUE(carries(left - off, Side::right)) << off;
    EXPECT_TRUE(carries(right + off, Side::left)) << off;
  }
  for (const Side side : {Side::left, Side::right}) {
    EXPECT_FALSE(carries(left - 1e-11, side));
    EXPECT_FALSE(carries(0.8, side));
    EXPECT_FALSE(carries(right + 1e-11, side));
  }
}

TEST(Passage, takes_no_line_whose_direction_is_uncertain) {
  for (const double depth : {0.0, 1e-12, 1e-5}) {
    EXPECT_FALSE(Passage(Chunk({{0.2, 0.4, 0.3, -depth, 0}})).carry(face(1, 5, 1), Side::left));
  }
  EXPECT_TRUE(Passage(Chunk({{0.2, 0.4, 0.3, -1, 0}})).carry(face(1, 5, 1), Side::left));
}

TEST(Passage, takes_no_face_that_its_lines_leave_at_a_small_angle) {
  const Chunk upright({{0.4, 0.5, 0.45, -10, 0}});
  EXPECT_TRUE(Passage(upright).carry(face(1, 1.5, 1), Side::left));
  EXPECT_FALSE(Passage(upright).carry(face(1, 0.6, 1e5), Side::left));
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

}  // namespace
}  // namespace geodesic::edge_based_lazy
