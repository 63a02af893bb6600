// Functions and a fixture for the tests of generators.
#pragma once

#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "meshes/generators/generators.h"
#include "meshes/summary.h"
#include "solvers/core/geometry.h"
#include "tests/harness/temporary_folder.h"
#include "tests/message_of.h"

namespace geodesic {

/// An OFF file with the exact coordinates. Unlike the writer, it accepts any index and any number.
inline std::string off_text(const TriangleSoup& soup) {
  std::string text = "OFF\n" + std::to_string(soup.positions.size()) + " " +
                     std::to_string(soup.triangles.size()) + " 0\n";
  for (const auto& [x, y, z] : soup.positions) {
    char line[100];
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", x, y, z);
    text += line;
  }
  for (const auto& [a, b, c] : soup.triangles) {
    text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  return text;
}

/// Runs generators that read an input mesh.
class InputFiles : public harness::TemporaryFolder {
 protected:
  TriangleSoup made(const std::string& generator, const TriangleSoup& input,
                    GeneratorParameters parameters = {}) {
    parameters.insert_or_assign("input", write("input.off", off_text(input)).string());
    remarks_.clear();
    return generate(generator, parameters, &remarks_);
  }

  std::vector<std::string> remarks_;  // of the last call of made()
};

inline double area_of(const TriangleSoup& soup) {
  double sum = 0;
  for (const auto& [a, b, c] : soup.triangles) {
    const Vec3& corner = soup.positions[a];
    sum +=
        norm(cross(subtract(soup.positions[b], corner), subtract(soup.positions[c], corner))) / 2;
  }
  return sum;
}

/// Includes isolated vertices.
inline long euler_characteristic(const MeshSummary& summary) {
  return static_cast<long>(summary.vertices + summary.faces) - static_cast<long>(summary.edges);
}

/// Hash of a mesh: FNV-1a over the bytes of all coordinates and indices.
inline std::uint64_t hash_of(const TriangleSoup& soup) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&hash](const auto& element) {
    unsigned char bytes[sizeof element];
    std::memcpy(bytes, &element, sizeof element);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
  };
  for (const Vec3& position : soup.positions) add(position);
  for (const Triangle& face : soup.triangles) add(face);
  return hash;
}

/// The message with which a generator refuses the parameters.
inline std::string refusal(std::string_view generator, const GeneratorParameters& parameters) {
  return message_of<std::invalid_argument>([&] { generate(generator, parameters); });
}

inline void expect_same(const TriangleSoup& made, const TriangleSoup& expected) {
  EXPECT_EQ(made.positions, expected.positions);
  EXPECT_EQ(made.triangles, expected.triangles);
}

}  // namespace geodesic
