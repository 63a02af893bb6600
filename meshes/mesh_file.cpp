#include "meshes/mesh_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>

#include "meshes/connectivity.h"
#include "meshes/field_file.h"
#include "meshes/formats/parsing.h"

namespace geodesic {
namespace {

namespace fs = std::filesystem;
using Parser = MeshFile (*)(std::string_view bytes, const std::string& name);

// Returns whether the first bytes of a file include a byte that no text contains.
bool is_binary(std::string_view bytes) {
  constexpr std::size_t kLookedAt = 1024;
  const std::string_view head = bytes.substr(0, kLookedAt);
  return std::any_of(head.begin(), head.end(), [](char c) {
    constexpr std::string_view kControlsOfText = "\t\n\v\f\r";
    return static_cast<unsigned char>(c) < 0x20 &&
           kControlsOfText.find(c) == std::string_view::npos;
  });
}

std::string_view first_word(std::string_view bytes, const std::string& name) {
  TextReader reader(bytes, name, {.comment = '#'});
  return reader.word_across_lines();
}

bool is_off_keyword(std::string_view word) {
  const std::size_t off = word.find("OFF");
  return off != std::string_view::npos && off <= 6 &&
         word.substr(0, off).find_first_not_of("STCN4n") == std::string_view::npos;
}

void refuse_compressed(std::string_view bytes, const std::string& name) {
  for (const std::string_view magic : {"\x1f\x8b", "PK\x03\x04", "BZh",
                                       "\xfd"
                                       "7zXZ"}) {
    if (bytes.starts_with(magic)) {
      throw MeshError(name + ": a compressed file or archive; unpack it first");
    }
  }
}

[[noreturn]] void refuse_unknown(const std::string& name) {
  throw MeshError(name +
                  ": wrong format: the content is not OBJ, OFF, PLY or STL; convert it to one of "
                  "these or get a whole copy");
}

struct Recognised {
  Parser parser;
  std::string_view extension;  // extension of files of this format
};

Recognised recognise(std::string_view bytes, const std::string& name) {
  refuse_compressed(bytes, name);
  const std::string extension = lower_extension(name);
  if (has_size_of_binary_stl(bytes)) return {parse_stl_binary, ".stl"};
  const std::string_view word = first_word(bytes, name);
  if (word == "ply") return {parse_ply, ".ply"};
  if (is_off_keyword(word)) return {parse_off, ".off"};
  if (is_binary(bytes)) {
    if (extension == ".stl" || word == "solid") return {parse_stl_binary, ".stl"};
    refuse_unknown(name);
  }
  // Many binary STL files begin with "solid" as well; they were recognised by their size.
  if (word == "solid" || word == "SOLID") return {parse_stl_ascii, ".stl"};
  constexpr std::array<std::string_view, 9> kObjBegins = {"v", "vt", "vn",     "f",     "o",
                                                          "g", "s",  "mtllib", "usemtl"};
  const bool begins_as_obj = std::ranges::find(kObjBegins, word) != kObjBegins.end();
  if (begins_as_obj || extension == ".obj") return {parse_obj, ".obj"};
  refuse_unknown(name);
}

void append_point(std::string& text, const Vec3& point) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (k > 0) text += ' ';
    append_text(text, point[k], std::chars_format::general, 17);
  }
  text += '\n';
}

void append_triangle(std::string& text, const Triangle& triangle, Index first_index) {
  for (const Index v : triangle) {
    text += ' ';
    append_text(text, v + first_index);
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

}  // namespace

std::string lower_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::string read_bytes(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw MeshError(path.string() + ": no such file; check the path");
  if (!fs::is_regular_file(status)) {
    throw MeshError(path.string() + ": a folder, pipe or device; name a file");
  }
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  if (!stream) throw MeshError(path.string() + ": cannot be opened: " + std::strerror(errno));
  std::string bytes(static_cast<std::size_t>(stream.tellg()), '\0');
  stream.seekg(0);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    throw MeshError(path.string() + ": reading failed: " + std::strerror(errno));
  }
  return bytes;
}

MeshFile parse_mesh(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) throw MeshError(name + ": the file is empty (0 bytes); get a whole copy");
  if (!has_size_of_binary_stl(bytes)) bytes = text_of(bytes, name);  // its header is arbitrary
  const Recognised format = recognise(bytes, name);
  MeshFile file = format.parser(bytes, name);
  const std::string extension = lower_extension(name);
  if (!extension.empty() && extension != format.extension) {
    file.warnings.push_back("the content is " + file.format + ", not what the extension means");
  }
  if (file.soup.positions.empty()) {
    throw MeshError(name + ": empty mesh: no vertices; is it the right file?");
  }
  if (file.soup.triangles.empty()) {
    throw MeshError(name + ": empty mesh: no faces, so no surface to measure on");
  }
  if (file.soup.positions.size() >= kNone || file.soup.triangles.size() >= kNone / 3) {
    throw MeshError(name +
                    ": too large: vertices and sides of triangles are numbered with 32 bits");
  }
  return file;
}

bool has_mesh_extension(const fs::path& file) {
  const std::string extension = lower_extension(file);
  return extension == ".obj" || extension == ".off" || extension == ".ply" || extension == ".stl";
}

MeshFile read_mesh_file(const fs::path& path) {
  return parse_mesh(read_bytes(path), path.string());
}

std::string mesh_bytes(const TriangleSoup& soup, const std::filesystem::path& path) {
  if (!soup.left_out.empty()) return mesh_bytes(without_left_out(soup), path);
  const auto refuse = [&](const std::string& why) {
    throw MeshError("cannot write '" + path.string() + "': " + why);
  };
  for (const Triangle& triangle : soup.triangles) {
    if (std::ranges::max(triangle) >= soup.positions.size()) {
      refuse("a face refers to a vertex that does not exist; repair the mesh first");
    }
  }
  const std::string extension = lower_extension(path);
  if (extension == ".obj") return to_obj(soup);
  if (extension == ".off") return to_off(soup);
  if (extension != ".ply") refuse("a mesh is written as .obj, .off or .ply");
  return ply_bytes(soup);
}

}  // namespace geodesic
