// Files of a mesh with its distances have the mesh of the solve, and every digit of the distances.
#include "meshes/field_file.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "meshes/formats/bytes.h"
#include "meshes/mesh_file.h"
#include "tests/message_of.h"

namespace geodesic {
namespace {

const TriangleSoup kPlate{{{0, 0, 0}, {1, 0, 0}, {1, 0.1, 0}, {0, 1, 0}, {5, 5, 5}},
                          {{0, 1, 2}, {0, 2, 3}}};
const std::vector<double> kFar{0, 1, 1.0049875621120890, 1, kInfinity};
const std::vector<Index> kNearest{0, 0, 0, 0, kNone};

TEST(FieldFile, in_ply_is_the_mesh_with_a_quality_that_viewers_know) {
  const std::string bytes = field_bytes(kPlate, kFar, kNearest, "a.PLY");
  const MeshFile file = parse_mesh(bytes, "a.ply");
  EXPECT_EQ(file.soup.positions, kPlate.positions);
  EXPECT_EQ(file.soup.triangles, kPlate.triangles);
  EXPECT_NE(bytes.find("\nproperty double quality\nproperty int source\nelement face 2\n"),
            std::string::npos);
  const char* at = bytes.data() + bytes.find("end_header\n") + 11;
  for (std::size_t v = 0; v < kFar.size(); ++v, at += 36) {
    EXPECT_EQ(load_number<double>(at + 24, std::endian::little), kFar[v]);
    EXPECT_EQ(load_number<std::int32_t>(at + 32, std::endian::little), v == 4 ? -1 : 0);
  }
}

TEST(FieldFile, in_vtk_has_the_numbers_that_its_header_announces) {
  const std::string bytes = field_bytes(kPlate, kFar, {}, "a.vtk");
  EXPECT_TRUE(bytes.starts_with("# vtk DataFile Version 3.0\n"));
  EXPECT_EQ(bytes.find("source"), std::string::npos);
  const auto after = [&](const std::string& line) {
    return bytes.data() + bytes.find(line) + line.size();
  };
  const char* points = after("\nDATASET POLYDATA\nPOINTS 5 double\n");
  const char* faces = after("\nPOLYGONS 2 8\n");
  const char* distances =
      after("\nPOINT_DATA 5\nSCALARS distance double 1\nLOOKUP_TABLE default\n");
  EXPECT_EQ(points + 15 * 8 + 14, faces);
  EXPECT_EQ(load_number<double>(points + 7 * 8, std::endian::big), 0.1);
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_EQ(load_number<std::int32_t>(faces + 16 * f, std::endian::big), 3);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(load_number<Index>(faces + 16 * f + 4 + 4 * k, std::endian::big),
                kPlate.triangles[f][k]);
    }
  }
  for (std::size_t v = 0; v < kFar.size(); ++v) {
    EXPECT_EQ(load_number<double>(distances + 8 * v, std::endian::big), kFar[v]);
  }
  EXPECT_EQ(distances + 8 * kFar.size() + 1, bytes.data() + bytes.size());
}

TEST(FieldFile, of_another_suffix_is_refused) {
  EXPECT_EQ(message_of<MeshError>([] { field_bytes(kPlate, kFar, {}, "a.obj"); }),
            "cannot write 'a.obj': a mesh with distances is written as .ply or .vtk");
}

TEST(FieldFile, of_another_number_of_distances_or_sources_is_refused) {
  const std::string end = " a vertex: 1 for " + std::to_string(kFar.size()) + " vertices";
  for (const char* file : {"a.ply", "a.vtk"}) {
    EXPECT_EQ(message_of<std::invalid_argument>(
                  [&] { field_bytes(kPlate, std::vector<double>(1), {}, file); }),
              "a mesh with distances needs one distance" + end);
    EXPECT_EQ(message_of<std::invalid_argument>(
                  [&] { field_bytes(kPlate, kFar, std::vector<Index>(1), file); }),
              "a mesh with distances needs one source" + end);
  }
}

}  // namespace
}  // namespace geodesic
