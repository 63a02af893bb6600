// Random meshes of all kinds, each with a query, from a seed and a number.
#pragma once

#include <filesystem>
#include <string>

#include "solvers/core/solver.h"

namespace geodesic {

/// Kinds of meshes, which determine the accuracy of distances that tests expect.
enum class MeshKind : std::uint8_t {
  clean,         ///< manifold, every face has an area
  non_manifold,  ///< also has non-manifold edges or vertices
  thin,          ///< faces thinner than kThin
  degenerate,    ///< zero-length edges or zero-area faces
};
inline constexpr std::size_t kMeshKinds = 4;
const char* name_of(MeshKind kind);

/// Least height of a face, relative to its longest edge, with which it is not thin.
inline constexpr double kThin = 1e-6;

/// Returns the kind of a mesh, from its geometry and topology alone.
MeshKind kind_of(const Mesh& mesh);

/// Errors on random meshes are relative to the distance, or to this part of the longest edge if
/// that is larger: the rounding error of a position is relative to the lengths around it. A change
/// of the origin costs half a unit in the last place of the largest coordinate, and so moves
/// correct distances by 1e-12 of up to 1/349 of the longest edge (docs/reliability.md).
inline constexpr double kEdgePart = 1.0 / 256;

struct RandomCase {
  std::string recipe;  ///< "torus, noise, holes"
  TriangleSoup soup;
  Query query;
  double least_distance;  ///< kEdgePart of the longest edge
};

/// Returns a surface of random_meshes.h or of a generator with random parameters, up to three
/// changes (noise, refinement, missing faces, holes, joined vertices, another component, ...),
/// sources and sometimes initial distances and a limit. Seed and number determine every bit.
/// @param scratch folder for the meshes that generators read; each thread needs its own
RandomCase random_case(std::uint64_t seed, std::uint64_t number,
                       const std::filesystem::path& scratch);

}  // namespace geodesic
