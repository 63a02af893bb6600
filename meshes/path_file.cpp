#include "meshes/path_file.h"

#include <limits>

#include "meshes/formats/bytes.h"
#include "meshes/mesh_file.h"

namespace geodesic {
namespace {

template <std::size_t n>
void append_list(std::string& text, const std::array<double, n>& numbers) {
  char before = '[';
  for (const double number : numbers) {
    text += before;
    append_text(text, number);
    before = ',';
  }
  text += ']';
}

void append_point(std::string& json, const PathPoint& point) {
  if (point.at.is_vertex()) {
    append_text(json += "{\"vertex\":", point.at.vertex);
  } else {
    append_text(json += "{\"face\":", point.at.face);
    append_list(json += ",\"weights\":", point.at.weights);
  }
  append_list(json += ",\"position\":", point.position);
  append_text(json += ",\"travelled\":", point.travelled);
  json += ",\"next_face\":";
  point.face == kNone ? void(json += "null") : append_text(json, point.face);
  json += '}';
}

// The kinds of lines, and in what their files differ.
struct Kind {
  const char *lines, *line, *at_vertex;
};
template <class Line>
constexpr Kind kKind{"paths", "path", "travelled"};
template <>
constexpr Kind kKind<Isoline>{"isolines", "isoline", "level"};

double at_vertex(const Path&, const PathPoint& point) { return point.travelled; }
double at_vertex(const Isoline& line, const PathPoint&) { return line.level; }

void append_head(std::string& json, const Path& path) {
  append_text(json += "\"source\":", path.source);
}
void append_head(std::string& json, const Isoline& line) {
  append_text(json += "\"level\":", line.level);
  json += line.closed ? ",\"closed\":true" : ",\"closed\":false";
}

void append_group(std::string&, const Path&) {}
void append_group(std::string& obj, const Isoline& line) {
  append_text(obj += "g ", line.level);
  obj += '\n';
}

// The points of a line that are vertices of a file: not the last one if it is the first one again.
std::span<const PathPoint> vertices_of(const Path& path) { return path.points; }
std::span<const PathPoint> vertices_of(const Isoline& line) {
  return std::span(line.points).first(line.points.size() - line.closed);
}

template <class Line>
std::string to_json(std::span<const Line> lines) {
  std::string json = std::string("{\"") + kKind<Line>.lines + "\":[";
  const char* before_line = "\n";
  for (const Line& line : lines) {
    append_head(json.append(before_line) += '{', line);
    append_text(json += ",\"length\":", line.length());
    json += ",\"points\":[";
    const char* before_point = "\n ";
    for (const PathPoint& point : line.points) {
      append_point(json += before_point, point);
      before_point = ",\n ";
    }
    json += "]}";
    before_line = ",\n";
  }
  return json + "]}\n";
}

template <class Line>
std::string to_obj(std::span<const Line> lines) {
  std::string text;
  std::uint64_t first = 1;
  for (const Line& line : lines) {
    const std::size_t vertices = vertices_of(line).size();
    append_group(text, line);
    for (const PathPoint& point : vertices_of(line)) {
      text += 'v';
      for (const double coordinate : point.position) append_text(text += ' ', coordinate);
      text += '\n';
    }
    if (line.points.size() > 1) {
      text += 'l';
      for (std::size_t i = 0; i < line.points.size(); ++i) {
        append_text(text += ' ', first + i % vertices);
      }
      text += '\n';
    }
    first += vertices;
  }
  return text;
}

template <class Line>
std::string to_ply(std::span<const Line> lines) {
  const Kind& kind = kKind<Line>;
  std::uint64_t vertices = 0, edges = 0;
  for (const Line& line : lines) {
    vertices += vertices_of(line).size();
    edges += line.points.size() - 1;
  }
  if (vertices > std::numeric_limits<std::int32_t>::max()) {
    throw MeshError(std::string("the ") + kind.lines + " have " + std::to_string(vertices) +
                    " points, and a PLY file numbers 2147483647: write fewer " + kind.lines +
                    ", or JSON");
  }
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertices) +
      "\nproperty double x\nproperty double y\nproperty double z\n"
      "property double " +
      kind.at_vertex + "\nelement edge " + std::to_string(edges) +
      "\nproperty int vertex1\nproperty int vertex2\nproperty int " + kind.line + "\nend_header\n";
  for (const Line& line : lines) {
    for (const PathPoint& point : vertices_of(line)) {
      for (const double coordinate : point.position) append_little_endian(bytes, coordinate);
      append_little_endian(bytes, at_vertex(line, point));
    }
  }
  std::int32_t first = 0;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const auto count = static_cast<std::int32_t>(vertices_of(lines[l]).size());
    for (std::int32_t i = 1; i < static_cast<std::int32_t>(lines[l].points.size()); ++i) {
      append_little_endian(bytes, first + i - 1);
      append_little_endian(bytes, first + i % count);
      append_little_endian(bytes, static_cast<std::int32_t>(l));
    }
    first += count;
  }
  return bytes;
}

template <class Line>
std::string bytes_of(std::span<const Line> lines, const std::filesystem::path& file) {
  check_path_file(file);
  const std::string extension = lower_extension(file);
  if (extension == ".json") return to_json(lines);
  return extension == ".obj" ? to_obj(lines) : to_ply(lines);
}

}  // namespace

void check_path_file(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".json" || extension == ".obj" || extension == ".ply") return;
  throw MeshError("cannot write '" + file.string() +
                  "': paths and isolines are written as .json, .obj or .ply");
}

std::string path_bytes(std::span<const Path> paths, const std::filesystem::path& file) {
  return bytes_of(paths, file);
}

std::string isoline_bytes(std::span<const Isoline> lines, const std::filesystem::path& file) {
  return bytes_of(lines, file);
}

}  // namespace geodesic
