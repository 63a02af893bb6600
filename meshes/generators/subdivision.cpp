#include "meshes/generators/subdivision.h"

#include <span>
#include <utility>
#include <vector>

#include "meshes/edges.h"
#include "meshes/generators/circle.h"
#include "meshes/generators/sheet.h"

namespace geodesic {
namespace {

EdgeTable edges_of(const TriangleSoup& soup) {
  return {soup.triangles, std::vector<bool>(soup.triangles.size(), true), soup.positions.size()};
}

void add_scaled(Vec3& sum, double factor, const Vec3& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += factor * point[axis];
}

Vec3 middle(const Vec3& a, const Vec3& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

Vec3 middle_of(const TriangleSoup& soup, std::span<const EdgeSide> sides) {
  return middle(soup.positions[sides[0].low], soup.positions[sides[0].high]);
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

/// What Loop's rule for an old vertex needs to know of its edges.
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
    const auto add = [&](Surroundings& at, Index other) {
      add_scaled(at.neighbours, 1, soup.positions[other]);
      ++at.valence;
      if (!is_crease(sides)) return;
      add_scaled(at.along_creases, 1, soup.positions[other]);
      ++at.creases;
    };
    add(around[sides[0].low], sides[0].high);
    add(around[sides[0].high], sides[0].low);
  });
  return around;
}

/// Loop's weight of each neighbour of an inner vertex.
double neighbour_weight(Index valence) {
  const double inner = 0.375 + circle_point(1.0 / valence).cosine / 4;
  return (0.625 - inner * inner) / valence;
}

Vec3 smoothed(const Vec3& position, const Surroundings& at) {
  Vec3 result = {};
  if (at.valence > 0 && at.creases == 0) {
    const double weight = neighbour_weight(at.valence);
    add_scaled(result, 1 - at.valence * weight, position);
    add_scaled(result, weight, at.neighbours);
  } else if (at.creases == 2) {
    add_scaled(result, 0.75, position);
    add_scaled(result, 0.125, at.along_creases);
  } else {
    return position;
  }
  return result;
}

}  // namespace

TriangleSoup subdivide_midpoint(const TriangleSoup& soup) {
  check_face_count(4.0 * static_cast<double>(soup.triangles.size()));
  return quarter(soup, edges_of(soup),
                 [&](std::span<const EdgeSide> sides) { return middle_of(soup, sides); });
}

TriangleSoup subdivide_loop(const TriangleSoup& soup) {
  check_face_count(4.0 * static_cast<double>(soup.triangles.size()));
  const EdgeTable edges = edges_of(soup);
  TriangleSoup result = quarter(soup, edges, [&](std::span<const EdgeSide> sides) {
    if (is_crease(sides)) return middle_of(soup, sides);
    Vec3 point = {};
    add_scaled(point, 0.375, soup.positions[sides[0].low]);
    add_scaled(point, 0.375, soup.positions[sides[0].high]);
    for (const EdgeSide& side : sides) {
      const Index across = previous_in_face(side.half_edge);
      add_scaled(point, 0.125, soup.positions[origin_of(soup.triangles, across)]);
    }
    return point;
  });
  const std::vector<Surroundings> around = look_around(soup, edges);
  for (std::size_t v = 0; v < around.size(); ++v) {
    result.positions[v] = smoothed(soup.positions[v], around[v]);
  }
  return result;
}

TriangleSoup subdivide_barycentric(const TriangleSoup& soup) {
  check_face_count(6.0 * static_cast<double>(soup.triangles.size()));
  WithEdgeVertices added = add_edge_vertices(
      soup, edges_of(soup), [&](std::span<const EdgeSide> sides) { return middle_of(soup, sides); },
      soup.triangles.size());
  TriangleSoup result{.positions = std::move(added.positions), .triangles = {}};
  result.triangles.reserve(6 * soup.triangles.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& face = soup.triangles[f];
    const auto centre = static_cast<Index>(result.positions.size());
    Vec3 centroid = {};
    for (const Index v : face) add_scaled(centroid, 1, soup.positions[v]);
    result.positions.push_back({centroid[0] / 3, centroid[1] / 3, centroid[2] / 3});
    for (std::size_t k = 0; k < 3; ++k) {
      const Index middle = added.vertex_on[3 * f + k];
      result.triangles.push_back({face[k], middle, centre});
      result.triangles.push_back({middle, face[(k + 1) % 3], centre});
    }
  }
  return result;
}

}  // namespace geodesic
