#include <gtest/gtest.h>

#include "meshes/mesh_file.h"
#include "tests/meshes/mesh_samples.h"

namespace geodesic {
namespace {

const std::string kBody = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(Off, KeepsTheFilesVerticesAndFacesInOrder) {
  const MeshFile file = expect_tetrahedron(kOff, "test.off", "OFF");
  EXPECT_EQ(file.lines.vertices.front(), 3u);
  EXPECT_EQ(file.lines.triangles.front(), 7u);
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
                                                        {"NCOFF", " 0 0 1 1 0 0"},
                                                        {"STOFF", " 0.5 0.5"}}) {
    EXPECT_EQ(parse_mesh(keyword + vertices(extras) + face, "test.off").soup.positions[1],
              (Vec3{1, 0, 0}))
        << keyword << extras;
  }
}

TEST(Off, AHeaderMayAnnounceMoreThanTheVerticesHave) {
  for (const char* header : {"COFF", "NOFF", "STOFF", "4OFF", "CNOFF", "NCOFF", "STCNOFF"}) {
    const MeshFile file = parse_mesh(header + ("\n3 1 0\n" + kBody), "test.off");
    EXPECT_EQ(file.soup.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << header;
    EXPECT_EQ(file.soup.triangles, (std::vector<Triangle>{{0, 1, 2}})) << header;
    ASSERT_EQ(file.warnings.size(), 1u) << header;
    EXPECT_TRUE(contains(file.warnings[0], "but each has 3, its coordinates")) << header;
  }
}

TEST(Off, NormalsNeedNotBeNumbers) {
  for (const char* normal : {" nan inf -inf", " -nan(ind) 1e9999 none"}) {
    const std::string text = "NOFF\n3 1 0\n0 0 0" + std::string(normal) + "\n1 0 0 0 0 1\n0 1 0" +
                             normal + "\n3 0 1 2\n";
    EXPECT_EQ(parse_mesh(text, "test.off").soup.positions[2], (Vec3{0, 1, 0})) << normal;
  }
}

TEST(Off, NormalsOnLinesOfTheirOwnAreNotTakenForMissing) {
  const MeshFile file =
      parse_mesh("NOFF\n3 1 0\n0 0 0\n0 0 1\n1 0 0\n0 0 1\n0 1 0\n0 0 1\n3 0 1 2\n", "test.off");
  EXPECT_EQ(file.soup.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_TRUE(file.warnings.empty());
}

TEST(Off, AHeaderThatAnnouncesOtherNumbersThanTheLinesHaveIsNamed) {
  const auto with = [](const std::string& header, const std::string& extras) {
    return header + "\n3 1 0\n0 0 0" + extras + "\n1 0 0" + extras + "\n0 1 0" + extras +
           "\n3 0 1 2\n";
  };
  expect_refusal(
      with("OFF", " 255 0 0"), "a.off",
      "line 3: the header 'OFF' announces 3 numbers a vertex, but each has 6; correct it");
  expect_refusal(with("CNOFF", " 0 0 1"), "a.off",
                 "line 3: the header 'CNOFF' announces 10 numbers a vertex, but each has 6");
  expect_refusal(with("COFF", " 7"), "a.off", "announces 7 numbers a vertex, but each has 4");
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

TEST(Off, VerticesAndFacesMayShareLinesAndRunOverThem) {
  const std::vector<Triangle> two = {{0, 1, 2}, {0, 2, 1}};
  for (const char* text :
       {"OFF\n3 2 0\n0 0 0 1 0 0\n0 1 0\n3 0 1 2 3 0 2 1\n",
        "OFF\n3 2 0\n0 0 0 1 0 0 0 1 0 3 0 1 2 3 0 2 1\n",
        "OFF\n3 2 0\n0\n0 0 1 # a comment\n0 0 0 1\n0\n3 0 1\n2 3 0 2 1\n",
        "COFF\n3 2 0\n0 0 0 9 9 9 9 1 0 0 9 9 9 9\n0 1 0 9 9 9\n3 0 1 2\n3 0 2 1 0.5 0.5 0.5\n"}) {
    const MeshFile file = parse_mesh(text, "test.off");
    EXPECT_EQ(file.soup.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << text;
    EXPECT_EQ(file.soup.triangles, two) << text;
  }
  const MeshFile file = parse_mesh("OFF\n3 2 0\n0 0 0 1 0\n0 0 1 0\n3 0 1\n2 3 0 2 1\n", "a.off");
  EXPECT_EQ(file.lines.vertices, (std::vector<std::uint32_t>{3, 3, 4}));
  EXPECT_EQ(file.lines.triangles, (std::vector<std::uint32_t>{5, 6}));
}

TEST(Off, FourNumbersBehindAFaceAreItsColourWhereEveryFaceHasALine) {
  const std::string vertices = "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n";
  const std::vector<Triangle> two = {{0, 1, 2}, {0, 2, 1}};
  for (const char* faces :
       {"3 0 1 2 3 0 2 1\n3 0 2 1 3 0 1 2\n", "3 0 1 2 3 0 2 1\n", "3 0 1 2\n3 0 2 1 3 0 1 2\n"}) {
    EXPECT_EQ(parse_mesh(vertices + faces, "test.off").soup.triangles, two) << faces;
  }
}

TEST(Off, BinaryIsReadWithWhateverItsHeaderAnnounces) {
  for (const std::string& bytes :
       {binary_off(), binary_off("OFF BINARY # c\r\n"), binary_off("OFF BINARY\n", 1),
        binary_off("OFF BINARY\n", 4), binary_off() + "\n"}) {
    const MeshFile file = expect_tetrahedron(bytes, "test.off", "OFF binary");
    EXPECT_TRUE(file.lines.vertices.empty() && file.lines.triangles.empty());
  }
  for (const auto& [header, extras] :
       {std::pair{"NOFF", std::size_t{3}}, {"COFF", 4}, {"STOFF", 2}, {"STCNOFF", 9}}) {
    std::string bytes = binary_off(header + std::string(" BINARY\n"));
    const std::size_t first = bytes.size() - sizeof(float) * (4 * 3 + 4 * 5) + 12;
    for (std::size_t i = 4; i-- > 0;) bytes.insert(first + 12 * i, 4 * extras, '?');
    EXPECT_EQ(parse_mesh(bytes, "test.off").soup.positions, tetrahedron().positions) << header;
  }
}

TEST(Off, NamesTheByteOfWhatIsMalformedInBinary) {
  const auto with = [](std::size_t number,
                       char byte) {  // index of a 32-bit number, its new first byte
    return "OFF BINARY\n" + binary_off("").replace(4 * number, 1, 1, byte);
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"OFF BINARY", "byte 10: the file ends before the end of the counts"},
      {"OFF BINARY 4 4 6\n", "line 1: binary OFF has its counts on the next line"},
      {with(0, '\xff'), "byte 15: the number of vertices is negative"},
      {with(1, '\xff'), "byte 19: the number of faces is negative"},
      {with(0, '\1'), "byte 23: the header declares 16777220 vertices and 4 faces, but only 128"},
      {with(15, '\xff'), "byte 75: face 0 has -16777213 corners"},
      {with(15, '\1'), "byte 151: the file ends before the end of face 0 of 4"},
      {with(19, '\1'), "byte 111: face 0 has 16777216 numbers of a colour"},
      {with(34, '\xff'), "byte 151: face 3 has -16777216 numbers of a colour"},
      {binary_off() + "1234", "byte 151: 4 bytes more than the header's 4 vertices and 4 faces"},
  };
  for (const auto& [bytes, expected] : cases) expect_refusal(bytes, "test.off", expected);
}

TEST(Off, ACountThatTakesTheNextFaceIsNamedByItsLine) {
  const std::string text = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n4 0 2 1\n3 0 1 3\n";
  expect_refusal(text, "test.off", "(line 8 is the first that is not one vertex or one face");
}

TEST(Off, NamesTheLineOfWhatIsMalformed) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"OFF\n3 2 0\n" + kBody + "# end\n\n\n",
       "line 10: the file ends before the end of face 1 of 2"},
      {"OFF\n3 1 0\n" + kBody + "3 0 1 2\n", "line 7: more numbers than the header's 3 vertices"},
      {"OFF\n-3 1 0\n" + kBody, "the number of vertices is negative"},
      {"OFF\n3 x 0\n" + kBody, "the number of faces 'x' is not an integer"},
      {"OFF\n3 1 0 4\n" + kBody, "a header has three counts"},
      {"OFF\n3\n" + kBody, "the number of faces '' is not an integer"},
      {"4OFF\n3 1 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n", "another dimension"},
      {"4OFF BINARY\n" + binary_off(""), "another dimension"},
      {"TOFF\n3 1 0\n" + kBody, "line 1: unknown header 'TOFF'; it is [ST][C][N]OFF"},
      {"nOFF\n3\n3 1 0\n" + kBody, "another dimension"},
      {"OFF\n3 1 0\n0 0 0 9 9 9\n1 0 0\n0 1 0\n3 0 1 2\n",
       "line 5: face 0 has 0 corners and needs three; remove it and correct the count of faces "
       "(line 3 is the first that is not one vertex or one face; a header COFF announces colours"},
      {"COFF\n3 1 0\n0 0 0 9 9 9 9\n1 0 0\n0 1 0\n3 0 1 2\n",
       "before the end of vertex 2 of 3: it is truncated; get a whole copy "
       "(line 4 is the first that is not one vertex or one face"},
      {"OFF\n3 1 0\n0 0  \n1 0 0\n0 1 0\n3 0 1 2\n", "(line 3 is the first"},
      {"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0.5 0.5 0.5\n",
       "line 6: the number of corners '0.5' is not an integer, such as 12 (line 6 is the first"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 2 3 4 5\n", "face 0 has 5 numbers of a colour"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-2 0 1 \n", "line 6: face 0 has -2 corners"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n",
       "line 7: the file ends before the end of face 0 of 1"},
      {"OFF\n", "the file ends before the counts"},
  };
  for (const auto& [text, expected] : cases) expect_refusal(text, "test.off", expected);
}

}  // namespace
}  // namespace geodesic
