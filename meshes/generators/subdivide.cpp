// Meshes made from another mesh: its faces cut into smaller ones, or its vertices moved at random.
//
// Any triangles are taken: an edge is determined by its two vertices, not by the direction and the
// number of its faces, and an isolated vertex stays as it is. Old vertices keep their ids.
#include <cmath>
#include <span>
#include <utility>

#include "meshes/connectivity.h"
#include "meshes/generators/families.h"
#include "meshes/random.h"

namespace geodesic {
namespace {

Vec3 middle_of(const TriangleSoup& soup, std::span<const EdgeSide> sides) {
  return scale(0.5, add(soup.positions[sides[0].low], soup.positions[sides[0].high]));
}

/// The old vertices and a new one for every edge.
struct WithEdgeVertices {
  std::vector<Vec3> positions;
  std::vector<Index> vertex_on;  // entry h is the new vertex on half-edge h
};

/// @param on_edge the position of the new vertex of an edge, given its sides
/// @param spare number of positions to leave room for
template <typename OnEdge>
WithEdgeVertices add_edge_vertices(const TriangleSoup& soup, const EdgeTable& edges, OnEdge on_edge,
                                   std::size_t spare = 0) {
  WithEdgeVertices result;
  // A closed surface has 3 edges for 2 faces.
  result.positions.reserve(soup.positions.size() + 3 * soup.triangles.size() / 2 + spare);
  result.positions.assign(soup.positions.begin(), soup.positions.end());
  result.vertex_on.resize(3 * soup.triangles.size());
  edges.for_each_edge([&](std::span<const EdgeSide> sides) {
    const auto vertex = static_cast<Index>(result.positions.size());
    for (const EdgeSide& side : sides) result.vertex_on[side.half_edge] = vertex;
    result.positions.push_back(on_edge(sides));
  });
  return result;
}

/// Cuts every face in four; the new vertex of an edge lies at `on_edge(sides)`.
template <typename OnEdge>
TriangleSoup quarter(const TriangleSoup& soup, const EdgeTable& edges, OnEdge on_edge) {
  WithEdgeVertices added = add_edge_vertices(soup, edges, on_edge);
  TriangleSoup result{.positions = std::move(added.positions), .triangles = {}};
  result.triangles.reserve(4 * soup.triangles.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const auto& [a, b, c] = soup.triangles[f];
    const Index ab = added.vertex_on[3 * f];
    const Index bc = added.vertex_on[3 * f + 1];
    const Index ca = added.vertex_on[3 * f + 2];
    result.triangles.insert(result.triangles.end(),
                            {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return result;
}

/// The quantities of an old vertex's edges that Loop's rule uses.
struct Surroundings {
  Vec3 neighbours = {};     // the sum of their positions
  Vec3 along_creases = {};  // of those at the other ends of creases
  Index valence = 0;
  Index creases = 0;
};

bool is_crease(std::span<const EdgeSide> sides) { return sides.size() != 2; }

std::vector<Surroundings> look_around(const TriangleSoup& soup, const EdgeTable& edges) {
  std::vector<Surroundings> around(soup.positions.size());
  edges.for_each_edge([&](std::span<const EdgeSide> sides) {
    const auto meet = [&](Surroundings& at, Index other) {
      at.neighbours = add(at.neighbours, soup.positions[other]);
      ++at.valence;
      if (!is_crease(sides)) return;
      at.along_creases = add(at.along_creases, soup.positions[other]);
      ++at.creases;
    };
    meet(around[sides[0].low], sides[0].high);
    meet(around[sides[0].high], sides[0].low);
  });
  return around;
}

/// Loop's weight of each neighbour of an inner vertex.
double neighbour_weight(Index valence) {
  const double inner = 0.375 + circle_point(1.0 / valence).cosine / 4;
  return (0.625 - inner * inner) / valence;
}

// Sums start at 0, so that no coordinate is a negative zero.
Vec3 weighted_sum(double weight_a, const Vec3& a, double weight_b, const Vec3& b) {
  return add(add(Vec3{}, scale(weight_a, a)), scale(weight_b, b));
}

Vec3 smoothed(const Vec3& position, const Surroundings& at) {
  if (at.valence > 0 && at.creases == 0) {
    const double weight = neighbour_weight(at.valence);
    return weighted_sum(1 - at.valence * weight, position, weight, at.neighbours);
  }
  if (at.creases != 2) return position;
  return weighted_sum(0.75, position, 0.125, at.along_creases);
}

/// Four faces from one, with a new vertex in the middle of every edge; the surface stays the same.
/// Face f becomes the faces 4 f to 4 f + 3, at its three corners and in its middle; the new
/// vertices are in order of the ids of their edges' ends, the smaller first.
TriangleSoup subdivide_midpoint(const TriangleSoup& soup) {
  check_face_count(4.0 * static_cast<double>(soup.triangles.size()));
  return quarter(soup, EdgeTable(soup),
                 [&](std::span<const EdgeSide> sides) { return middle_of(soup, sides); });
}

/// The faces of subdivide_midpoint with the positions of Loop 1987, "Smooth subdivision surfaces
/// based on triangles". Edges of one face (boundaries) and of three or more are creases that become
/// a cubic B-spline curve; a vertex with one crease or more than two stays where it is.
TriangleSoup subdivide_loop(const TriangleSoup& soup) {
  check_face_count(4.0 * static_cast<double>(soup.triangles.size()));
  const EdgeTable edges(soup);
  TriangleSoup result = quarter(soup, edges, [&](std::span<const EdgeSide> sides) {
    if (is_crease(sides)) return middle_of(soup, sides);
    Vec3 point =
        weighted_sum(0.375, soup.positions[sides[0].low], 0.375, soup.positions[sides[0].high]);
    for (const EdgeSide& side : sides) {
      const Index across = previous_in_face(side.half_edge);
      point = add(point, scale(0.125, soup.positions[origin_of(soup.triangles, across)]));
    }
    return point;
  });
  const std::vector<Surroundings> around = look_around(soup, edges);
  for (std::size_t v = 0; v < around.size(); ++v) {
    result.positions[v] = smoothed(soup.positions[v], around[v]);
  }
  return result;
}

/// Six faces from one: the barycentric subdivision, with a new vertex in the middle of every edge,
/// numbered as by subdivide_midpoint, and then one at the centroid of every face, in their order;
/// the surface stays the same. Face f becomes the faces 6 f to 6 f + 5, around its centroid.
TriangleSoup subdivide_barycentric(const TriangleSoup& soup) {
  check_face_count(6.0 * static_cast<double>(soup.triangles.size()));
  WithEdgeVertices added = add_edge_vertices(
      soup, EdgeTable(soup),
      [&](std::span<const EdgeSide> sides) { return middle_of(soup, sides); },
      soup.triangles.size());
  TriangleSoup result{.positions = std::move(added.positions), .triangles = {}};
  result.triangles.reserve(6 * soup.triangles.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& face = soup.triangles[f];
    const auto centre = static_cast<Index>(result.positions.size());
    Vec3 centroid = {};
    for (const Index v : face) centroid = add(centroid, soup.positions[v]);
    result.positions.push_back({centroid[0] / 3, centroid[1] / 3, centroid[2] / 3});
    for (std::size_t k = 0; k < 3; ++k) {
      const Index middle = added.vertex_on[3 * f + k];
      result.triangles.push_back({face[k], middle, centre});
      result.triangles.push_back({middle, face[(k + 1) % 3], centre});
    }
  }
  return result;
}

TriangleSoup make_subdivide(const CheckedParameters& parameters) {
  TriangleSoup soup = read_input(parameters);
  for (const std::string& step : parameters.words("steps")) {
    if (step == "midpoint") soup = subdivide_midpoint(soup);
    if (step == "loop") soup = subdivide_loop(soup);
    if (step == "barycentric") soup = subdivide_barycentric(soup);
  }
  return soup;
}

/// Over undirected edges, each counted once.
double mean_edge_length(const TriangleSoup& soup) {
  double sum = 0;
  double count = 0;
  EdgeTable(soup).for_each_edge([&](std::span<const EdgeSide> sides) {
    sum += norm(subtract(soup.positions[sides[0].high], soup.positions[sides[0].low]));
    ++count;
  });
  return sum / count;
}

/// The sum of the normals of a vertex's faces, each as long as twice the face's area.
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

Family subdivide() {
  return {
      {.name = "subdivide",
       .description = "a mesh with its faces cut: midpoint makes 4 faces of one and a vertex of "
                      "every edge, loop the same and smooths the surface, barycentric 6 "
                      "faces of one and a vertex of every edge and face",
       .parameters = {input_parameter(),
                      words_parameter("steps", {"midpoint", "loop", "barycentric"},
                                      "what to do, in this order")}},
      make_subdivide};
}

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
