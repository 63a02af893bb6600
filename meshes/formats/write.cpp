#include "meshes/formats/write.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string>

#include "harness/base/atomic_file.h"
#include "harness/base/error.h"
#include "meshes/formats/bytes.h"

namespace geodesic::harness {
namespace {

// Independent of the locale, unlike streams.
template <class Number, class... Format>
void append(std::string& text, Number number, Format... format) {
  std::array<char, 40> digits;
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), number, format...);
  text.append(digits.data(), end);
}

void append_point(std::string& text, const Vec3& point) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (k > 0) text += ' ';
    append(text, point[k], std::chars_format::general, 17);
  }
  text += '\n';
}

void append_triangle(std::string& text, const Triangle& triangle, Index first_index) {
  for (const Index v : triangle) {
    text += ' ';
    append(text, v + first_index);
  }
  text += '\n';
}

std::string to_obj(const TriangleSoup& soup) {
  std::string text;
  for (const Vec3& point : soup.positions) append_point(text += "v ", point);
  for (const Triangle& triangle : soup.triangles) append_triangle(text += "f", triangle, 1);
  return text;
}

std::string to_off(const TriangleSoup& soup) {
  std::string text = "OFF\n" + std::to_string(soup.positions.size()) + " " +
                     std::to_string(soup.triangles.size()) + " 0\n";
  for (const Vec3& point : soup.positions) append_point(text, point);
  for (const Triangle& triangle : soup.triangles) append_triangle(text += "3", triangle, 0);
  return text;
}

std::string to_ply(const TriangleSoup& soup) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(soup.positions.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(soup.triangles.size()) +
                      "\nproperty list uchar uint vertex_indices\nend_header\n";
  for (const Vec3& point : soup.positions) {
    for (const double coordinate : point) append_little_endian(bytes, coordinate);
  }
  for (const Triangle& triangle : soup.triangles) {
    bytes += '\3';
    for (const Index v : triangle) append_little_endian(bytes, v);
  }
  return bytes;
}

}  // namespace

void write_mesh(const std::filesystem::path& path, const TriangleSoup& soup) {
  for (const Triangle& triangle : soup.triangles) {
    if (std::max({triangle[0], triangle[1], triangle[2]}) >= soup.positions.size()) {
      throw HarnessError("cannot write '" + path.string() +
                         "': a face names a vertex that is not there; repair the mesh first");
    }
  }
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::string bytes;
  if (extension == ".obj") {
    bytes = to_obj(soup);
  } else if (extension == ".off") {
    bytes = to_off(soup);
  } else if (extension == ".ply") {
    bytes = to_ply(soup);
  } else {
    throw HarnessError("cannot write '" + path.string() +
                       "': a mesh is written as .obj, .off or .ply");
  }
  write_bytes(path, bytes);
}

}  // namespace geodesic::harness
