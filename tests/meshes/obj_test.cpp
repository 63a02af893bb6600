#include <gtest/gtest.h>

#include <clocale>

#include "meshes/mesh_file.h"
#include "tests/meshes/mesh_samples.h"

namespace geodesic {
namespace {

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

MeshFile parse(const std::string& text) { return parse_mesh(text, "test.obj"); }

TEST(Obj, KeepsTheFilesVerticesAndFacesInOrder) { expect_tetrahedron(kObj, "test.obj", "OBJ"); }

TEST(Obj, KnowsTheLineOfEveryElement) {
  const MeshFile file = parse("# title\n" + kCorners + "\nf 1 2 3 4\nf 1 3 2\n");
  EXPECT_EQ(file.lines.vertices, (std::vector<std::uint32_t>{2, 3, 4, 5}));
  EXPECT_EQ(file.lines.triangles, (std::vector<std::uint32_t>{7, 7, 8}));
}

TEST(Obj, KeepsFullDoublePrecision) {
  const MeshFile file =
      parse("v 0.1234567890123456 -1e-300 +2.5\nv 4.9e-324 1e-400 1\nv 1. .5 -0.0\nf 1 2 3\n");
  EXPECT_EQ(file.soup.positions[0], (Vec3{0.1234567890123456, -1e-300, 2.5}));
  EXPECT_EQ(file.soup.positions[1], (Vec3{4.9e-324, 0, 1}));
  EXPECT_EQ(file.soup.positions[2], (Vec3{1, 0.5, 0}));
}

TEST(Obj, DoesNotDependOnTheLocale) {
  // Locales with a decimal comma need not be installed; without any this repeats the plain case.
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    if (std::setlocale(LC_ALL, locale) != nullptr) break;
  }
  const MeshFile file = parse("v 0.5 1.25 2\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(file.soup.positions[0], (Vec3{0.5, 1.25, 2}));
}

TEST(Obj, ReadsCornersWithTexturesAndNormals) {
  const std::string head = kCorners + "vt 0 0\nvn 0 0 1\n";
  for (const char* face :
       {"f 1 2 3", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1", "f 1/ 2// 3/1/"}) {
    EXPECT_EQ(parse(head + face + "\n").soup.triangles, (std::vector<Triangle>{{0, 1, 2}})) << face;
  }
}

TEST(Obj, CountsNegativeIndicesFromTheLastVertexReadSoFar) {
  const MeshFile file = parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4//-1 -2 -1\n");
  EXPECT_EQ(file.soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Obj, AcceptsFacesBeforeTheirVertices) {
  EXPECT_EQ(parse("f 1 2 3\n" + kCorners).soup.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(Obj, ReadsCommentsBlankLinesCarriageReturnsAndContinuations) {
  const std::string dressed =
      "# a\r\n\r\n  v 0 0 0 # first\r\nv\t1 0 0\r\nv 1 \\\r\n 1 0\r\nv 0 1 0\r\nf 1 2 \\\r\n3 "
      "4\r\n";
  const MeshFile file = parse(dressed);
  EXPECT_EQ(file.soup.positions, parse(kCorners + "f 1 2 3 4\n").soup.positions);
  EXPECT_EQ(file.soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Obj, ReadsLinesThatEndWithACarriageReturnAlone) {
  EXPECT_EQ(parse("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r").soup.positions.size(), 3u);
}

TEST(Obj, SkipsWeightsAndColoursBehindCoordinates) {
  const MeshFile file = parse("v 1 2 3 1.0\nv 4 5 6 0.1 0.2 0.3\nv 7 8 9 0.1 0.2 0.3 1\nf 1 2 3\n");
  EXPECT_EQ(file.soup.positions, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
}

TEST(Obj, ReportsGeometryThatIsNotRead) {
  const MeshFile file = parse(kCorners + "l 1 2\nl 2 3\nf 1 2 3\n");
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_TRUE(contains(file.warnings[0], "2 statements 'l' are ignored")) << file.warnings[0];
}

TEST(Obj, WarnsWhenTheLastLineHasNoEnd) {
  const MeshFile file = parse(kCorners + "f 1 2 3");
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_TRUE(contains(file.warnings[0], "no line end")) << file.warnings[0];
}

TEST(Obj, LeavesIndicesOutOfRangeToTheSearchForDefects) {
  const MeshFile file = parse(kCorners + "f 1 2 9\nf 0 1 2\nf -9 1 2\nf 99999999999 1 2\n");
  EXPECT_EQ(file.soup.triangles[0], (Triangle{0, 1, 8}));
  for (const std::size_t f : {1u, 2u, 3u}) EXPECT_EQ(file.soup.triangles[f][0], kNone) << f;
}

TEST(Obj, NamesTheLineOfWhatIsMalformed) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"v 0 0\nf 1 1 1\n", "test.obj, line 1: the z coordinate is missing"},
      {"v 0 0 x\n", "test.obj, line 1: the z coordinate 'x' is not a number"},
      {"v 0 0 1,5\n", "the z coordinate '1,5' is not a number"},
      {"v 0 0 1e99999\n", "is beyond the range of numbers"},
      {"v 0 0 0x10\n", "is not a number"},
      {"v 1 2 3 4 5 6 7 8 9\n", "9 numbers"},
      {kCorners + "f 1 2 3.5\n", "line 5: the vertex of a face '3.5' is not an integer"},
      {kCorners + "f 1 2/a 3\n", "texture of a corner"},
      {kCorners + "f 1 2 3//a\n", "normal of a corner"},
      {kCorners + "f 1 2 3///\n", "normal of a corner"},
      {kCorners + "face 1 2 3\n", "line 5: unknown statement 'face'"},
      {kCorners + "f 1 2 3 \\", "the file ends before"},
      {"v 0 0 \x7f\n", "'\\x7f'"},
  };
  for (const auto& [text, expected] : cases) expect_refusal(text, "test.obj", expected);
}

}  // namespace
}  // namespace geodesic
