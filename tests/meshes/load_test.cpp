// Loading a mesh refuses it, warns or repairs; writing it and reading it again loses nothing.
#include "meshes/load.h"

#include <gtest/gtest.h>

#include "meshes/mesh_file.h"
#include "solvers/core/mesh.h"
#include "tests/harness/temporary_folder.h"
#include "tests/meshes/mesh_samples.h"

namespace geodesic {
namespace {

using Load = harness::TemporaryFolder;

TEST_F(Load, NamesWhatIsNoFile) {
  const auto message = [](const std::filesystem::path& path) {
    return message_of<MeshError>([&] { load_mesh(path); });
  };
  EXPECT_EQ(message(folder_ / "none.obj"),
            (folder_ / "none.obj").string() + ": no such file; check the path");
  EXPECT_EQ(message(folder_), folder_.string() + ": a folder, pipe or device; name a file");
  EXPECT_EQ(message("/dev/zero"), "/dev/zero: a folder, pipe or device; name a file");
}

TEST_F(Load, RefusesErrorsWithTheFileTheFirstExampleAndTheWayOut) {
  const auto path = write("a.obj", kMisoriented);
  EXPECT_EQ(message_of<MeshError>([&] { load_mesh(path); }),
            path.string() +
                ": distances would be meaningless: 1 edge between inconsistently oriented faces "
                "(first: edge 0-2 of face 0 (line 5), face 1 (line 6)); correct the mesh or use "
                "--repair");
}

TEST_F(Load, RepairsWhenAskedAndReportsIt) {
  const LoadedMesh mesh = load_mesh(write("a.obj", kMisoriented), {.repair = true});
  EXPECT_EQ(mesh.defects.count(DefectKind::inconsistent_orientation), 1u);
  ASSERT_EQ(mesh.repairs.size(), 1u);
  EXPECT_EQ(mesh.repairs[0].key, "flipped_faces");
  ASSERT_EQ(mesh.warnings.size(), 2u);
  EXPECT_TRUE(contains(mesh.warnings[1], "repair: faces flipped")) << mesh.warnings[1];
  EXPECT_EQ(Mesh(mesh.soup).edge_count(), 5u);
}

TEST_F(Load, ARepairLeavesTheEdgesThatAreCrossed) {
  const std::string fin =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 2 1 5\n";
  const auto path = write("a.obj", fin + "f 3 2 1\n");
  const LoadOptions options = {.repair = true, .non_manifold_edges = NonManifoldEdges::crossed};
  const BuiltMesh built = build_mesh(path, options);
  ASSERT_EQ(built.loaded.repairs.size(), 1u);
  EXPECT_EQ(built.loaded.repairs[0].key, "dropped_repeated_face");
  EXPECT_TRUE(built.mesh->crosses_non_manifold_edges());
  EXPECT_EQ(built.loaded.soup.triangles, load_mesh(write("b.obj", fin), options).soup.triangles);
}

TEST_F(Load, WarnsOfTheRestAndKeepsVertexIds) {
  const LoadedMesh mesh =
      load_mesh(write("a.obj", "v 7 7 7\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n"));
  EXPECT_EQ(mesh.warnings,
            (std::vector<std::string>{"1 isolated vertex (first: vertex 0 (line 1))"}));
  EXPECT_EQ(mesh.soup.positions.size(), 4u);
  EXPECT_EQ(mesh.soup.positions[0], (Vec3{7, 7, 7}));
}

const std::string kSeam =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\nf 1 2 3\nf 5 4 6\n";

TEST_F(Load, WarnsOfSeamsAndSaysHowToJoinThem) {
  const LoadedMesh mesh = load_mesh(write("a.obj", kSeam));
  ASSERT_EQ(mesh.warnings.size(), 2u);
  EXPECT_EQ(mesh.warnings[0],
            "2 vertices where an earlier one lies (first: vertex 3 (line 4) at the place of "
            "vertex 1 (line 2)): paths do not cross there; --weld joins them");
}

TEST_F(Load, WeldsWhenAskedBeforeDefectsAreSearchedFor) {
  const auto path = write("a.obj", kSeam);
  for (const bool repair : {false, true}) {
    const BuiltMesh built = build_mesh(path, {.repair = repair, .weld = 0});
    EXPECT_EQ(built.loaded.warnings,
              (std::vector<std::string>{"weld: vertices joined to an earlier one: 2"}));
    EXPECT_TRUE(built.loaded.defects.defects.empty());
    EXPECT_EQ(built.mesh->edge_count(), 5u);
  }
  EXPECT_TRUE(load_mesh(path, {.repair = true}).repairs.empty()) << "a repair joined vertices";
}

TEST_F(Load, RefusesAWeldThatLeavesNoFaceAndADistanceThatIsNone) {
  const auto path = write("a.obj", kSeam);
  const auto message = [&](double distance) {
    return message_of<MeshError>([&] { build_mesh(path, {.weld = distance}); });
  };
  EXPECT_EQ(message(1), path.string() +
                            ": every face collapses when vertices are joined; join "
                            "them within a smaller distance");
  EXPECT_EQ(message(-2),
            "the distance within which vertices are joined must be finite and 0 or "
            "more, not -2");
}

TEST_F(Load, RefusesTrianglesWhoseFlagsOrJoinedVerticesDoNotFit) {
  MeshFile file;
  file.soup = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  for (const bool repair : {false, true}) {
    file.soup.joined_to = {0, 1, 2, 9};
    EXPECT_EQ(message_of<MeshError>([&] { build_mesh(file, "a", {.repair = repair}); }),
              "a: vertex 3 is joined to vertex 9, which is not there");
    file.soup.joined_to.clear();
    file.soup.left_out = {true};
    EXPECT_EQ(message_of<MeshError>([&] { build_mesh(file, "a", {.repair = repair}); }),
              "a: left_out has 1 flags for 2 triangles");
    file.soup.left_out.clear();
  }
}

TEST_F(Load, LeavesAvoidedFacesOutAfterAWeldAndBeforeDefectsAreSearchedFor) {
  const auto path = write("a.obj", kSeam + "f 1 2 2\n");
  for (const bool repair : {false, true}) {
    const LoadOptions options = {.repair = repair, .weld = 0, .avoid = {.faces = {2}}};
    const BuiltMesh built = build_mesh(path, options);
    EXPECT_TRUE(built.loaded.defects.defects.empty());
    EXPECT_TRUE(built.loaded.repairs.empty());
    EXPECT_EQ(built.loaded.soup.left_out, (std::vector<bool>{false, false, true}));
    EXPECT_EQ(built.mesh->external_face_count(), 3u);
  }
}

TEST_F(Load, RefusesAvoidedElementsThatAreNotThereOrLeaveNoFace) {
  const auto path = write("a.obj", kSeam);
  const auto message = [&](const Avoided& avoid) {
    return message_of<MeshError>([&] { build_mesh(path, {.avoid = avoid}); });
  };
  EXPECT_EQ(message({.vertices = {6}}),
            path.string() + ": avoided vertex 6 is not in the mesh of 6 vertices");
  EXPECT_EQ(message({.vertices = {0}, .faces = {1}}),
            path.string() + ": no face is left: all of them are avoided");
}

TEST_F(Load, RefusesAMeshOfWhichARepairLeavesNothing) {
  const auto path = write("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 2\n");
  EXPECT_THROW(load_mesh(path, {.repair = true}), MeshError);
}

TEST(Write, BringsBackTheSameDoublesAndFacesInEveryFormat) {
  TriangleSoup soup = tetrahedron();
  soup.positions[1] = {1.0 / 3, -4.9406564584124654e-324, 1.7976931348623157e308};
  soup.positions[2] = {0.1234567890123456, 1e-7, -0.0};
  soup.positions.push_back({5, 5, 5});  // isolated
  for (const char* name : {"a.obj", "a.off", "a.ply", "B.PLY"}) {
    const MeshFile file = parse_mesh(mesh_bytes(soup, name), name);
    EXPECT_EQ(file.soup.positions, soup.positions) << name;
    EXPECT_EQ(file.soup.triangles, soup.triangles) << name;
    EXPECT_TRUE(file.warnings.empty()) << name << ": " << file.warnings[0];
  }
}

TEST(Write, LeavesOutFacesThatCollapsedAndKeepsTheNumbersOfVertices) {
  TriangleSoup soup = parse_mesh(kSeam + "f 2 4 6\n", "a.obj").soup;
  weld(soup);
  const TriangleSoup written = parse_mesh(mesh_bytes(soup, "b.ply"), "b.ply").soup;
  EXPECT_EQ(written.positions, soup.positions);
  EXPECT_EQ(written.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 5}}));
}

TEST(Write, RefusesOtherFormatsAndIndicesOutOfRange) {
  EXPECT_THROW(mesh_bytes(tetrahedron(), "a.stl"), MeshError);
  TriangleSoup soup = tetrahedron();
  soup.triangles.push_back({0, 1, 9});
  EXPECT_THROW(mesh_bytes(soup, "a.obj"), MeshError);
}

}  // namespace
}  // namespace geodesic
