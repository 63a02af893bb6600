// Vertices that several fans of faces share, and edges that no path may cross.
#include <utility>

#include "harness/verify/properties/properties.h"

namespace geodesic::conformance {
namespace {

// Two meshes joined at one vertex, number `a` of the first and `b` of the second.
TriangleSoup joined_at_vertex(const TriangleSoup& first, Index a, const TriangleSoup& second,
                              Index b) {
  const Index offset = static_cast<Index>(first.positions.size());
  TriangleSoup both = side_by_side(first, second);
  for (std::size_t v = offset; v < both.positions.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      both.positions[v][k] += first.positions[a][k] - second.positions[b][k];
    }
  }
  for (Triangle& t : both.triangles) {
    for (Index& v : t) v = v == offset + b ? a : v;
  }
  return both;
}

std::vector<Case> joined_terrains() {
  return {{"joined terrains",
           joined_at_vertex(rough_terrain(1, 5, 5, 1), 35, rough_terrain(2, 5, 5, 1), 0),
           {from(0), from(35), from(50)}}};
}

std::vector<Case> joined_spheres() {
  return {{"joined spheres",
           joined_at_vertex(rough_sphere(3, 1, 0.2), 7, rough_sphere(4, 1, 0.2), 9),
           {from(0), from(7), from(60)}}};
}

std::vector<Case> edge_of_three_faces() {
  TriangleSoup soup = rough_terrain(5, 6, 6, 1);
  soup.positions.push_back({3, 3, 5});
  const auto [a, b, c] = soup.triangles[30];
  soup.triangles.push_back({b, a, static_cast<Index>(soup.positions.size() - 1)});
  return {{"terrain with a fin", soup, {from(0), from(20), from(49)}}};
}

std::vector<Case> flipped_face() {
  TriangleSoup soup = rough_terrain(6, 6, 6, 1);
  std::swap(soup.triangles[33][0], soup.triangles[33][1]);
  return {{"terrain with a flipped face", soup, {from(0), from(20), from(48)}}};
}

std::vector<Case> ragged_surfaces() {
  std::vector<Case> cases;
  for (std::uint64_t seed = 70; seed < 80; ++seed) {
    const auto ragged = [&](const std::string& name, const TriangleSoup& soup) {
      cases.push_back({"ragged " + name + ' ' + std::to_string(seed),
                       with_missing_faces(soup, seed, 4),
                       {from(44)}});
    };
    ragged("terrain", rough_terrain(seed, 9, 9, 1.5));
    ragged("sphere", rough_sphere(seed, 2, 0.3));
  }
  return cases;
}

}  // namespace

std::vector<Property> non_manifold_properties() {
  return {
      {"non-manifold-vertex-that-joins-two-terrains-lets-paths-through",
       "paths run from one surface to another through the vertex that both share",
       {},
       joined_terrains,
       distances_are_right},
      {"non-manifold-vertex-that-joins-two-closed-surfaces-lets-paths-through",
       "paths run from one closed surface to another through the vertex that both share",
       {},
       joined_spheres,
       distances_are_right},
      {"non-manifold-edge-of-three-faces-is-crossed-at-its-ends-only",
       "an edge of three faces is a boundary of each",
       {},
       edge_of_three_faces,
       distances_are_right},
      {"non-manifold-edges-of-a-flipped-face-are-crossed-at-their-ends-only",
       "edges whose faces are oriented against each other are boundaries of both",
       {},
       flipped_face,
       distances_are_right},
      {"non-manifold-ragged-surfaces-equal-brute-force",
       "on surfaces with many missing faces distances are exact",
       {},
       ragged_surfaces,
       distances_are_right},
  };
}

}  // namespace geodesic::conformance
