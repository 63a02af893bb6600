#include "meshes/weld.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "meshes/coincidence.h"
#include "meshes/connectivity.h"
#include "solvers/core/messages.h"

namespace geodesic {

std::vector<RepairAction> weld(TriangleSoup& soup, double distance) {
  if (!(distance >= 0 && distance < kInfinity)) {
    throw std::invalid_argument(
        "the distance within which vertices are joined must be finite and 0 or more, not " +
        significant(distance, 6));
  }
  const std::size_t vertices = soup.positions.size();
  std::vector<bool> used(vertices, false);
  for (Index f = 0; f < soup.triangles.size(); ++f) {
    if (!soup.is_face(f)) continue;
    for (const Index v : soup.triangles[f]) {
      if (v < vertices && is_finite(soup.positions[v])) used[v] = true;
    }
  }
  const Coincidences found = find_coincidences(soup.positions, used, distance);
  DisjointSets sets(vertices);
  std::size_t joined = 0;
  for (const auto* pairs : {&found.same, &found.near}) {
    for (const auto& [a, b] : *pairs) joined += sets.join(a, b) ? 1U : 0U;
  }
  if (joined == 0) return {};

  if (soup.joined_to.empty()) {
    soup.joined_to.resize(vertices);
    std::iota(soup.joined_to.begin(), soup.joined_to.end(), Index{0});
  }
  for (Index& v : soup.joined_to) v = sets.find(v);
  std::size_t collapsed = 0;
  for (Index f = 0; f < soup.triangles.size(); ++f) {
    Triangle& face = soup.triangles[f];
    const bool was_whole = soup.is_face(f) && !names_a_vertex_twice(face);
    for (Index& v : face) {
      if (v < vertices) v = sets.find(v);
    }
    if (!was_whole || !names_a_vertex_twice(face)) continue;
    soup.left_out.resize(soup.triangles.size(), false);
    soup.left_out[f] = true;
    ++collapsed;
  }
  std::vector<RepairAction> done = {
      {"joined_vertices", "vertices joined to an earlier one", joined}};
  if (collapsed > 0) {
    done.push_back({"left_out_collapsed_faces",
                    "faces left out because they collapse when their corners are joined",
                    collapsed});
  }
  return done;
}

}  // namespace geodesic
