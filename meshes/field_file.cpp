#include "meshes/field_file.h"

#include <cstdint>
#include <limits>
#include <stdexcept>

#include "meshes/formats/bytes.h"
#include "meshes/mesh_file.h"

namespace geodesic {
namespace {

// kNone becomes -1.
std::int32_t as_signed(Index number) { return static_cast<std::int32_t>(number); }

std::string vtk_bytes(const TriangleSoup& soup, std::span<const double> distances,
                      std::span<const Index> sources) {
  const std::string points = std::to_string(soup.positions.size());
  const std::size_t faces = soup.triangles.size();
  std::string bytes =
      "# vtk DataFile Version 3.0\ngeodesic distances\nBINARY\nDATASET POLYDATA\nPOINTS " + points +
      " double\n";
  for (const Vec3& point : soup.positions) {
    for (const double coordinate : point) append_big_endian(bytes, coordinate);
  }
  bytes += "\nPOLYGONS " + std::to_string(faces) + " " + std::to_string(4 * faces) + "\n";
  for (const Triangle& triangle : soup.triangles) {
    append_big_endian(bytes, std::int32_t{3});
    for (const Index v : triangle) append_big_endian(bytes, as_signed(v));
  }
  bytes += "\nPOINT_DATA " + points + "\nSCALARS distance double 1\nLOOKUP_TABLE default\n";
  for (const double distance : distances) append_big_endian(bytes, distance);
  if (!sources.empty()) bytes += "\nSCALARS source int 1\nLOOKUP_TABLE default\n";
  for (const Index source : sources) append_big_endian(bytes, as_signed(source));
  return bytes += '\n';
}

}  // namespace

bool has_field_extension(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  return extension == ".ply" || extension == ".vtk";
}

std::string field_bytes(const TriangleSoup& soup, std::span<const double> distances,
                        std::span<const Index> sources, const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& why) {
    throw MeshError("cannot write '" + file.string() + "': " + why);
  };
  if (!has_field_extension(file)) refuse("a mesh with distances is written as .ply or .vtk");
  const std::size_t vertices = soup.positions.size();
  const auto need = [&](std::size_t count, const std::string& kind) {
    if (count == vertices) return;
    throw std::invalid_argument("a mesh with distances needs one " + kind +
                                " a vertex: " + std::to_string(count) + " for " +
                                std::to_string(vertices) + " vertices");
  };
  need(distances.size(), "distance");
  if (!sources.empty()) need(sources.size(), "source");
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max() / 4;
  if (soup.positions.size() > kMost || soup.triangles.size() > kMost) {
    refuse("the format numbers elements with 31 bits");
  }
  return lower_extension(file) == ".ply" ? ply_bytes(soup, distances, sources)
                                         : vtk_bytes(soup, distances, sources);
}

std::string ply_bytes(const TriangleSoup& soup, std::span<const double> distances,
                      std::span<const Index> sources) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(soup.positions.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\n";
  if (!distances.empty()) bytes += "property double quality\n";
  if (!sources.empty()) bytes += "property int source\n";
  bytes += "element face " + std::to_string(soup.triangles.size()) +
           "\nproperty list uchar uint vertex_indices\nend_header\n";
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    for (const double coordinate : soup.positions[v]) append_little_endian(bytes, coordinate);
    if (!distances.empty()) append_little_endian(bytes, distances[v]);
    if (!sources.empty()) append_little_endian(bytes, as_signed(sources[v]));
  }
  for (const Triangle& triangle : soup.triangles) {
    bytes += '\3';
    for (const Index v : triangle) append_little_endian(bytes, v);
  }
  return bytes;
}

}  // namespace geodesic
