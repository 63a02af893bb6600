// Paths and cells of sources that figures show of a recorded source.
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
    Index target;       ///< as given to the mesh
    std::size_t first;  ///< index of its first point; it ends where the next piece begins
  };
  std::vector<Vec3> points;
  std::vector<Piece> pieces;
};

/// Solves on a fresh solver object for the paths to spread vertices, the first source among them.
/// @param solver one that claims paths (Abilities::paths)
/// @param distances one entry a vertex; those of an earlier solve, and then those of this one
FigurePaths solve_figure_paths(const std::string& solver, const Mesh& mesh, const Query& query,
                               std::span<double> distances);

/// Which of several sources is the nearest of each vertex.
struct FigureCells {
  std::vector<Index> sources;  ///< as given to the mesh
  std::vector<Index> nearest;  ///< by external number, a place in `sources`; kNone where none leads
};

/// Solves on a fresh solver object.
/// @param solver one that claims paths and several sources
FigureCells solve_figure_cells(const std::string& solver, const Mesh& mesh,
                               const std::vector<Index>& sources);

}  // namespace geodesic::harness
