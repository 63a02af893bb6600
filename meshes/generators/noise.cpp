// Moves vertices at random.
#include <span>

#include "meshes/connectivity.h"
#include "meshes/generators/families.h"
#include "meshes/random.h"

namespace geodesic {
namespace {

/// Returns the mean length of undirected edges, each counted once.
double mean_edge_length(const TriangleSoup& soup) {
  double sum = 0;
  double count = 0;
  EdgeTable(soup).for_each_edge([&](std::span<const EdgeSide> sides) {
    sum += norm(subtract(soup.positions[sides[0].high], soup.positions[sides[0].low]));
    ++count;
  });
  return sum / count;
}

/// The sum of the normals of each vertex's faces, where a normal is as long as twice the area.
std::vector<Vec3> vertex_normals(const TriangleSoup& soup) {
  std::vector<Vec3> normals(soup.positions.size(), Vec3{});
  for (const Triangle& face : soup.triangles) {
    const Vec3& corner = soup.positions[face[0]];
    const Vec3 normal =
        cross(subtract(soup.positions[face[1]], corner), subtract(soup.positions[face[2]], corner));
    for (const Index v : face) normals[v] = add(normals[v], normal);
  }
  return normals;
}

TriangleSoup make_noise(const CheckedParameters& parameters) {
  TriangleSoup soup = read_input(parameters);
  const double amplitude = parameters.real("amplitude") * mean_edge_length(soup);
  const std::uint64_t seed = split_mix(parameters.integer("seed"));
  const std::vector<Vec3> normals = vertex_normals(soup);
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const double length = norm(normals[v]);
    if (!(length > 0)) continue;
    const double step = amplitude * to_signed_unit(split_mix(seed ^ v));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      soup.positions[v][axis] += step * (normals[v][axis] / length);
    }
  }
  return soup;
}

}  // namespace

Family noise() {
  return {{.name = "noise",
           .description = "a mesh whose vertices are moved at random along their normals; isolated "
                          "ones stay",
           .parameters = {input_parameter(),
                          real_parameter("amplitude", 0.1, 0, 1000,
                                         "farthest move by the mean edge length"),
                          integer_parameter("seed", 1, 0, kNone - 1, "of the random moves")}},
          make_noise};
}

}  // namespace geodesic
