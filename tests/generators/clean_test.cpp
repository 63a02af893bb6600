// Cleaning of meshes: each kind of defect alone, all kinds together, and random triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "meshes/connectivity.h"
#include "meshes/defects.h"
#include "solvers/core/mesh.h"
#include "tests/generators/generator_test.h"
#include "tests/harness/expect_error.h"
#include "tests/shapes.h"

namespace geodesic {
namespace {

Index add_vertex(TriangleSoup& soup, const Vec3& position) {
  soup.positions.push_back(position);
  return static_cast<Index>(soup.positions.size() - 1);
}

Vec3 between(const Vec3& a, const Vec3& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

/// Functions that add a defect to a mesh. Each appends vertices and faces and keeps other indices.

/// Splits the first side of a face at one of its ends, which makes an edge of length zero.
void add_zero_length_edge(TriangleSoup& soup, Index face) {
  const auto [a, b, c] = soup.triangles[face];
  const auto beyond =
      std::find_if(soup.triangles.begin(), soup.triangles.end(), [a = a, b = b](const Triangle& t) {
        return (t[0] == b && t[1] == a) || (t[1] == b && t[2] == a) || (t[2] == b && t[0] == a);
      });
  ASSERT_NE(beyond, soup.triangles.end());
  const Index d = (*beyond)[0] + (*beyond)[1] + (*beyond)[2] - a - b;
  const Index m = add_vertex(soup, soup.positions[a]);
  soup.triangles[face] = {m, b, c};
  std::replace(beyond->begin(), beyond->end(), a, m);
  soup.triangles.insert(soup.triangles.end(), {{a, m, c}, {m, a, d}});
}

/// Puts a vertex on the first side of a face, but not on the face beyond that side.
void add_flat_face(TriangleSoup& soup, Index face, double t) {
  const auto [a, b, c] = soup.triangles[face];
  const Index m = add_vertex(soup, between(soup.positions[a], soup.positions[b], t));
  soup.triangles[face] = {m, b, c};
  soup.triangles.insert(soup.triangles.end(), {{a, m, c}, {m, a, b}});
}

void add_fin(TriangleSoup& soup, Index face) {
  const auto [a, b, c] = soup.triangles[face];
  soup.triangles.push_back({a, b, add_vertex(soup, {9, 9, 9})});
}

void add_flap(TriangleSoup& soup, Index face) {
  const auto [a, b, c] = soup.triangles[face];
  const Index e = add_vertex(soup, {7, 7, 7});
  soup.triangles.insert(soup.triangles.end(), {{a, b, e}, {b, a, e}});
}

void add_unusable_faces(TriangleSoup& soup) {
  const Index nowhere = add_vertex(soup, {kInfinity, 0, 0});
  soup.triangles.insert(soup.triangles.end(),
                        {{0, 1, 123456}, {1, 1, 2}, {0, 1, nowhere}, soup.triangles[7]});
}

class Clean : public InputFiles {
 protected:
  TriangleSoup cleaned(const TriangleSoup& soup, const char* parts = "all") {
    return made("clean", soup, {{"parts", parts}});
  }

  void expect_remark(const std::string& expected) const {
    EXPECT_NE(std::find(remarks_.begin(), remarks_.end(), expected), remarks_.end())
        << "not said: " << expected;
  }

  /// Expects that the harness and the solvers find no defect in a cleaned mesh, and that another
  /// cleaning changes nothing. Sheets that are cut apart lie at the same place.
  void expect_measurable(const TriangleSoup& soup) {
    for (const Defect& defect : find_defects(soup).defects) {
      EXPECT_TRUE(defect.kind == DefectKind::several_components ||
                  defect.kind == DefectKind::coincident_vertex ||
                  defect.kind == DefectKind::nearly_coincident_vertex)
          << defect.text();
    }
    const Mesh mesh(soup);
    EXPECT_FALSE(mesh.has_degenerate_faces());
    EXPECT_FALSE(mesh.has_non_manifold_vertices());
    expect_same(cleaned(soup), soup);
    EXPECT_TRUE(remarks_.empty()) << remarks_.front();
  }

  const TriangleSoup sphere_ = generate("icosphere", {{"frequency", 4}});
  const TriangleSoup plate_ = generate("grid", {{"columns", 8}, {"rows", 8}});
};

TEST_F(Clean, LeavesWhatIsInOrderAlone) {
  for (const char* const name : {"icosphere", "holed-plate", "needles", "torus-knot"}) {
    expect_measurable(generate(name));
  }
}

TEST_F(Clean, DropsUnusableFacesAndVertices) {
  TriangleSoup soup = sphere_;
  add_unusable_faces(soup);
  expect_same(cleaned(soup), sphere_);
}

TEST_F(Clean, OrientsFaces) {
  TriangleSoup soup = sphere_;
  std::swap(soup.triangles[11][1], soup.triangles[11][2]);
  expect_same(cleaned(soup), sphere_);
}

TEST_F(Clean, WeldsEdgesOfLengthZero) {
  TriangleSoup soup = sphere_;
  for (const Index face : {0u, 40u, 90u}) add_zero_length_edge(soup, face);
  expect_same(cleaned(soup), sphere_);
  expect_remark("vertices joined to another along an edge without length: 3");
}

TEST_F(Clean, WeldsAWholeClusterAtOnePlace) {
  TriangleSoup soup = sphere_;
  for (int times = 0; times < 5; ++times) add_zero_length_edge(soup, 0);
  expect_same(cleaned(soup), sphere_);
}

TEST_F(Clean, CutsTheFaceBeyondAFlatFaceAtItsVertex) {
  TriangleSoup soup = plate_;
  const std::size_t face = 2 * 8 * 3 + 6;  // in the middle
  add_flat_face(soup, face, 0.5);
  const TriangleSoup result = cleaned(soup);
  expect_remark("edges flipped to the vertex that a face without area had on them: 1");
  expect_measurable(result);
  EXPECT_EQ(result.positions.size(), plate_.positions.size() + 1);
  EXPECT_EQ(result.triangles.size(), plate_.triangles.size() + 2);
  EXPECT_NEAR(area_of(result), 64, 1e-12);
  EXPECT_EQ(summarize(result).boundary_loops, 1u);
}

TEST_F(Clean, DropsAFlatFaceOnTheBoundary) {
  TriangleSoup soup = plate_;
  add_flat_face(soup, 0, 0.25);  // its first side lies on the boundary
  const TriangleSoup result = cleaned(soup);
  expect_measurable(result);
  EXPECT_EQ(result.triangles.size(), plate_.triangles.size() + 1);
  EXPECT_NEAR(area_of(result), 64, 1e-12);
  EXPECT_EQ(summarize(result).boundary_edges, 33u);
}

/// Adds random faces without area between two positions of a row of vertices on a line.
void add_flat_pile(TriangleSoup& soup, const std::vector<Index>& row, std::size_t first,
                   std::size_t last, std::mt19937& random) {
  if (last == first + 1) return;
  const std::size_t middle = first + 1 + random() % (last - first - 1);
  soup.triangles.push_back({row[first], row[last], row[middle]});
  add_flat_pile(soup, row, first, middle, random);
  add_flat_pile(soup, row, middle, last, random);
}

// A large triangle. Each side is a row of n vertices, with a small face beyond each part of it.
TEST_F(Clean, UnfoldsPilesOfFlatFaces) {
  for (const Index n : {2u, 3u, 5u, 9u, 64u}) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      std::mt19937 random(seed);
      const double size = n;
      TriangleSoup soup = {.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}},
                           .triangles = {{0, 1, 2}}};
      const Vec3 beyond[] = {{size, -size, 0}, {size, size, 0}, {-size, size, 0}};
      for (Index k = 0; k < 3; ++k) {
        const Vec3 from = soup.positions[(k + 1) % 3], to = soup.positions[k];
        std::vector<Index> row = {(k + 1) % 3};
        for (Index i = 1; i < n; ++i) row.push_back(add_vertex(soup, between(from, to, i / size)));
        row.push_back(k);
        const Index apex = add_vertex(soup, beyond[k]);
        for (Index i = 0; i < n; ++i) soup.triangles.push_back({row[i], row[i + 1], apex});
        add_flat_pile(soup, row, 0, n, random);
      }
      const double area = area_of(soup);
      const TriangleSoup result = cleaned(soup);
      expect_measurable(result);
      EXPECT_EQ(result.triangles.size(), 3 * n + 1 + 3 * (n - 1)) << n << ' ' << seed;
      EXPECT_NEAR(area_of(result), area, 1e-12 * area);
      EXPECT_EQ(summarize(result).boundary_edges, 6u);
    }
  }
}

// A vertex of three faces lies in the middle of the opposite edge of one of them. After the flip of
// that edge, two faces lie back to back.
TEST_F(Clean, RemovesAFoldThatAFlipUncovers) {
  TriangleSoup soup = plate_;
  const Index face = 2 * 8 * 3 + 6;
  const auto [a, b, c] = soup.triangles[face];
  const Index m = add_vertex(soup, between(soup.positions[a], soup.positions[b], 0.5));
  soup.triangles[face] = {a, m, c};
  soup.triangles.insert(soup.triangles.end(), {{m, b, c}, {a, b, m}});
  const TriangleSoup result = cleaned(soup);
  expect_measurable(result);
  EXPECT_NEAR(area_of(result), 64, 1e-12);
  EXPECT_EQ(summarize(result).boundary_loops, 1u);
}

TEST_F(Clean, TakesAFinOff) {
  TriangleSoup soup = sphere_;
  add_fin(soup, 17);
  expect_same(cleaned(soup, "largest"), sphere_);
  const TriangleSoup all = cleaned(soup);
  expect_measurable(all);
  EXPECT_EQ(all.positions.size(), sphere_.positions.size() + 3) << "the fin and its spine's copy";
}

TEST_F(Clean, CancelsFlaps) {
  TriangleSoup soup = sphere_;
  for (const Index face : {3u, 50u}) add_flap(soup, face);
  // A flap between existing vertices, as collapsed edges leave it.
  soup.triangles.insert(soup.triangles.end(), {{5, 30, 60}, {30, 5, 60}});
  expect_same(cleaned(soup), sphere_);
  expect_remark("faces removed that lay back to back on the same three vertices: 6");
}

TEST_F(Clean, KeepsOneSideOfASurfaceStoredTwice) {
  TriangleSoup soup = plate_;
  for (const auto& [a, b, c] : plate_.triangles) soup.triangles.push_back({b, a, c});
  expect_same(cleaned(soup), plate_);
}

TEST_F(Clean, SplitsTwoSpheresThatShareAVertex) {
  TriangleSoup soup = side_by_side(sphere_, sphere_);
  const auto first = static_cast<Index>(sphere_.positions.size());
  for (Triangle& face : soup.triangles) std::replace(face.begin(), face.end(), first + 20, 20u);
  const TriangleSoup result = cleaned(soup);
  expect_measurable(result);
  EXPECT_EQ(result.positions.size(), 2 * sphere_.positions.size());
  EXPECT_EQ(summarize(result).components, 2u);
}

TEST_F(Clean, SplitsTwoTubesThatTouchAlongAnEdge) {
  const TriangleSoup tube = generate("cylinder", {{"sides", 12}, {"rows", 6}});
  TriangleSoup soup = side_by_side(tube, tube);
  const auto first = static_cast<Index>(tube.positions.size());
  // Vertices 24 and 36 are neighbours along the axis.
  for (Triangle& face : soup.triangles) {
    std::replace(face.begin(), face.end(), first + 24, 24u);
    std::replace(face.begin(), face.end(), first + 36, 36u);
  }
  ASSERT_EQ(find_defects(soup).count(DefectKind::non_manifold_edge), 1u);
  const TriangleSoup result = cleaned(soup);
  expect_measurable(result);
  EXPECT_EQ(summarize(result).boundary_loops, 4u) << "no slit";
}

TEST_F(Clean, CutsASurfaceOfOneSide) {
  const Index n = 20;
  const TriangleSoup soup = band(n, true);
  ASSERT_FALSE(summarize(soup).orientable);
  const TriangleSoup result = cleaned(soup);
  expect_measurable(result);
  EXPECT_EQ(result.triangles.size(), 2 * n);
  EXPECT_EQ(result.positions.size(), 2 * n + 2);
  EXPECT_TRUE(summarize(result).orientable);
}

TEST_F(Clean, KeepsTheComponentOfMostFaces) {
  const TriangleSoup soup =
      side_by_side(side_by_side(generate("icosphere", {{"frequency", 2}}), sphere_),
                   generate("icosphere", {{"frequency", 3}}));
  expect_same(cleaned(soup, "largest"), sphere_);
  expect_remark("smaller components dropped: 2");
  EXPECT_EQ(summarize(cleaned(soup)).components, 3u);
}

TEST_F(Clean, CleansEverythingAtOnce) {
  TriangleSoup soup = plate_;
  add_unusable_faces(soup);
  for (const Index face : {20u, 33u}) add_zero_length_edge(soup, face);
  for (const Index face : {50u, 54u, 80u}) add_flat_face(soup, face, 0.5);
  for (const Index face : {50u, 90u}) add_zero_length_edge(soup, face);
  for (const Index face : {60u, 104u}) add_fin(soup, face);
  for (const Index face : {63u, 99u}) add_flap(soup, face);
  std::swap(soup.triangles[70][0], soup.triangles[70][1]);
  soup = side_by_side(std::move(soup), sphere_);
  soup.triangles.push_back({0, 1, static_cast<Index>(plate_.positions.size() + 40)});
  const TriangleSoup all = cleaned(soup);
  expect_measurable(all);
  soup.triangles.resize(soup.triangles.size() - sphere_.triangles.size() - 1);
  const TriangleSoup largest = cleaned(soup, "largest");
  expect_measurable(largest);
  EXPECT_NEAR(area_of(largest), 64, 1e-12);
  EXPECT_EQ(summarize(largest).boundary_loops, 1u);
}

// Random triangles on a small lattice: coinciding or collinear vertices, many faces at an edge.
TEST_F(Clean, MakesAnyTrianglesMeasurableOrRefusesThem) {
  std::size_t refused = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    std::mt19937 random(seed);
    const auto below = [&](Index n) { return static_cast<Index>(random() % n); };
    TriangleSoup soup;
    const Index vertices = 4 + below(20), width = 2 + below(4);
    for (Index v = 0; v < vertices; ++v) {
      soup.positions.push_back({1.0 * below(width), 1.0 * below(width), 1.0 * below(2)});
    }
    for (Index f = 2 + below(60); f > 0; --f) {
      soup.triangles.push_back({below(vertices), below(vertices), below(vertices)});
    }
    try {
      expect_measurable(cleaned(soup));
    } catch (const MeshError& error) {
      EXPECT_NE(std::string(error.what()).find("no face with an area is left"), std::string::npos)
          << error.what();
      ++refused;
    }
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_LT(refused, 40u);
}

// The same on sheets, where flat faces have neighbours. Vertices move onto others or half-way.
TEST_F(Clean, MakesCollapsedSheetsMeasurable) {
  std::size_t flipped = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    TriangleSoup soup = generate("grid", {{"columns", 9}, {"rows", 9}});
    for (int moves = 0; moves < 25; ++moves) {
      const std::size_t v = random() % 100, w = random() % 100;
      soup.positions[v] = random() % 2 == 0 ? soup.positions[w]
                                            : between(soup.positions[v], soup.positions[w], 0.5);
    }
    const TriangleSoup result = cleaned(soup);
    for (const std::string& remark : remarks_) {
      flipped += remark.starts_with("edges flipped") ? 1u : 0u;
    }
    expect_measurable(result);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(flipped, 50u) << "of 200 sheets: too few to mean anything";
}

TEST_F(Clean, RefusesAMeshWithoutAnyArea) {
  const TriangleSoup soup = {.positions = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}},
                             .triangles = {{0, 1, 2}}};
  harness::expect_error([&] { cleaned(soup); }, {"input.off", "no face with an area is left"});
  harness::expect_error([&] { cleaned(soup, "largest"); }, {"no face with an area is left"});
}

}  // namespace
}  // namespace geodesic
