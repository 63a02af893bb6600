#include "solvers/chen_han/filter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geodesic::chen_han {
namespace {

// The unit edge, entered from a face whose third vertex lies below its middle.
PassedFace unit_face(double at_origin, double at_head, double at_third) {
  return {.third_x = 0.5, .third_y = -1, .at_third = at_third, .ends = {1, at_origin, at_head}};
}

bool is_useless(const Window& w, Entry entry, const PassedFace& face) {
  return XinWangFilter::is_useless(w, entry, face);
}

TEST(ChenHanFilter, KeepsAWindowWhenNothingIsKnownOfTheVertices) {
  const Window w{0.2, 0.4, 0.5, -1, 0};
  EXPECT_FALSE(is_useless(w, Entry::at_origin, unit_face(kInfinity, kInfinity, kInfinity)));
}

TEST(ChenHanFilter, KeepsTheWindowsOfItsOwnGeneratingVertex) {
  for (const double sigma : {0.0, 3.0}) {
    const double side = sigma + std::hypot(0.5, 1.0);
    const Window w{0, 1, 0.5, -1, sigma};
    EXPECT_FALSE(is_useless(w, Entry::at_origin, unit_face(side, side, sigma)));
    EXPECT_FALSE(is_useless(w, Entry::at_head, unit_face(side, side, sigma)));
  }
}

TEST(ChenHanFilter, KeepsAWindowThatTiesWithAPathThroughAVertexInLine) {
  // Source, origin of the edge and window lie on one line: all paths are equally long.
  const Window w{0.25, 0.75, -2, 0, 0};
  EXPECT_FALSE(is_useless(w, Entry::at_origin, unit_face(2, kInfinity, kInfinity)));
}

TEST(ChenHanFilter, DropsAWindowBeatenThroughTheOrigin) {
  const Window w{0.2, 0.4, 0.5, -2, 1};
  const double at_end = distance_at(w, w.end);
  EXPECT_TRUE(is_useless(w, Entry::at_origin, unit_face(at_end - 0.4 - 1e-9, 9, 9)));
  EXPECT_FALSE(is_useless(w, Entry::at_origin, unit_face(at_end - 0.4 + 1e-9, 9, 9)));
}

TEST(ChenHanFilter, DropsAWindowBeatenThroughTheHead) {
  const Window w{0.2, 0.4, 0.5, -2, 1};
  const double at_begin = distance_at(w, w.begin);
  EXPECT_TRUE(is_useless(w, Entry::at_origin, unit_face(9, at_begin - 0.8 - 1e-9, 9)));
  EXPECT_FALSE(is_useless(w, Entry::at_origin, unit_face(9, at_begin - 0.8 + 1e-9, 9)));
}

TEST(ChenHanFilter, TheThirdVertexIsComparedAtTheFarEnd) {
  const Window w{0.1, 0.4, 0, -3, 0};
  const double at_begin = distance_at(w, w.begin) - std::hypot(0.4, 1.0);
  const double at_end = distance_at(w, w.end) - std::hypot(0.1, 1.0);
  ASSERT_LT(at_begin, at_end);
  const PassedFace between = unit_face(9, 9, 0.5 * (at_begin + at_end));
  EXPECT_FALSE(is_useless(w, Entry::at_origin, between)) << "begin is the far end";
  EXPECT_TRUE(is_useless(w, Entry::at_head, between)) << "end is the far end";
}

TEST(ChenHanFilter, DoesNotDependOnTheUnitOfLength) {
  for (const double unit : {1.0, 0x1p-40, 0x1p40}) {
    const Window w{0.2 * unit, 0.4 * unit, 0.5 * unit, -2 * unit, unit};
    const auto face = [&](double at_origin) {
      return PassedFace{.third_x = 0.5 * unit,
                        .third_y = -unit,
                        .at_third = 9 * unit,
                        .ends = {unit, at_origin * unit, 9 * unit}};
    };
    EXPECT_TRUE(is_useless(w, Entry::at_origin, face(2.6))) << unit;
    EXPECT_FALSE(is_useless(w, Entry::at_origin, face(2.7))) << unit;
  }
}

}  // namespace
}  // namespace geodesic::chen_han
