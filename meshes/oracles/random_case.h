// Meshes of all kinds with a query each, from a seed and a number.
#pragma once

#include <filesystem>
#include <string>

#include "solvers/core/solver.h"

namespace geodesic {

/// What may be expected of distances on a mesh.
enum class MeshKind : std::uint8_t {
  clean,         ///< manifold, every face with an area
  non_manifold,  ///< besides, edges and vertices that no manifold has
  thin,          ///< faces thinner than kThin
  degenerate,    ///< zero-length edges or zero-area faces
};
inline constexpr std::size_t kMeshKinds = 4;
const char* name_of(MeshKind kind);

/// Least height of a face by its longest edge from which on it is not thin.
inline constexpr double kThin = 1e-6;

/// The kind of a mesh, from its geometry and topology alone.
MeshKind kind_of(const Mesh& mesh);

/// Errors on random meshes are relative to the distance, or to this part of the longest edge where
/// that is more: positions are rounded relative to the lengths that they lie among. Half a unit in
/// the last place of the largest coordinate, which a change of the origin costs, moves right
/// distances by 1e-12 of up to 1/349 of the longest edge (docs/reliability.md).
inline constexpr double kEdgePart = 1.0 / 256;

struct RandomCase {
  std::string recipe;  ///< "torus, noise, holes"
  TriangleSoup soup;
  Query query;
  double least_distance;  ///< kEdgePart of the longest edge
};

/// A surface of random_meshes.h or of a generator with random parameters, then up to three changes
/// (noise, refinement, missing faces, holes, joined vertices, another component, ...), sources and,
/// at times, initial distances and a limit. The same seed and number give the same bits.
/// @param scratch a folder for the meshes that generators read; one for each thread
RandomCase random_case(std::uint64_t seed, std::uint64_t number,
                       const std::filesystem::path& scratch);

}  // namespace geodesic
