#include "solvers/core/face_windows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "solvers/core/mesh.h"

namespace geodesic {
namespace {

/// One face, whose half-edge 0 has the length 3, below the point (1, 1).
class FaceWindowsOfOneFace : public testing::Test {
 protected:
  static constexpr Index kSources = 70'000;

  FaceWindowsOfOneFace() : distances_(3, 100.0), last_segments_(3) {
    for (Index i = 0; i < kSources; ++i) {
      query_.sources.push_back({InternalPoint(0), 1 + 1e-5 * i});
    }
    point_.face = 0;
    point_.weights = {5.0 / 12, 4.0 / 12, 3.0 / 12};  // (1, 1) in the triangle (0, 0) (3, 0) (0, 4)
  }

  AtTarget nearest(FaceWindows& windows) const {
    windows.finish(query_, distances_, last_segments_);
    return windows.nearest(point_);
  }
  static void add(FaceWindows& windows, const Window& w, Index root) {
    windows.add(0, [&](const auto& add_one) { add_one(w, root); });
  }

  Mesh mesh_{TriangleSoup{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}}};
  InternalQuery query_;
  std::vector<double> distances_;
  std::vector<LastSegment> last_segments_;
  InternalPoint point_;
};

TEST_F(FaceWindowsOfOneFace, have_the_roots_that_they_were_given_and_these_roots_final_distances) {
  for (const Index source : {Index{0}, Index{12'345}, Index{65'533}, Index{65'536}, kSources - 1}) {
    FaceWindows windows(mesh_);
    add(windows, {0, 3, 1, -2, /*sigma, which has become less=*/1e9}, 3 + source);
    const AtTarget at = nearest(windows);
    EXPECT_EQ(at.last_segment, (LastSegment{0, 3 + source, {1, -2}}));
    EXPECT_DOUBLE_EQ(at.distance, 4 + 1e-5 * source);
  }
}

TEST_F(FaceWindowsOfOneFace, are_passed_only_between_their_ends) {
  // The line from (1, -2) to (1, 1) passes the edge at 1.
  for (const auto& [begin, end, passes] :
       {std::tuple(0.0, 0.999, false), {0.0, 1.0, true}, {1.0, 3.0, true}, {1.001, 3.0, false}}) {
    FaceWindows windows(mesh_);
    add(windows, {begin, end, 1, -2, 0}, 3);
    EXPECT_EQ(nearest(windows).distance == 4, passes) << begin << " " << end;
  }
}

TEST_F(FaceWindowsOfOneFace, are_all_asked_however_many_were_added_in_whatever_portions) {
  constexpr Index kWindows = 3000;
  for (const Index portion : {1u, 7u, 1000u}) {
    FaceWindows windows(mesh_);
    for (Index begin = 0; begin < kWindows; begin += portion) {
      windows.add(0, [&](const auto& add_one) {
        for (Index i = begin; i < std::min(begin + portion, kWindows); ++i) {
          add_one({0, 3, 1, -2, 0}, 3 + kWindows - 1 - i);
        }
      });
    }
    EXPECT_EQ(windows.window_count(), kWindows);
    EXPECT_EQ(nearest(windows).distance, 4) << "of the window that was added last";
  }
}

}  // namespace
}  // namespace geodesic
