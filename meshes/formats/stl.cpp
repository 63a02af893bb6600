// STL, ASCII and binary. The format repeats a corner's coordinates in every triangle. Corners with
// equal coordinates become one vertex, numbered by first appearance.
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "meshes/formats/parsing.h"
#include "meshes/random.h"

namespace geodesic {
namespace {

// A binary file has 80 arbitrary bytes, a count, and 50 bytes per triangle (normal, three corners,
// attribute).
constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kNormalBytes = 12;
constexpr std::size_t kCoordinateBytes = 4;

std::uint32_t triangle_count(std::string_view bytes) {
  return load_number<std::uint32_t>(bytes.data() + 80, std::endian::little);
}

// Numbers points by first appearance. Points are compared by bits, so that a NaN equals itself.
class PointJoiner {
 public:
  explicit PointJoiner(std::vector<Vec3>& positions) : positions_(positions) {}

  Index id(Vec3 point) {
    for (double& c : point) c += 0.0;  // -0 and 0 are the same coordinate
    const auto [found, added] =
        ids_.try_emplace(std::bit_cast<Bits>(point), static_cast<Index>(positions_.size()));
    if (added) positions_.push_back(point);
    return found->second;
  }

 private:
  using Bits = std::array<std::uint64_t, 3>;
  struct Hash {
    std::size_t operator()(const Bits& bits) const {
      std::uint64_t hash = 0;
      for (const std::uint64_t b : bits) hash = split_mix(hash ^ b);
      return hash;
    }
  };

  std::vector<Vec3>& positions_;
  std::unordered_map<Bits, Index, Hash> ids_;
};

bool same_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  });
}

class AsciiStlParser {
 public:
  AsciiStlParser(std::string_view text, const std::string& name)
      : reader_(text, name), joiner_(file_.soup.positions) {
    file_.format = "STL ASCII";
  }

  // Parses one or more of: solid [name], facets, endsolid [name].
  MeshFile parse() {
    while (reader_.next_line()) {
      expect("solid");
      read_solid();
    }
    return std::move(file_);
  }

 private:
  void read_solid() {
    if (!reader_.next_line()) reader_.fail_truncated("'endsolid'");
    while (true) {
      const std::string word = keyword("'endsolid'");
      if (same_ignoring_case(word, "endsolid")) return;
      if (!same_ignoring_case(word, "facet")) {
        reader_.fail("expected 'facet' or 'endsolid', found " + in_quotes(word));
      }
      read_facet();
    }
  }

  void read_facet() {
    const std::uint32_t line = reader_.line();
    expect("normal");
    std::string word = keyword("'outer'");
    for (int k = 0; k < 3 && !same_ignoring_case(word, "outer"); ++k) word = keyword("'outer'");
    require(word, "outer");
    expect("loop");
    Triangle triangle;
    for (Index& corner : triangle) {
      expect("vertex");
      const std::uint32_t vertex_line = reader_.line();
      Vec3 point;
      for (double& c : point) c = coordinate();
      corner = joiner_.id(point);
      if (file_.lines.vertices.size() < file_.soup.positions.size()) {
        file_.lines.vertices.push_back(vertex_line);
      }
    }
    expect("endloop");
    expect("endfacet");
    file_.soup.triangles.push_back(triangle);
    file_.lines.triangles.push_back(line);
  }

  double coordinate() {
    const std::string_view word = reader_.word_across_lines();
    if (word.empty()) reader_.fail_truncated("a coordinate");
    return reader_.to_number(word, "coordinate");
  }

  // The next word; some writers put a blank into "endsolid", "endloop" and "endfacet".
  // @param expected for the message when the file ends
  std::string keyword(const std::string& expected) {
    std::string word(reader_.word_across_lines());
    if (same_ignoring_case(word, "end")) word += reader_.word_across_lines();
    if (word.empty()) reader_.fail_truncated(expected);
    return word;
  }

  void require(const std::string& found, const std::string& expected) const {
    if (same_ignoring_case(found, expected)) return;
    reader_.fail("expected '" + expected + "', found " + in_quotes(found));
  }

  void expect(const std::string& expected) { require(keyword("'" + expected + "'"), expected); }

  TextReader reader_;
  MeshFile file_;
  PointJoiner joiner_;
};

}  // namespace

bool has_size_of_binary_stl(std::string_view bytes) {
  return bytes.size() >= kHeaderBytes &&
         bytes.size() == kHeaderBytes + kTriangleBytes * std::size_t{triangle_count(bytes)};
}

MeshFile parse_stl_ascii(std::string_view text, const std::string& name) {
  return AsciiStlParser(text, name).parse();
}

MeshFile parse_stl_binary(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kHeaderBytes) {
    throw MeshError(name + ", byte " + std::to_string(bytes.size()) + ": a binary STL file has " +
                    std::to_string(kHeaderBytes) +
                    " bytes before its first triangle: the file is truncated or not STL");
  }
  if (!has_size_of_binary_stl(bytes)) {
    const std::size_t present = (bytes.size() - kHeaderBytes) / kTriangleBytes;
    throw MeshError(name + ", byte 80: a binary STL header declares " +
                    std::to_string(triangle_count(bytes)) + " triangles, but the file has " +
                    std::to_string(bytes.size()) + " bytes, which is " + std::to_string(present) +
                    " triangles: it is truncated, damaged or not STL; get a whole copy");
  }
  MeshFile file;
  file.format = "STL binary";
  PointJoiner joiner(file.soup.positions);
  file.soup.triangles.resize(triangle_count(bytes));
  const char* at = bytes.data() + kHeaderBytes;
  for (Triangle& triangle : file.soup.triangles) {
    const char* coordinate = at + kNormalBytes;
    for (Index& corner : triangle) {
      Vec3 point;
      for (double& c : point) {
        c = load_number<float>(coordinate, std::endian::little);
        coordinate += kCoordinateBytes;
      }
      corner = joiner.id(point);
    }
    at += kTriangleBytes;
  }
  return file;
}

}  // namespace geodesic
