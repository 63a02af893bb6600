// Meshes of all kinds, from a seed and a number.
#pragma once

#include <filesystem>

#include "harness/verify/property.h"

namespace geodesic::differential {

/// What may be expected of distances on a mesh.
enum class Kind {
  clean,         ///< manifold, every face with an area
  non_manifold,  ///< besides, edges and vertices that no manifold has
  thin,          ///< faces thinner than kThin
  degenerate,    ///< zero-length edges or zero-area faces
};
inline constexpr int kKinds = 4;
const char* name_of(Kind kind);

/// Least height of a face by its longest edge from which on it is not thin.
inline constexpr double kThin = 1e-6;

/// Errors are relative to the distance, or to this part of the longest edge where that is more:
/// positions are rounded relative to the lengths that they lie among. Half a unit in the last place
/// of the largest coordinate, which a change of the origin costs, moves right distances by 1e-12 of
/// up to 1/349 of the longest edge (differential --seed 5 --meshes 420 --perturb 16).
inline constexpr double kEdgePart = 1.0 / 256;

/// The kind of a mesh, from its geometry and topology alone.
Kind kind_of(const Mesh& mesh);

/// A mesh with a query, by chance: a surface of oracles/random_meshes.h or of a generator with
/// random parameters, then up to three changes (noise, refinement, missing faces, holes, joined
/// vertices, another component, ...), sources and, at times, initial distances and a limit. The
/// same seed and number give the same bits. Case::mesh is the recipe: "torus, noise, holes".
/// @param scratch a folder for the meshes that generators read; one for each thread
harness::Case random_case(std::uint64_t seed, std::uint64_t number,
                          const std::filesystem::path& scratch);

}  // namespace geodesic::differential
