#include <gtest/gtest.h>

#include "meshes/mesh_file.h"
#include "tests/meshes/mesh_samples.h"

namespace geodesic {
namespace {

const std::string kBody = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(Off, KeepsTheFilesVerticesAndFacesInOrder) {
  const MeshFile file = parse_mesh(kOff, "test.off");
  EXPECT_EQ(file.soup.positions, tetrahedron().positions);
  EXPECT_EQ(file.soup.triangles, tetrahedron().triangles);
  EXPECT_EQ(file.format, "OFF");
  EXPECT_EQ(file.lines.vertices.front(), 3u);
  EXPECT_EQ(file.lines.triangles.front(), 7u);
  EXPECT_TRUE(file.warnings.empty());
}

TEST(Off, ReadsEveryWayToWriteTheCounts) {
  for (const char* head : {"OFF\n3 1 3\n", "OFF\n3 1\n", "OFF 3 1 0\n", "OFF3 1 0\n",
                           "# c\nOFF # c\n\n# c\n 3 1 0 # c\n", "OFF\r\n3 1 0\r\n"}) {
    EXPECT_EQ(parse_mesh(head + kBody, "test.off").soup.positions.size(), 3u) << head;
  }
}

TEST(Off, ReadsColoursNormalsAndTexturesOfVertices) {
  const std::string face = "3 0 1 2\n";
  const auto vertices = [](const std::string& extras) {
    return "\n3 1 0\n0 0 0" + extras + "\n1 0 0" + extras + "\n0 1 0" + extras + "\n";
  };
  for (const auto& [keyword, extras] :
       std::vector<std::pair<std::string, std::string>>{{"COFF", " 255 0 0 255"},
                                                        {"COFF", " 1 0 0"},
                                                        {"NOFF", " 0 0 1"},
                                                        {"CNOFF", " 0 0 1 1 0 0 1"},
                                                        {"STOFF", " 0.5 0.5"}}) {
    EXPECT_EQ(parse_mesh(keyword + vertices(extras) + face, "test.off").soup.positions[1],
              (Vec3{1, 0, 0}))
        << keyword << extras;
  }
}

TEST(Off, SkipsColoursOfFaces) {
  const MeshFile file =
      parse_mesh("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 1 7\n", "test.off");
  EXPECT_EQ(file.soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 1}}));
}

TEST(Off, FacesContinueOnLaterLines) {
  const std::string vertices = "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n-1 0.5 0\n";
  const MeshFile file = parse_mesh(
      vertices + "5 0 1\n# a comment\n 2 3 # and one more\n\n4 255 0 0\n3\n0 1 2\n3 0 2 3 7\n",
      "test.off");
  EXPECT_EQ(file.soup.triangles,
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(file.lines.triangles, (std::vector<std::uint32_t>{8, 8, 8, 13, 15}));
  EXPECT_TRUE(file.warnings.empty());
}

TEST(Off, ACountThatTakesTheNextFaceIsFoundAtTheEnd) {
  const std::string text = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n4 0 2 1\n3 0 1 3\n";
  const std::string expected =
      "line 10: the file ends before face 2 of 3 (the face of line 8 is the first that continues "
      "on "
      "the next line)";
  EXPECT_TRUE(contains(refusal(text, "test.off"), expected)) << refusal(text, "test.off");
}

TEST(Off, NamesTheLineOfWhatIsMalformed) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"OFF\n3 2 0\n" + kBody + "# end\n\n\n", "line 10: the file ends before face 1 of 2"},
      {"OFF\n3 1 0\n" + kBody + "3 0 1 2\n", "line 7: more lines than the header's 3 vertices"},
      {"OFF\n-3 1 0\n" + kBody, "the number of vertices is negative"},
      {"OFF\n3 x 0\n" + kBody, "the number of faces 'x' is not an integer"},
      {"OFF\n3 1 0 4\n" + kBody, "a header has three counts"},
      {"OFF\n3\n" + kBody, "the number of faces '' is not an integer"},
      {"OFF BINARY\n3 1 0\n" + kBody, "binary OFF is not supported"},
      {"4OFF\n3 1 0\n" + kBody, "another dimension"},
      {"nOFF\n3\n3 1 0\n" + kBody, "another dimension"},
      {"OFF\n3 1 0\n0 0 0 9 9 9\n1 0 0\n0 1 0\n3 0 1 2\n", "vertex 0 has 6 numbers"},
      {"COFF\n3 1 0\n" + kBody, "vertex 0 has 3 numbers"},
      {"OFF\n3 1 0\n0 0  \n1 0 0\n0 1 0\n3 0 1 2\n", "line 3: the coordinate is missing"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1 \n", "line 6: face 0 has 2 corners"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n",
       "line 7: the file ends before corner 3 of face 0"},
      {"OFF\n", "the file ends before the counts"},
  };
  for (const auto& [text, expected] : cases) {
    EXPECT_TRUE(contains(refusal(text, "test.off"), expected))
        << refusal(text, "test.off") << "\nexpected: " << expected;
  }
}

}  // namespace
}  // namespace geodesic
