#include <algorithm>
#include <array>

#include "meshes/defects.h"
#include "meshes/disjoint_sets.h"
#include "meshes/generators/cleaning/steps.h"
#include "solvers/core/geometry.h"

namespace geodesic {
namespace {

double side_length(const TriangleSoup& soup, const Triangle& face, std::size_t k) {
  return norm(subtract(soup.positions[face[(k + 1) % 3]], soup.positions[face[k]]));
}

/// Joins the ends of the face's sides that have no length to speak of.
/// @return the number of vertices that are gone
std::size_t join_short_sides(const TriangleSoup& soup, const Triangle& face, DisjointSets& joined) {
  std::array<double, 3> lengths;
  for (std::size_t k = 0; k < 3; ++k) lengths[k] = side_length(soup, face, k);
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (lengths[k] > kFlatHeight * longest) continue;
    const Index a = face[k], b = face[(k + 1) % 3];
    if (joined.find(a) == joined.find(b)) continue;
    joined.join(a, b);
    ++count;
  }
  return count;
}

}  // namespace

std::vector<RepairAction> weld_edges(TriangleSoup& soup) {
  DisjointSets joined(soup.positions.size());
  std::size_t count = 0;
  for (const Triangle& face : soup.triangles) count += join_short_sides(soup, face, joined);
  if (count == 0) return {};
  std::size_t kept = 0;
  for (const Triangle& face : soup.triangles) {
    const Index a = joined.find(face[0]), b = joined.find(face[1]), c = joined.find(face[2]);
    if (a != b && b != c && c != a) soup.triangles[kept++] = {a, b, c};
  }
  soup.triangles.resize(kept);
  return {{"welded_vertices", "vertices joined to another along an edge without length", count}};
}

}  // namespace geodesic
