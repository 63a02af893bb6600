// Paths and nearest-source cells for the figures of a recorded source.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solvers/core/solver.h"

namespace geodesic::harness {

inline constexpr std::size_t kFigurePaths = 40;
inline constexpr std::size_t kFigureSources = 8;

/// Polylines on the surface, from the source to each target.
struct FigurePaths {
  struct Piece {
    Index target;       ///< external number
    std::size_t first;  ///< index of its first point; it ends where the next piece begins
  };
  std::vector<Vec3> points;
  std::vector<Piece> pieces;
};

/// Solves on a new solver object for the paths to the spread_vertices of the first source.
/// @param solver must claim paths (Abilities::paths)
/// @param distances one for each vertex; on entry of an earlier solve, on return of this one
FigurePaths solve_figure_paths(const std::string& solver, const Mesh& mesh, const Query& query,
                               std::span<double> distances);

/// The nearest of several sources, for each vertex.
struct FigureCells {
  std::vector<Index> sources;  ///< external numbers
  std::vector<Index> nearest;  ///< by external number: index in `sources`; kNone if unreachable
};

/// Solves on a new solver object.
/// @param solver must claim paths and several sources
FigureCells solve_figure_cells(const std::string& solver, const Mesh& mesh,
                               const std::vector<Index>& sources);

}  // namespace geodesic::harness
