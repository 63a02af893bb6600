#include <gtest/gtest.h>

#include "meshes/mesh_file.h"
#include "tests/meshes/mesh_samples.h"

namespace geodesic {
namespace {

TEST(Ply, ReadsEveryEncodingAndCoordinateType) {
  using enum std::endian;
  expect_tetrahedron(kPly, "test.ply", "PLY ASCII");
  expect_tetrahedron(binary_ply<float>(little), "test.ply", "PLY binary little-endian");
  expect_tetrahedron(binary_ply<double>(little), "test.ply", "PLY binary little-endian");
  expect_tetrahedron(binary_ply<float>(big), "test.ply", "PLY binary big-endian");
  expect_tetrahedron(binary_ply<double>(big), "test.ply", "PLY binary big-endian");
}

TEST(Ply, KeepsFullDoublePrecision) {
  const double fine = 0.1234567890123456;
  const std::string body = "0.1234567890123456 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n";
  const std::string faces = "3 1 2 3\n3 2 0 3\n";
  for (const char* type : {"float", "double"}) {  // ASCII: all digits count, whatever the type
    const MeshFile file = parse_mesh(ply_header("ascii", type) + body + faces, "test.ply");
    EXPECT_EQ(file.soup.positions[0][0], fine) << type;
  }
  std::string binary = binary_ply<double>(std::endian::big);
  const std::size_t first = ply_header("binary_big_endian", "double").size();
  binary.replace(first, 8, bytes_of(fine, std::endian::big));
  EXPECT_EQ(parse_mesh(binary, "test.ply").soup.positions[0][0], fine);
}

// A header with other properties beside the coordinates, other elements and other lists.
std::string rich_header(const std::string& format) {
  return "ply\r\nformat " + format +
         " 1.0\r\ncomment made by hand\r\nobj_info nothing\r\n"
         "element camera 1\r\nproperty list uchar short views\r\nproperty float fov\r\n"
         "element vertex 3\r\nproperty uchar red\r\nproperty double z\r\nproperty float y\r\n"
         "property list int ushort tags\r\nproperty int16 x\r\n"
         "element face 2\r\nproperty uchar flags\r\n"
         "property list uint8 uint32 vertex_index\r\nproperty list uchar float texcoord\r\n"
         "element edge 1\r\nproperty int vertex1\r\nproperty int vertex2\r\nend_header\r\n";
}

void expect_rich_mesh(const std::string& bytes) {
  const MeshFile file = parse_mesh(bytes, "test.ply");
  EXPECT_EQ(file.soup.positions, (std::vector<Vec3>{{0, 0, 0.5}, {7, 0, 0.5}, {0, -2, 0.5}}));
  EXPECT_EQ(file.soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 0}}));
}

TEST(Ply, WalksOverOtherPropertiesAndElements) {
  expect_rich_mesh(rich_header("ascii") +
                   "2 4 5 0.9\n9 0.5 0 0 0\n9 0.5 0 2 1 2 7\n9 0.5 -2 1 5 0\n"
                   "0 3 0 1 2 0\n1 3 2 1 0 2 0.5 0.5\n0 1\n");
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const bool little = order == std::endian::little;
    const auto put = [&](auto number) { return bytes_of(number, order); };
    const auto vertex = [&](std::int16_t x, float y, const std::string& tags) {
      return std::string(1, '\t') + put(0.5) + put(y) + tags + put(x);
    };
    const std::uint16_t tag = 1;
    const auto corners = [&](Index a, Index b, Index c) {
      return std::string(1, '\3') + put(a) + put(b) + put(c);
    };
    expect_rich_mesh(rich_header(little ? "binary_little_endian" : "binary_big_endian") +
                     std::string(1, '\1') + put(std::int16_t{4}) + put(0.9f) +
                     vertex(0, 0, put(std::int32_t{0})) +
                     vertex(7, 0, put(std::int32_t{2}) + put(tag) + put(tag)) +
                     vertex(0, -2, put(std::int32_t{0})) + std::string(1, '\0') + corners(0, 1, 2) +
                     std::string(2, '\0') + corners(2, 1, 0) + std::string(1, '\1') + put(0.5f) +
                     put(std::int32_t{0}) + put(std::int32_t{1}));
  }
}

TEST(Ply, TheFirstLineMayEndWithBlanks) {
  for (const char* first : {"ply \n", "ply\t\r\n", "ply \r"}) {
    expect_tetrahedron(first + kPly.substr(4), "test.ply", "PLY ASCII");
  }
  const std::string binary = binary_ply<float>(std::endian::little);
  expect_tetrahedron("ply \n" + binary.substr(4), "test.ply", "PLY binary little-endian");
  expect_refusal("ply wood\n" + kPly.substr(4), "a.ply",
                 "line 1: expected a line with the word 'ply'");
}

TEST(Ply, ReadsIntegersOf64BitsInEveryRole) {
  for (const std::string sign : {"", "u"}) {
    const std::string type = sign + "int64";
    const std::string elements = "property float x\nproperty float y\nproperty float z\nproperty " +
                                 type + " label\nelement face 1\nproperty list " + type + " " +
                                 type + " vertex_indices\nend_header\n";
    const auto header = [&](const std::string& format) {
      return "ply\nformat " + format + " 1.0\nelement vertex 3\n" + elements;
    };
    EXPECT_EQ(parse_mesh(header("ascii") + "0 0 0 7\n1 0 0 7\n0 1 0 7\n3 0 1 2\n", "a.ply")
                  .soup.triangles,
              (std::vector<Triangle>{{0, 1, 2}}));
    std::string binary = header("binary_big_endian");
    for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
      for (const double c : p) binary += bytes_of(static_cast<float>(c), std::endian::big);
      binary += std::string(8, '\xff');
    }
    for (const std::uint64_t n : {3U, 0U, 1U}) binary += bytes_of(n, std::endian::big);
    // The greatest uint64 and the int64 -1 are indices out of range.
    EXPECT_EQ(parse_mesh(binary + std::string(8, '\xff'), "a.ply").soup.triangles,
              (std::vector<Triangle>{{0, 1, kNone}}));
    EXPECT_EQ(
        parse_mesh(binary + bytes_of(std::uint64_t{2}, std::endian::big), "a.ply").soup.triangles,
        (std::vector<Triangle>{{0, 1, 2}}));
  }
}

TEST(Ply, ValuesThatAreNotUsedNeedNotBeNumbers) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nproperty float nx\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 ";
  EXPECT_EQ(
      parse_mesh(text + "nan\n1 0 0 -1.#IND\n0 1 0 inf\n3 0 1 2\n", "a.ply").soup.positions[2],
      (Vec3{0, 1, 0}));
  expect_refusal(text + "nan\n1 0 0\n0 1 0 inf\n3 0 1 2\n", "a.ply",
                 "line 12: the value is missing");
}

TEST(Ply, TakesNegativeIndicesAsOutOfRange) {
  const std::string text = ply_header("ascii", "float") +
                           "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 -1\n3 1 2 3\n3 2 0 3\n";
  EXPECT_EQ(parse_mesh(text, "test.ply").soup.triangles[1][2], kNone);
}

// A header of five vertices and of lists of triangle strips.
std::string strip_header(const std::string& format, std::size_t lists,
                         const std::string& types = "int int") {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
         "element tristrips " +
         std::to_string(lists) + "\nproperty list " + types + " vertex_indices\nend_header\n";
}

const std::string kStripVertices = "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n";

std::vector<Triangle> strip_triangles(const std::string& lists, std::size_t count) {
  return parse_mesh(strip_header("ascii", count) + kStripVertices + lists, "strips.ply")
      .soup.triangles;
}

TEST(Ply, TurnsEverySecondTriangleOfAStrip) {
  EXPECT_EQ(strip_triangles("5 0 1 2 3 4\n", 1),
            (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
}

TEST(Ply, StartsANewStripAtMinusOneAndAtEachList) {
  const std::vector<Triangle> expected = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 1}};
  EXPECT_EQ(strip_triangles("9 0 1 2 3 -1 2 3 4 1\n", 1), expected);
  EXPECT_EQ(strip_triangles("11 0 1 2 3 -1 -1 2 3 4 1 -1\n", 1), expected) << "empty strips";
  EXPECT_EQ(strip_triangles("4 0 1 2 3\n0\n4 2 3 4 1\n", 3), expected);
}

TEST(Ply, LeavesOutTheJointsOfStripsAndSaysSo) {
  const MeshFile file =
      parse_mesh(strip_header("ascii", 1) + kStripVertices + "7 0 1 2 2 3 3 4\n", "strips.ply");
  EXPECT_EQ(file.soup.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(
      file.warnings,
      (std::vector<std::string>{"4 triangles of strips name a vertex twice and are left out"}));
}

TEST(Ply, ReadsStripsInEveryEncodingBesideFaces) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const std::string format =
        order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
    std::string bytes = strip_header(format, 1, "uchar short");
    bytes.replace(bytes.find("end_header"), 0,
                  "element face 1\nproperty list uchar uchar vertex_index\n");
    for (const int c : {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0}) {
      bytes += bytes_of(static_cast<float>(c), order);
    }
    bytes += '\5';
    for (const int v : {0, 1, 2, -1, -1}) bytes += bytes_of(static_cast<std::int16_t>(v), order);
    bytes += std::string("\3\2\1\3", 4);
    EXPECT_EQ(parse_mesh(bytes, "strips.ply").soup.triangles,
              (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}))
        << format;
  }
}

TEST(Ply, KeepsIndicesOutOfRangeOfStripsAsDefects) {
  EXPECT_EQ(strip_triangles("5 0 1 2 9 -2\n", 1),
            (std::vector<Triangle>{{0, 1, 2}, {2, 1, 9}, {2, 9, kNone}}));
  EXPECT_EQ(strip_triangles("3 -2 -2 1\n", 1), (std::vector<Triangle>{{kNone, kNone, 1}}));
}

TEST(Ply, AStripOfFewerThanThreeVerticesIsAFaceThatRepeatsItsLast) {
  EXPECT_EQ(strip_triangles("2 0 1\n", 1), (std::vector<Triangle>{{0, 1, 1}}));
  EXPECT_EQ(strip_triangles("7 0 1 2 -1 4 -1 3\n", 1),
            (std::vector<Triangle>{{0, 1, 2}, {4, 4, 4}, {3, 3, 3}}));
}

TEST(Ply, RefusesStripsThatAreCutOff) {
  const std::string ascii = strip_header("ascii", 1) + kStripVertices;
  expect_refusal(ascii + "5 0 1 2\n", "a.ply", "line 15: the value is missing");
  expect_refusal(ascii + "-5 0 1 2\n", "a.ply", "has a negative length");
  expect_refusal(ascii + "0\n", "a.ply", "no faces");
  const std::string binary = strip_header("binary_little_endian", 1, "uint int") +
                             std::string(60, '\0') + bytes_of(std::uint32_t{4000000000}) +
                             std::string(24, '\0');
  expect_refusal(binary, "a.ply", "the file ends inside element 0 of 'tristrips'");
  expect_refusal(strip_header("ascii", 4000000000) + kStripVertices, "a.ply",
                 "4000000000 times 'tristrips'");
}

TEST(Ply, RefusesHeadersThatHoldNoSurface) {
  const auto header = [](const std::string& elements) {
    return "ply\nformat ascii 1.0\n" + elements + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  };
  const std::string vertex =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {header(vertex), "no element 'face'"},
      {header(face), "no element 'vertex'"},
      {header("element vertex 3\nproperty float x\nproperty float y\n" + face),
       "the property 'z' of 'vertex' is missing"},
      {header(vertex + "element face 1\nproperty int vertex_indices\n"), "is not a list"},
      {header(vertex + "element face 1\nproperty list uchar float vertex_indices\n"),
       "has real numbers"},
      {header(vertex + "element face 1\nproperty list float int vertex_indices\n"),
       "counted with integers"},
      {header("property float x\n" + vertex + face), "line 3: a property before the first element"},
      {header(vertex + vertex + face), "two elements 'vertex'"},
      {header(vertex + "element face 4294967296\nproperty list uchar int vertex_indices\n"),
       "more than can be numbered"},
      {header(vertex + face + "element spare 7\n"), "'spare' has no properties"},
      {header("element vertex 3\nproperty colour x\n" + face), "unknown type 'colour'"},
      {header("element vertex 3\nproperty float128 x\n" + face),
       "line 4: unknown type 'float128' of a property; there are (u)char,"},
      {header("element vertex 3\nproperty half x\n" + face), "unknown type 'half'"},
      {header("elements vertex 3\n"), "unknown statement 'elements'"},
      {"ply\nformat ascii 2.0\n", "version '2.0'"},
      {"ply\nformat binary 1.0\n", "unknown encoding 'binary'"},
      {"ply\nformat ascii 1.0\n" + vertex, "the file ends before 'end_header'"},
  };
  for (const auto& [text, expected] : cases) expect_refusal(text, "test.ply", expected);
}

TEST(Ply, SaysOfTextThatEndsTooEarlyThatItIsTruncated) {
  const std::string vertices =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1.0000 0.0000 0.0000\n";  // with as many bytes as three short lines
  expect_refusal(vertices, "a.ply", "the file ends before element 2 of 'vertex': it is truncated");
}

TEST(Ply, RefusesMoreDataThanTheHeaderCounts) {
  expect_refusal(kPly + "3 0 1 2\n", "a.ply", "more lines than the header");
  const std::string binary = binary_ply<float>(std::endian::little);
  expect_refusal(binary + "123", "a.ply", "3 bytes behind the last element");
  expect_tetrahedron(binary + "\r\n", "a.ply", "PLY binary little-endian");
}

}  // namespace
}  // namespace geodesic
