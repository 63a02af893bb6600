// Every defect is found and counted, and its first example is named.
#include "meshes/defects.h"

#include <gtest/gtest.h>

#include "tests/meshes/mesh_samples.h"
#include "tests/shapes.h"

namespace geodesic {
namespace {

DefectReport defects_of(const std::string& obj) {
  const MeshFile file = parse_mesh(obj, "test.obj");
  return find_defects(file.soup, file.lines);
}

std::string text_of(const DefectReport& report) {
  std::string text;
  for (const Defect& defect : report.defects) text += defect.text() + "\n";
  return text;
}

// Expects that a file has one defect and no other.
void expect_only(const std::string& obj, DefectKind kind, const std::string& text) {
  const DefectReport report = defects_of(obj);
  EXPECT_EQ(text_of(report), text + "\n");
  EXPECT_GT(report.count(kind), 0u);
  EXPECT_EQ(report.has_errors(), type_of(kind).severity == Severity::error);
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string kTwoFaces = kSquare + "f 1 2 3\nf 1 3 4\n";

TEST(Defects, ACleanMeshHasNone) {
  EXPECT_EQ(text_of(defects_of(kObj)), "");
  EXPECT_EQ(text_of(defects_of(kTwoFaces)), "");
}

TEST(Defects, OfEveryKindAreCountedAndTheFirstIsNamed) {
  using enum DefectKind;
  expect_only(
      kTwoFaces + "f 1 2 9\nf 0 1 2\n", index_out_of_range,
      "2 faces that name a vertex that does not exist (first: face 2 (line 7) of vertices 0, "
      "1, 8; the mesh has 4 vertices, counted here from 0)");
  expect_only(
      kTwoFaces + "f 1 2 2\n", repeated_vertex,
      "1 face of fewer than three different vertices (first: face 2 (line 7) of vertices 0, 1, 1)");
  for (const char* coordinate : {"nan", "inf", "-inf", "1e400", "-2e150"}) {
    expect_only(kTwoFaces + "v 0 0 " + coordinate + "\nf 1 4 5\n", non_finite_coordinate,
                "1 vertex with a coordinate that is not finite or above 1e150 (first: vertex 4 "
                "(line 7))\n1 isolated vertex (first: vertex 4 (line 7))");
  }
  expect_only(kTwoFaces + "f 2 3 1\nf 3 2 1\n", repeated_face,
              "2 repeated faces (first: face 2 (line 7) of vertices 1, 2, 0)");
  expect_only(kTwoFaces + "v 0.5 0.5 1\nf 3 1 5\n", non_manifold_edge,
              "1 non-manifold edge (first: edge 0-2 of face 0 (line 5), face 1 (line 6), face 2 "
              "(line 8))");
  expect_only(kMisoriented, inconsistent_orientation,
              "1 edge between inconsistently oriented faces (first: edge 0-2 of face 0 (line 5), "
              "face 1 (line 6))");
  expect_only(kSquare + "v 5 5 5\nf 1 2 3\nf 1 4 5\n", non_manifold_vertex,
              "1 non-manifold vertex (first: vertex 0 (line 1))");
  expect_only("v 0 0 0\nv 1 0 0\nv 3 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n", zero_area_face,
              "1 degenerate face of zero area (first: face 0 (line 5) of vertices 0, 1, 2)");
  expect_only("v 0 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n", zero_length_edge,
              "1 degenerate face of zero area (first: face 0 (line 5) of vertices 0, 1, 2)\n"
              "1 zero-length edge (first: edge 0-1 of face 0 (line 5))");
  expect_only("v 9 9 9\n" + kSquare + "f 2 3 4\nf 2 4 5\n", isolated_vertex,
              "1 isolated vertex (first: vertex 0 (line 1))");
  expect_only(kTwoFaces + "v 5 0 0\nv 6 0 0\nv 5 1 0\nf 5 6 7\n", several_components,
              "2 components that no path connects (first: the second holds face 2 (line 10))");
}

// The second triangle shares the edge from (1, 0, 0) to (1, 1, 0) in space, not its vertices.
std::string seam(const std::string& x, const std::string& rest = "") {
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv " + x + " -0 0\nv " + x + " 1 0\nv 2 0 0\n" + rest +
         "f 1 2 3\nf 5 4 6\n";
}

TEST(Defects, VerticesAtThePlaceOfAnEarlierOneAreCountedIfFacesUseThem) {
  const std::string components =
      "\n2 components that no path connects (first: the second holds face 1 (line 8))";
  expect_only(seam("1"), DefectKind::coincident_vertex,
              "2 vertices where an earlier one lies (first: vertex 3 (line 4) at the place of "
              "vertex 1 (line 2))" +
                  components);
  expect_only(seam("1.000001"), DefectKind::nearly_coincident_vertex,
              "2 vertices within 1e-6 mean edge lengths of an earlier one (first: vertex 3 "
              "(line 4) near vertex 1 (line 2))" +
                  components);
  EXPECT_EQ(defects_of(seam("1.0000014")).defects.size(), 1u);
  const DefectReport isolated = defects_of(seam("1.1", "v 1 0 0\n"));
  EXPECT_EQ(isolated.count(DefectKind::isolated_vertex), 1u);
  EXPECT_EQ(isolated.count(DefectKind::coincident_vertex), 0u);
  // Each of three joins at one place counts once, and no pair is nearly coincident as well.
  const DefectReport twice = defects_of(seam("1", "v 1 0 0\nv 3 0 0\nv 3 0 1\nf 7 8 9\n"));
  EXPECT_EQ(twice.count(DefectKind::coincident_vertex), 3u);
  EXPECT_EQ(twice.count(DefectKind::nearly_coincident_vertex), 0u);
}

TEST(Defects, VerticesThatAVeryShortEdgeConnectAreNoSeam) {
  const std::string obj = "v 0 0 0\nv 1e-9 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\nf 2 3 4\n";
  EXPECT_EQ(text_of(defects_of(obj)), "");
}

TEST(Defects, SmallnessIsNoDefect) {
  for (const double scale : {1e-150, 1e-30, 1e100, 9e149}) {
    TriangleSoup soup = tetrahedron();
    for (Vec3& p : soup.positions) {
      for (double& c : p) c *= scale;
    }
    EXPECT_EQ(text_of(find_defects(soup)), "") << "scale " << scale;
  }
}

TEST(Defects, AThinTriangleHasAnArea) {
  const TriangleSoup soup{.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-12, 0}},
                          .triangles = {{0, 1, 2}}};
  EXPECT_EQ(text_of(find_defects(soup)), "");
}

TEST(Defects, ExamplesOfBinaryFilesHaveNoLines) {
  TriangleSoup soup = tetrahedron();
  soup.triangles.push_back({1, 1, 2});
  EXPECT_EQ(text_of(find_defects(soup)),
            "1 face of fewer than three different vertices (first: face 4 of vertices 1, 1, 2)\n");
}

TEST(Defects, AVertexOfManyFacesCostsNoQuadraticTime) {
  EXPECT_EQ(text_of(find_defects(fan(200'000, 1, 1))), "");
}

}  // namespace
}  // namespace geodesic
