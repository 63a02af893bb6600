// The explanation of a failure: the first wrong vertex, its path, and the windows on the path.
#include "harness/verify/explain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/base/error.h"
#include "meshes/generators/generators.h"
#include "tests/harness/expect_words.h"

namespace geodesic::harness {
namespace {

// A room whose source is in a corner of the floor: paths to the other end cross many edges.
class Explain : public ::testing::Test {
 protected:
  Explain()
      : mesh_(given_.soup), right_(LocalReference(solver(), mesh_).distances(kQuery).values) {}

  static const Description& solver() {
    for (const Description* each : registered_solvers()) {
      if (each->final_windows && each->exactness == Exactness::exact) return *each;
    }
    throw std::runtime_error("no solver hands its windows over");
  }

  std::string explain(const std::vector<double>& got) const {
    return join(explain_violation(solver(), given_, {.what = "wrong", .query = kQuery, .got = got}),
                "\n");
  }

  std::vector<double> off_at(const std::vector<Index>& vertices) const {
    std::vector<double> got = right_;
    for (const Index v : vertices) got.at(v) *= 1 + 1e-6;
    return got;
  }

  Index farthest() const {
    return static_cast<Index>(std::ranges::max_element(right_) - right_.begin());
  }

  static inline const Query kQuery = from(0);
  const Case given_{
      "box", generate("box", {{"x-cells", 5}, {"y-cells", 2}, {"z-cells", 2}}), {kQuery}};
  const Mesh mesh_;
  const std::vector<double> right_;
};

TEST_F(Explain, names_the_wrong_vertex_both_distances_and_a_path_with_its_windows) {
  const std::string text = explain(off_at({farthest()}));
  expect_words(text, {"first wrong: vertex " + std::to_string(farthest()) + " at (",
                      "(brute force), relative error 1e-06", "the path that should have got there",
                      "from vertex 0 (source, distance 0, right) straight for", "across half-edge",
                      solver().name + ": window [", "sigma 0"});
  EXPECT_EQ(text.find("no window here"), std::string::npos) << "at every crossing there is one";
}

TEST_F(Explain, starts_with_the_nearest_of_several_wrong_vertices) {
  Index nearest = farthest();
  for (Index v = 0; v < right_.size(); ++v) {
    if (right_[v] > 1.5 && right_[v] < right_[nearest]) nearest = v;
  }
  ASSERT_NE(nearest, farthest());
  expect_words(explain(off_at({farthest(), nearest})),
               {"first wrong: vertex " + std::to_string(nearest) + " at ("});
}

TEST_F(Explain, says_so_when_the_distances_are_right) {
  expect_words(explain(right_), {"these distances equal those of brute force up to rounding"});
}

TEST_F(Explain, has_no_path_to_what_cannot_be_reached_nor_words_for_other_failures) {
  EXPECT_TRUE(explain_violation(solver(), given_, {.what = "refused"}).empty());
  Case with_point = given_;
  with_point.soup.positions.push_back({9, 9, 9});
  std::vector<double> got = right_;
  got.push_back(1);
  const auto lines =
      explain_violation(solver(), with_point, {.what = "wrong", .query = kQuery, .got = got});
  EXPECT_EQ(lines.size(), 3u);
}

}  // namespace
}  // namespace geodesic::harness
