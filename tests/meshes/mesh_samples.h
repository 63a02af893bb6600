// Small meshes in every format, and functions for the tests of this folder.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <string>
#include <string_view>

#include "meshes/formats/bytes.h"
#include "meshes/mesh_file.h"
#include "tests/message_of.h"

namespace geodesic {

/// A tetrahedron with outward faces.
inline TriangleSoup tetrahedron() {
  return {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// Random faces on few vertices. They have every defect at once.
inline TriangleSoup random_triangles(std::mt19937& random) {
  TriangleSoup soup;
  const std::size_t vertices = 4 + random() % 12;
  for (std::size_t v = 0; v < vertices; ++v) {
    soup.positions.push_back({static_cast<double>(random() % 4), static_cast<double>(random() % 4),
                              random() % 20 == 0 ? kInfinity : 1.0});
  }
  for (std::size_t f = 0; f < 4 + random() % 30; ++f) {
    const auto vertex = [&] { return static_cast<Index>(random() % (vertices + 1)); };
    soup.triangles.push_back({vertex(), vertex(), vertex()});
  }
  return soup;
}

inline const std::string kObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

inline const std::string kOff =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

/// Two faces that run along their common edge in the same direction.
inline const std::string kMisoriented = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n";

inline std::string ply_header(const std::string& format, const std::string& coordinate_type) {
  const std::string type = "property " + coordinate_type + " ";
  return "ply\nformat " + format + " 1.0\nelement vertex 4\n" + type + "x\n" + type + "y\n" + type +
         "z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
}

inline const std::string kPly = ply_header("ascii", "float") +
                                "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

/// The number's bytes in the given order.
template <class T>
std::string bytes_of(T number, std::endian order = std::endian::little) {
  std::string bytes(sizeof(T), '\0');
  store_little_endian(number, bytes.data());
  return order == std::endian::little ? bytes : std::string(bytes.rbegin(), bytes.rend());
}

/// @tparam T type of the coordinates, float or double
template <class T>
std::string binary_ply(std::endian order) {
  const TriangleSoup soup = tetrahedron();
  std::string bytes =
      ply_header(order == std::endian::little ? "binary_little_endian" : "binary_big_endian",
                 sizeof(T) == 4 ? "float" : "double");
  for (const Vec3& p : soup.positions) {
    for (const double c : p) bytes += bytes_of(static_cast<T>(c), order);
  }
  for (const Triangle& t : soup.triangles) {
    bytes += '\3';
    for (const Index v : t) bytes += bytes_of(v, order);
  }
  return bytes;
}

/// The tetrahedron as a binary OFF file. The colour of each face has `colours` numbers.
inline std::string binary_off(const std::string& header = "OFF BINARY\n", int colours = 0) {
  const TriangleSoup soup = tetrahedron();
  std::string bytes = header;
  const auto append = [&](auto number) { bytes += bytes_of(number, std::endian::big); };
  for (const std::int32_t count : {4, 4, 6}) append(count);
  for (const Vec3& p : soup.positions) {
    for (const double c : p) append(static_cast<float>(c));
  }
  for (const Triangle& t : soup.triangles) {
    append(std::int32_t{3});
    for (const Index v : t) append(v);
    append(std::int32_t{colours});
    for (int k = 0; k < colours; ++k) append(0.5f);
  }
  return bytes;
}

inline std::string ascii_stl() {
  const TriangleSoup soup = tetrahedron();
  std::string text = "solid tetrahedron\n";
  for (const Triangle& t : soup.triangles) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const Index v : t) {
      text += "  vertex";
      for (const double c : soup.positions[v]) text.append(" ").append(std::to_string(c));
      text += "\n";
    }
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

inline std::string binary_stl(const std::string& title) {
  const TriangleSoup soup = tetrahedron();
  std::string bytes = title + std::string(80 - title.size(), ' ');
  bytes += bytes_of(static_cast<std::uint32_t>(soup.triangles.size()));
  for (const Triangle& t : soup.triangles) {
    bytes += std::string(12, '\0');
    for (const Index v : t) {
      for (const double c : soup.positions[v]) bytes += bytes_of(static_cast<float>(c));
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

/// Expects that the bytes give the tetrahedron, without warnings.
inline MeshFile expect_tetrahedron(const std::string& bytes, const std::string& name,
                                   const std::string& format) {
  MeshFile file = parse_mesh(bytes, name);
  EXPECT_EQ(file.soup.positions, tetrahedron().positions) << format;
  EXPECT_EQ(file.soup.triangles, tetrahedron().triangles) << format;
  EXPECT_EQ(file.format, format);
  EXPECT_EQ(file.warnings, std::vector<std::string>{});
  return file;
}

inline bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// The message of the MeshError that reading the bytes throws.
inline std::string refusal(const std::string& bytes, const std::string& name) {
  return message_of<MeshError>([&] { parse_mesh(bytes, name); });
}

/// Expects that reading the bytes throws a message that contains `part`.
inline void expect_refusal(const std::string& bytes, const std::string& name,
                           const std::string& part) {
  const std::string message = refusal(bytes, name);
  EXPECT_TRUE(contains(message, part)) << message << "\nexpected: " << part;
}

}  // namespace geodesic
