// Small meshes without a closed form. They are rough: many saddles, narrow faces and near ties.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

struct NamedMesh {
  std::string name;
  TriangleSoup soup;
};

/// A grid of unit cells with vertices moved in the plane and random heights up to `relief`.
TriangleSoup rough_terrain(std::uint64_t seed, Index columns, Index rows, double relief);

/// A closed surface of genus 0: an icosahedron subdivided `levels` times, with radii in [1 - noise,
/// 1 + noise].
TriangleSoup rough_sphere(std::uint64_t seed, int levels, double noise);

/// A closed surface of genus 1 whose vertices are moved by up to `noise` of the tube's radius.
TriangleSoup rough_torus(std::uint64_t seed, Index around, Index across, double noise);

/// Removes all faces at `holes` vertices. These vertices share no neighbour with one another or the
/// border, and stay as isolated vertices.
TriangleSoup with_holes(TriangleSoup soup, std::uint64_t seed, Index holes);

/// Removes one face in `one_in`, at random: ragged borders and vertices with several fans.
TriangleSoup with_missing_faces(TriangleSoup soup, std::uint64_t seed, std::uint32_t one_in);

/// Moves one end of one edge in `one_in` onto the other end.
TriangleSoup with_collapsed_edges(TriangleSoup soup, std::uint64_t seed, std::uint32_t one_in);

/// Splits one face in `one_in` at the middle of its first edge, on that face's side only, and fills
/// the slit with a face without area.
TriangleSoup with_flat_caps(TriangleSoup soup, std::uint64_t seed, std::uint32_t one_in);

/// Clean manifold meshes of up to 200 faces, with and without boundary, for every solver.
std::vector<NamedMesh> random_meshes();

}  // namespace geodesic
