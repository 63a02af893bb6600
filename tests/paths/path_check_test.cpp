// The check of paths finds each kind of error in a path.
#include "harness/verify/path_check.h"

#include <gtest/gtest.h>

#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "tests/paths/oracle_paths.h"

namespace geodesic::harness {
namespace {

class PathCheck : public testing::Test {
 protected:
  std::string wrong_with(const Path& path) const {
    Finding finding = check_path(mesh_, query_, end_, distance_, path);
    if (!finding) finding = check_straight(mesh_, path);
    return finding ? finding->what.substr(0, finding->what.find(" at its point")) : "";
  }

  const Mesh mesh_{rough_terrain(4, 8, 8, 0.5)};
  const Query query_{.sources = {{.at = 0}, {.at = 4}}};
  const Paths paths_ = oracle_paths(mesh_, query_);
  const Index end_ = 79;
  const double distance_ = paths_.distances()[end_];
  const Path right_ = paths_.to_vertex(end_);
  const std::size_t middle_ = right_.points.size() / 2;
};

TEST_F(PathCheck, accepts_a_path) {
  ASSERT_GT(right_.points.size(), 6u);
  ASSERT_FALSE(right_.points[middle_].at.is_vertex());
  EXPECT_EQ(wrong_with(right_), "");
}

TEST_F(PathCheck, finds_wrong_ends) {
  Path path = right_;
  path.source ^= 1;
  EXPECT_EQ(wrong_with(path), "the path does not begin in its source");
  path.source = 2;
  EXPECT_EQ(wrong_with(path), "the path comes from no source of the query");
  path = right_;
  path.points.pop_back();
  EXPECT_EQ(wrong_with(path), "the path does not end in its end");
  path.points.clear();
  EXPECT_EQ(wrong_with(path), "the path has no points");
}

TEST_F(PathCheck, finds_points_that_are_elsewhere_or_off_the_surface) {
  Path path = right_;
  path.points[middle_].position[2] += 1e-9;
  EXPECT_EQ(wrong_with(path), "the path is elsewhere");
  path = right_;
  path.points[middle_].face = path.points.front().face;
  EXPECT_EQ(wrong_with(path), "the path leaves its face");
  path = right_;
  path.points.erase(path.points.begin() + static_cast<std::ptrdiff_t>(middle_));
  EXPECT_EQ(wrong_with(path), "the path leaves its face");
  path.points[middle_].face = kNone;
  EXPECT_NE(wrong_with(path), "");
}

TEST_F(PathCheck, finds_wrong_lengths) {
  Path path = right_;
  path.points[middle_].travelled *= 1 + 1e-9;
  EXPECT_EQ(wrong_with(path), "the path is not as long as it says");
  const Finding finding = check_path(mesh_, query_, end_, distance_ * (1 + 1e-11), right_);
  ASSERT_TRUE(finding.has_value());
  EXPECT_NE(finding->what.find("relative error -1e-11"), std::string::npos) << finding->what;
}

TEST_F(PathCheck, finds_a_line_that_is_not_straight) {
  Path path = right_;
  SurfacePoint& at = path.points[middle_].at;
  const Index h = edge_under(in_internal_numbers(mesh_, at));
  at.weights[h % 3] += 1e-9;
  at.weights[Mesh::next(h) % 3] -= 1e-9;
  const Finding finding = check_straight(mesh_, path);
  ASSERT_TRUE(finding.has_value());
  EXPECT_EQ(finding->what.rfind("the path is not straight: it leaves its line by ", 0), 0u);
}

// A path along two sides of a square instead of its diagonal, and a path straight over a vertex.
TEST(PathCheckOfAngles, finds_a_bend_that_a_shorter_path_cuts) {
  const Mesh mesh(generate("grid", {{"columns", 2}, {"rows", 2}, {"diagonal", "forward"}}));
  const auto along = [&](const std::vector<Index>& vertices) {
    Path path{0, {}};
    for (const Index v : vertices) {
      path.points.push_back({.at = v, .position = mesh.position(v)});
    }
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      for (const Index h : mesh.outgoing(vertices[i])) {
        const bool there = mesh.head(h) == vertices[i + 1] || mesh.apex(h) == vertices[i + 1];
        if (there) path.points[i].face = h / 3;
      }
    }
    const Finding finding = check_straight(mesh, path);
    return finding ? finding->what : "";
  };
  EXPECT_EQ(along({3, 4, 5}), "");
  EXPECT_EQ(along({0, 4, 8}), "");
  EXPECT_EQ(along({0, 1, 2}), "");
  const std::string right_angle = "the path has an angle of 1.5708 on one side at its point 1";
  EXPECT_EQ(along({3, 4, 7}), right_angle);
  EXPECT_EQ(along({1, 4, 3}), right_angle);
  EXPECT_EQ(along({1, 0, 3}), right_angle);
}

}  // namespace
}  // namespace geodesic::harness
