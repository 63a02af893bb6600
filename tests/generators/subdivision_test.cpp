// Subdivision: counts, topology, and what each scheme promises about the surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "meshes/defects.h"
#include "tests/generators/generator_test.h"
#include "tests/harness/expect_error.h"

namespace geodesic {
namespace {

/// Three faces at one edge, which are separated, and an isolated vertex, which is dropped.
const TriangleSoup kBook = {
    .positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {5, 5, 5}},
    .triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}};

TriangleSoup transformed(TriangleSoup soup) {
  for (auto& [x, y, z] : soup.positions) {
    const Vec3 p = {x, y, z};
    x = 2 * p[0] - p[1] + 0.5 * p[2] + 3;
    y = p[0] + 1.5 * p[1] - 1;
    z = -0.25 * p[0] + p[1] + 2 * p[2] + 7;
  }
  return soup;
}

/// Compares the topology without isolated vertices, which are dropped.
void expect_same_topology(const TriangleSoup& made, const TriangleSoup& of) {
  const MeshSummary before = summarize(of), after = summarize(made);
  EXPECT_EQ(after.genus, before.genus);
  EXPECT_EQ(after.boundary_loops, before.boundary_loops);
  EXPECT_EQ(after.components, before.components);
  EXPECT_EQ(after.isolated_vertices, 0u);
  EXPECT_FALSE(find_defects(made).has_errors());
}

class Subdivision : public InputFiles, public ::testing::WithParamInterface<const char*> {
 protected:
  TriangleSoup subdivided(const TriangleSoup& soup) {
    return made("subdivide", soup, {{"steps", GetParam()}});
  }
};

TEST_P(Subdivision, HasTheCountsOfItsScheme) {
  const bool barycentric = std::string(GetParam()) == "barycentric";
  for (const TriangleSoup& soup : {generate("holed-plate"), generate("icosphere"), kBook}) {
    const std::size_t edges = summarize(soup).edges;
    const std::size_t vertices = soup.triangles == kBook.triangles ? 9 : soup.positions.size();
    const TriangleSoup result = subdivided(soup);
    EXPECT_EQ(result.positions.size(),
              vertices + edges + (barycentric ? soup.triangles.size() : 0));
    EXPECT_EQ(result.triangles.size(), soup.triangles.size() * (barycentric ? 6 : 4));
  }
}

TEST_P(Subdivision, KeepsTheTopology) {
  for (const char* const generator : {"holed-plate", "icosphere", "torus", "two-components"}) {
    SCOPED_TRACE(generator);
    const TriangleSoup soup = generate(generator);
    expect_same_topology(subdivided(soup), soup);
  }
}

TEST_P(Subdivision, KeepsAFlatSurfaceFlatWithItsAreaAndOrientation) {
  const TriangleSoup result = subdivided(generate("grid", {{"columns", 5}, {"rows", 4}}));
  for (const Vec3& position : result.positions) EXPECT_EQ(position[2], 0);
  // The boundary curve of Loop's scheme rounds the corners of the rectangle.
  if (std::string(GetParam()) != "loop") {
    EXPECT_NEAR(area_of(result), 20, 1e-13);
  }
  for (const auto& [a, b, c] : result.triangles) {
    const Vec3 &p = result.positions[a], &q = result.positions[b], &r = result.positions[c];
    EXPECT_GT((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]), 0);
  }
}

TEST_P(Subdivision, CommutesWithAffineMaps) {
  for (const TriangleSoup& soup : {generate("holed-plate", {{"bulge", 0.3}}), kBook}) {
    const TriangleSoup one = transformed(subdivided(soup)), other = subdivided(transformed(soup));
    ASSERT_EQ(one.triangles, other.triangles);
    for (std::size_t v = 0; v < one.positions.size(); ++v) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(one.positions[v][axis], other.positions[v][axis], 1e-14) << v;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, Subdivision, ::testing::Values("midpoint", "loop", "barycentric"),
                         [](const auto& scheme) { return std::string(scheme.param); });

class Derived : public InputFiles {};

TEST_F(Derived, MidpointAndBarycentricKeepTheSurfacesAreaAndOldVertices) {
  const TriangleSoup soup = generate("torus-knot", {{"rings", 60}, {"sides", 9}});
  for (const auto& [steps, factor] :
       {std::pair("midpoint", 4u), {"barycentric", 6u}, {"midpoint,barycentric", 24u}}) {
    const TriangleSoup result = made("subdivide", soup, {{"steps", steps}});
    EXPECT_EQ(result.triangles.size(), factor * soup.triangles.size()) << steps;
    EXPECT_NEAR(area_of(result), area_of(soup), 1e-12 * area_of(soup)) << steps;
    EXPECT_TRUE(std::equal(soup.positions.begin(), soup.positions.end(), result.positions.begin()))
        << steps;
  }
}

TEST_F(Derived, SheetsThatMeetInAnEdgeAreSeparatedAndARemarkSaysSo) {
  const GeneratorParameters vertices = {{"vertices", 9}};
  for (const auto& [generator, parameters] : {std::pair("subdivide", GeneratorParameters{}),
                                              {"refine", vertices},
                                              {"decimate", vertices}}) {
    const TriangleSoup result = made(generator, kBook, parameters);
    EXPECT_EQ(summarize(result).components, 3u) << generator;
    const std::string separated =
        "copies made of vertices at which separate sheets of the surface met: 4";
    EXPECT_EQ(remarks_, std::vector{separated}) << generator;
  }
}

// Loop 1987: an inner vertex of six neighbours gets 10/16 of itself and 1/16 of each.
TEST_F(Derived, LoopGivesTheWeightsOfThePaper) {
  TriangleSoup soup = generate("grid", {{"columns", 2}, {"rows", 2}, {"diagonal", "forward"}});
  soup.positions[4][2] = 16;  // the middle one, of valence 6
  const TriangleSoup result = made("subdivide", soup, {{"steps", "loop"}});
  EXPECT_NEAR(result.positions[4][2], 10, 1e-14);
  std::vector<double> heights;
  for (std::size_t v = 9; v < result.positions.size(); ++v) {
    heights.push_back(result.positions[v][2]);
  }
  EXPECT_EQ(std::count(heights.begin(), heights.end(), 6), 6) << "3/8 on the edges of the middle";
  EXPECT_EQ(std::count(heights.begin(), heights.end(), 2), 2) << "1/8 opposite to it";
  EXPECT_EQ(std::count(heights.begin(), heights.end(), 0), 8) << "nothing on the boundary";
}

/// The largest sine of half the angle between the normals of adjacent faces.
double greatest_bend(const TriangleSoup& soup) {
  std::map<std::pair<Index, Index>, Vec3> normals;
  double greatest = 0;
  for (const Triangle& face : soup.triangles) {
    const Vec3& corner = soup.positions[face[0]];
    const Vec3 across =
        cross(subtract(soup.positions[face[1]], corner), subtract(soup.positions[face[2]], corner));
    const Vec3 normal = scale(1 / norm(across), across);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = face[k], b = face[(k + 1) % 3];
      normals[{a, b}] = normal;
      const auto beyond = normals.find({b, a});
      if (beyond != normals.end()) {
        greatest = std::max(greatest, norm(subtract(normal, beyond->second)) / 2);
      }
    }
  }
  return greatest;
}

TEST_F(Derived, LoopTendsToASmoothSurface) {
  TriangleSoup soup = generate("box", {{"x-cells", 2}, {"y-cells", 2}, {"z-cells", 2}});
  double bend = greatest_bend(soup);
  EXPECT_NEAR(bend, std::sqrt(0.5), 1e-15) << "right angles";
  for (int step = 1; step <= 5; ++step) {
    soup = made("subdivide", soup, {{"steps", "loop"}});
    EXPECT_LT(greatest_bend(soup), 0.85 * bend) << step;
    bend = greatest_bend(soup);
  }
  EXPECT_LT(bend, 0.05);
}

TEST_F(Derived, NoiseMovesWithinItsAmplitudeAlongNormalsOnly) {
  const TriangleSoup soup = generate("grid", {{"columns", 20}, {"rows", 20}, {"spacing", 2}});
  const TriangleSoup result = made("noise", soup, {{"amplitude", 0.25}, {"seed", 5}});
  EXPECT_EQ(result.triangles, soup.triangles);
  const double mean_edge = (840 + 400 * std::sqrt(2.0)) / 1240 * 2;
  double farthest = 0;
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    EXPECT_EQ(result.positions[v][0], soup.positions[v][0]);
    EXPECT_EQ(result.positions[v][1], soup.positions[v][1]);
    farthest = std::max(farthest, std::abs(result.positions[v][2]));
  }
  EXPECT_LE(farthest, 0.25 * mean_edge);
  EXPECT_GT(farthest, 0.24 * mean_edge) << "of 441 uniform numbers";
}

TEST_F(Derived, NoiseDependsOnItsSeedAndIsNothingWithoutAmplitude) {
  const TriangleSoup soup = generate("two-components");
  EXPECT_NE(hash_of(made("noise", soup, {{"seed", 1}})),
            hash_of(made("noise", soup, {{"seed", 2}})));
  expect_same(made("noise", soup, {{"amplitude", 0}}), soup);
}

double greatest_edge(const TriangleSoup& soup) { return summarize(soup).edge_lengths->greatest; }

TEST_F(Derived, RefineHasExactlyTheVerticesAskedAndTheSameSurface) {
  const TriangleSoup soup = generate("holed-plate", {{"bulge", 0.3}});
  for (const std::size_t vertices : {2068u, 2069u, 3001u, 10000u}) {
    const TriangleSoup result = made("refine", soup, {{"vertices", vertices}});
    EXPECT_EQ(result.positions.size(), vertices);
    expect_same_topology(result, soup);
    EXPECT_LE(greatest_edge(result), greatest_edge(soup));
    EXPECT_NEAR(area_of(result), area_of(soup), 1e-13 * area_of(soup));
  }
}

TEST_F(Derived, RefineSplitsTheLongestEdgeFirst) {
  // A triangle of sides 3, 4, 5: the longest is halved, then the side of 4.
  const TriangleSoup triangle = {.positions = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}},
                                 .triangles = {{0, 1, 2}}};
  const TriangleSoup result = made("refine", triangle, {{"vertices", 5}});
  EXPECT_EQ(result.positions[3], (Vec3{2, 1.5, 0}));
  EXPECT_EQ(result.positions[4], (Vec3{2, 0, 0}));
  EXPECT_EQ(result.triangles.size(), 3u);
}

TEST_F(Derived, RefineBringsEdgesToOneLength) {
  const TriangleSoup needles = generate("needles");
  EXPECT_LT(greatest_edge(made("refine", needles, {{"vertices", 60000}})),
            0.2 * greatest_edge(needles));
}

TEST_F(Derived, RefineRefusesFewerVerticesThanThereAre) {
  const std::string message = message_of<std::invalid_argument>([&] {
    made("refine", generate("two-components"), {{"vertices", 1387}});
  });
  EXPECT_NE(message.find("has 1388 without the isolated ones"), std::string::npos) << message;
}

TEST_F(Derived, DecimateHasExactlyTheVerticesAskedAndTheSameTopology) {
  const TriangleSoup soup = generate("torus-knot", {{"rings", 200}, {"sides", 12}});
  for (const std::size_t vertices : {2400u, 2399u, 1000u, 300u}) {
    const TriangleSoup result = made("decimate", soup, {{"vertices", vertices}});
    EXPECT_EQ(result.positions.size(), vertices);
    expect_same_topology(result, soup);
    EXPECT_NEAR(area_of(result), area_of(soup), 0.1 * area_of(soup));
  }
}

TEST_F(Derived, DecimateRefusesNumbersOfVerticesThatItCannotReach) {
  for (const auto& [vertices, expected] :
       {std::pair(4u, "cannot have fewer"), {2049u, "has 2048"}}) {
    const std::string message = message_of<std::invalid_argument>([this, wanted = vertices] {
      made("decimate", generate("torus"), {{"vertices", wanted}});
    });
    EXPECT_NE(message.find(expected), std::string::npos) << message;
  }
}

TEST_F(Derived, HasTheCommittedBits) {
  const TriangleSoup soup = generate("holed-plate", {{"bulge", 0.3}, {"holes", 2}, {"pitch", 6}});
  const auto expect_hash = [&](const char* generator, const GeneratorParameters& parameters,
                               std::uint64_t expected) {
    const std::uint64_t hash = hash_of(made(generator, soup, parameters));
    EXPECT_EQ(hash, expected) << generator << std::hex << " 0x" << hash;
  };
  expect_hash("subdivide", {{"steps", "midpoint"}}, 0x7c59f793da237dfu);
  expect_hash("subdivide", {{"steps", "loop,loop"}}, 0xfe905923e182c00du);
  expect_hash("subdivide", {{"steps", "barycentric"}}, 0x8a38c027ec618869u);
  expect_hash("refine", {{"vertices", 1000}}, 0xaf71c0dbc06b4785u);
  expect_hash("decimate", {{"vertices", 100}}, 0xaaa4a83a9b28f97cu);
  expect_hash("noise", {}, 0xe8b1979cb6229cd0u);
  expect_hash("clean", {}, 0xafe49bfed284c551u);
}

TEST_F(Derived, UnusableInputIsRefusedInOneLine) {
  TriangleSoup soup = kBook;
  soup.triangles.push_back({0, 1, 77});
  harness::expect_error([&] { made("subdivide", soup); },
                        {"input.off: face 3 names a vertex that does not exist", "generate clean"});
  for (const Triangle& twice : {Triangle{0, 1, 1}, {1, 0, 1}, {1, 1, 0}}) {
    soup.triangles.back() = twice;
    harness::expect_error([&] { made("refine", soup); },
                          {"face 3 has fewer than three different vertices"});
  }
  soup = kBook;
  soup.positions[2][1] = kInfinity;
  harness::expect_error([&] { made("noise", soup); }, {"vertex 2 is not finite"});
  harness::expect_error(
      [] {
        generate("subdivide", {{"input", "/no/such/file"}});
      },
      {"/no/such/file: no such file"});
}

TEST(DerivedErrors, MissingAndWrongParametersSayWhatIsWanted) {
  EXPECT_EQ(refusal("subdivide", {}),
            "subdivide: needs --input, the mesh to start from, OBJ, OFF, PLY or STL");
  for (const char* const steps : {"", "midpoint,", "loop,up", "loop midpoint"}) {
    EXPECT_EQ(refusal("subdivide", {{"input", "x"}, {"steps", steps}}),
              "subdivide: parameter steps is '" + std::string(steps) +
                  "'; it must be one or more of midpoint, loop, barycentric, separated by commas");
  }
  EXPECT_EQ(refusal("clean", {{"input", ""}}), "clean: parameter input is ''; it must be a file");
}

}  // namespace
}  // namespace geodesic
