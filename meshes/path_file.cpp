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

std::string to_json(std::span<const Path> paths) {
  std::string json = "{\"paths\":[";
  const char* before_path = "\n";
  for (const Path& path : paths) {
    append_text(json.append(before_path) += "{\"source\":", path.source);
    append_text(json += ",\"length\":", path.length());
    json += ",\"points\":[";
    const char* before_point = "\n ";
    for (const PathPoint& point : path.points) {
      append_point(json += before_point, point);
      before_point = ",\n ";
    }
    json += "]}";
    before_path = ",\n";
  }
  return json + "]}\n";
}

std::string to_obj(std::span<const Path> paths) {
  std::string text;
  std::uint64_t next = 1;
  for (const Path& path : paths) {
    for (const PathPoint& point : path.points) {
      text += 'v';
      for (const double coordinate : point.position) append_text(text += ' ', coordinate);
      text += '\n';
    }
    if (path.points.size() < 2) {
      ++next;
      continue;
    }
    text += 'l';
    for (std::size_t i = 0; i < path.points.size(); ++i) append_text(text += ' ', next++);
    text += '\n';
  }
  return text;
}

std::string to_ply(std::span<const Path> paths) {
  std::uint64_t points = 0;
  for (const Path& path : paths) points += path.points.size();
  if (points > std::numeric_limits<std::int32_t>::max()) {
    throw MeshError("the paths have " + std::to_string(points) +
                    " points, and a PLY file numbers 2147483647: write fewer paths, or JSON");
  }
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(points) +
                      "\nproperty double x\nproperty double y\nproperty double z\n"
                      "property double travelled\nelement edge " +
                      std::to_string(points - paths.size()) +
                      "\nproperty int vertex1\nproperty int vertex2\nproperty int path\n"
                      "end_header\n";
  for (const Path& path : paths) {
    for (const PathPoint& point : path.points) {
      for (const double coordinate : point.position) append_little_endian(bytes, coordinate);
      append_little_endian(bytes, point.travelled);
    }
  }
  std::int32_t next = 0;
  for (std::size_t p = 0; p < paths.size(); ++p, ++next) {
    for (std::size_t i = 1; i < paths[p].points.size(); ++i, ++next) {
      append_little_endian(bytes, next);
      append_little_endian(bytes, next + 1);
      append_little_endian(bytes, static_cast<std::int32_t>(p));
    }
  }
  return bytes;
}

}  // namespace

void check_path_file(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".json" || extension == ".obj" || extension == ".ply") return;
  throw MeshError("cannot write '" + file.string() + "': paths are written as .json, .obj or .ply");
}

std::string path_bytes(std::span<const Path> paths, const std::filesystem::path& file) {
  check_path_file(file);
  const std::string extension = lower_extension(file);
  if (extension == ".json") return to_json(paths);
  return extension == ".obj" ? to_obj(paths) : to_ply(paths);
}

}  // namespace geodesic
