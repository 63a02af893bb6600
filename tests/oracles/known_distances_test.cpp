// Compares the closed forms of generated meshes with brute force, which does not use the shapes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "meshes/generators/generators.h"
#include "meshes/oracles/brute_force.h"

namespace geodesic {
namespace {

struct Shape {
  const char* generator;
  GeneratorParameters parameters;
};

std::ostream& operator<<(std::ostream& out, const Shape& shape) {
  out << shape.generator;
  for (const auto& [name, value] : shape.parameters) out << " --" << name << ' ' << value.text();
  return out;
}

class KnownDistances : public ::testing::TestWithParam<Shape> {};

// Both sides compute in long double and round once to double.
constexpr double kRounding = 1e-15;

TEST_P(KnownDistances, equal_brute_force_between_all_vertices) {
  const auto& [generator, parameters] = GetParam();
  const TriangleSoup soup = generate(generator, parameters);
  const Mesh mesh(soup);
  const BruteForce judge(mesh);
  double worst = 0;
  for (Index source = 0; source < mesh.vertex_count(); ++source) {
    const auto known = known_distances(generator, parameters, soup, source);
    ASSERT_TRUE(known);
    const std::vector<double> wanted = judge.distances(std::vector<Source>{{.at = source}});
    ASSERT_EQ(known->size(), wanted.size());
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const double error = std::abs((*known)[v] - wanted[v]) / std::max(wanted[v], 1e-300);
      worst = std::max(worst, error);
      EXPECT_LE(error, kRounding) << "from vertex " << source << " to " << v << ": "
                                  << std::setprecision(17) << (*known)[v] << " instead of "
                                  << wanted[v];
    }
  }
  RecordProperty("largest_relative_error", std::to_string(worst * 1e16) + "e-16");
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, KnownDistances,
    ::testing::Values(
        Shape{"grid", {{"columns", 4}, {"rows", 3}, {"spacing", 0.3}}},
        Shape{"capped-grid", {{"columns", 3}, {"rows", 3}, {"cap", 0.3}}},
        Shape{"capped-grid", {{"columns", 3}, {"rows", 3}, {"cap", 1e-9}}},
        Shape{"capped-grid", {{"columns", 3}, {"rows", 3}, {"cap", 0}}},
        Shape{"box", {{"x-cells", 1}, {"y-cells", 1}, {"z-cells", 1}}},
        Shape{"box", {{"x-cells", 2}, {"y-cells", 2}, {"z-cells", 2}, {"spacing", 0.7}}},
        Shape{"box", {{"x-cells", 3}, {"y-cells", 2}, {"z-cells", 1}, {"spacing", 0.1}}},
        Shape{"box", {{"x-cells", 5}, {"y-cells", 2}, {"z-cells", 2}}},
        Shape{"cone", {{"sectors", 5}, {"angle", 200}, {"rings", 3}}},
        Shape{"cone", {{"sectors", 4}, {"angle", 340}, {"rings", 3}}},
        Shape{"cone", {{"sectors", 3}, {"angle", 12}, {"rings", 3}}},
        Shape{"saddle-cone", {{"sectors", 6}, {"sector-angle", 80}, {"rings", 3}}},
        Shape{"saddle-cone", {{"sectors", 4}, {"sector-angle", 91}, {"rings", 3}}},
        Shape{"cylinder", {{"sides", 3}, {"rows", 4}, {"radius", 0.7}}},
        Shape{"cylinder", {{"sides", 7}, {"rows", 3}, {"height", 0.9}}},
        Shape{"involute", {{"corners", 5}, {"angle", 350}, {"width", 1}}},
        Shape{"involute", {{"corners", 12}, {"angle", 200}}},
        Shape{"square-with-hole", {{"hole", 2}, {"rim", 1}}},
        Shape{"square-with-hole", {{"hole", 1}, {"rim", 2}}},
        Shape{"square-with-hole", {{"hole", 4}, {"rim", 1}, {"diagonal", "forward"}}}));

TEST(KnownDistances, exist_for_every_generator_that_states_a_closed_form) {
  for (const auto& description : generator_descriptions()) {
    if (description.closed_form.empty()) continue;
    const TriangleSoup soup = generate(description.name);
    const auto known = known_distances(description.name, {}, soup, 1);
    ASSERT_TRUE(known) << description.name;
    EXPECT_EQ((*known)[1], 0) << description.name;
  }
  EXPECT_FALSE(known_distances("icosphere", {}, generate("icosphere"), 0));
}

// The spider and the fly (Dudeney 1903), in a room of 30 x 12 x 12. One point lies 1 below the
// ceiling in the middle of an end wall, the other 1 above the floor in the middle of the opposite
// wall. The shortest path has length 40 and crosses five sides of the room.
TEST(KnownDistances, of_the_spider_and_the_fly_are_dudeney_s) {
  const GeneratorParameters room = {{"x-cells", 30}, {"y-cells", 12}, {"z-cells", 12}};
  const TriangleSoup soup = generate("box", room);
  const auto vertex_at = [&](const Vec3& p) {
    return static_cast<Index>(std::find(soup.positions.begin(), soup.positions.end(), p) -
                              soup.positions.begin());
  };
  const auto known = known_distances("box", room, soup, vertex_at({0, 6, 11}));
  EXPECT_EQ((*known)[vertex_at({30, 6, 1})], 40);
}

// From a corner of a 1 x 1 x 2 box the farthest point is not the opposite corner (Kotani's
// problem).
TEST(KnownDistances, find_the_antipode_of_a_corner_inside_the_far_side) {
  const GeneratorParameters box = {
      {"x-cells", 4}, {"y-cells", 4}, {"z-cells", 8}, {"spacing", 0.25}};
  const TriangleSoup soup = generate("box", box);
  const auto known = *known_distances("box", box, soup, 0);
  const auto farthest = std::max_element(known.begin(), known.end()) - known.begin();
  EXPECT_EQ(soup.positions[static_cast<std::size_t>(farthest)], (Vec3{0.75, 0.75, 2}));
  EXPECT_DOUBLE_EQ(known[static_cast<std::size_t>(farthest)], std::sqrt(0.75 * 0.75 + 2.75 * 2.75));
}

TEST(KnownDistances, are_refused_for_another_mesh_and_another_vertex) {
  TriangleSoup soup = generate("grid", {{"columns", 3}, {"rows", 3}});
  EXPECT_THROW(known_distances("grid", {{"columns", 3}, {"rows", 3}}, soup, 16),
               std::invalid_argument);
  EXPECT_THROW(known_distances("grid", {{"columns", 3}, {"rows", 4}}, soup, 0),
               std::invalid_argument);
  soup.positions[5][2] += 1e-9;
  EXPECT_THROW(known_distances("grid", {{"columns", 3}, {"rows", 3}}, soup, 0),
               std::invalid_argument);
}

}  // namespace
}  // namespace geodesic
