#include <gtest/gtest.h>

#include <limits>

#include "meshes/mesh_file.h"
#include "tests/meshes/mesh_samples.h"

namespace geodesic {
namespace {

// Vertices are numbered by first appearance: the tetrahedron's corners in the order 0, 2, 1, 3.
void expect_joined_tetrahedron(const std::string& bytes, const std::string& format) {
  const MeshFile file = parse_mesh(bytes, "test.stl");
  EXPECT_EQ(file.soup.positions, (std::vector<Vec3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(file.soup.triangles,
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 3}}));
  EXPECT_EQ(file.format, format);
}

TEST(Stl, JoinsEqualCornersByFirstAppearance) {
  expect_joined_tetrahedron(ascii_stl(), "STL ASCII");
  expect_joined_tetrahedron(binary_stl("made by hand"), "STL binary");
}

TEST(Stl, RecognisesBinaryFilesThatBeginWithSolid) {
  expect_joined_tetrahedron(binary_stl("solid tetrahedron"), "STL binary");
}

TEST(Stl, ReadsSeveralSolidsAndCapitals) {
  const MeshFile twice = parse_mesh(ascii_stl() + "\n" + ascii_stl(), "test.stl");
  EXPECT_EQ(twice.soup.positions.size(), 4u);
  EXPECT_EQ(twice.soup.triangles.size(), 8u);
  std::string capitals = ascii_stl();
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  expect_joined_tetrahedron(capitals, "STL ASCII");
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

TEST(Stl, TheEndsOfPartsMayHaveABlank) {
  expect_joined_tetrahedron(replace_all(ascii_stl(), "end", "end "), "STL ASCII");
  expect_joined_tetrahedron(replace_all(ascii_stl(), "end", "END  "), "STL ASCII");
}

TEST(Stl, NormalsAreNotUsed) {
  for (const char* normal : {" nan nan nan", " -1.#IND -1.#IND 1.#QNAN", " inf -inf 1e9999",
                             " -nan(ind) 0 0", " 0 0", ""}) {
    expect_joined_tetrahedron(
        replace_all(ascii_stl(), "normal 0 0 0", std::string("normal") + normal), "STL ASCII");
  }
}

TEST(Stl, KeepsFullDoublePrecisionOfAsciiFiles) {
  std::string text = ascii_stl();
  text.replace(text.find("0.000000 1.000000"), 17, "0.1234567890123456 1");
  EXPECT_EQ(parse_mesh(text, "test.stl").soup.positions[1], (Vec3{0.1234567890123456, 1, 0}));
}

TEST(Stl, JoinsZeroWithMinusZeroAndNotANumberWithItself) {
  const auto facet = [](const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal 0 0 0 outer loop vertex " + a + " vertex " + b + " vertex " + c +
           " endloop endfacet\n";
  };
  const MeshFile file = parse_mesh("solid\n" + facet("0 0 0", "nan 0 0", "0 1 0") +
                                       facet("-0 0 -0", "nan 0 0", "0 0 1") + "endsolid\n",
                                   "test.stl");
  EXPECT_EQ(file.soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}}));
}

TEST(Stl, JoinsManyCornersAsOneByOneComparisonWould) {
  // A strip of triangles, with one new corner per triangle. The table of corners grows often.
  constexpr Index kTriangles = 5000;
  std::string text = "solid\n";
  const auto vertex = [](Index i) {
    return " vertex " + std::to_string(i / 2) + " " + std::to_string(i % 2) + " 0";
  };
  for (Index i = 0; i < kTriangles; ++i) {
    text += "facet normal 0 0 1 outer loop" + vertex(i) + vertex(i + 1) + vertex(i + 2) +
            " endloop endfacet\n";
  }
  const MeshFile file = parse_mesh(text + "endsolid\n", "test.stl");
  ASSERT_EQ(file.soup.positions.size(), kTriangles + 2);
  for (Index i = 0; i < kTriangles; ++i) {
    ASSERT_EQ(file.soup.triangles[i], (Triangle{i, i + 1, i + 2}));
  }
}

TEST(Stl, RefusesSizesThatDoNotFitTheCount) {
  const std::string bytes = binary_stl("binary");
  expect_refusal(bytes + "1", "a.stl", "declares 4 triangles, but the file has 285");
  expect_refusal(bytes.substr(0, 200), "a.stl", "which is 2 triangles");
  expect_refusal(binary_stl("solid").substr(0, 200), "a.stl", "truncated");
}

TEST(Stl, NamesTheLineOfWhatIsMalformed) {
  std::string four_corners = ascii_stl();
  four_corners.insert(four_corners.find(" endloop"), "  vertex 5 5 5\n");
  EXPECT_EQ(refusal(four_corners, "a.stl"), "a.stl, line 7: expected 'endloop', found 'vertex'");
  expect_refusal("solid\nfacet normal 0 0 0 0\nouter loop\n", "a.stl",
                 "line 2: expected 'outer', found '0'");
  std::string without_outer = ascii_stl();
  without_outer.erase(without_outer.find("outer loop"), 10);
  expect_refusal(without_outer, "a.stl", "line 4: expected 'outer', found 'vertex'");
  std::string end_of_another = ascii_stl();
  end_of_another.replace(end_of_another.find("endfacet"), 8, "end loop");
  expect_refusal(end_of_another, "a.stl", "line 8: expected 'endfacet', found 'endloop'");
  expect_refusal("solid a\nendsolid\n", "a.stl", "empty mesh");
}

}  // namespace
}  // namespace geodesic
