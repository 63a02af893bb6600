// Isolines of the distance field, exact along edges and inside faces.
//
// Between two vertices the distance is not linear, and where paths of two kinds meet it has a
// crease: isolines drawn from the vertices' distances would miss both. The windows that a solver
// like MMP ends with give the distance everywhere (crossings.h, arcs.h), and so every point here.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "solvers/core/recording.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

/// The greatest distance is divided into this many equal steps; there is an isoline between every
/// two of them.
inline constexpr int kIsolineSteps = 40;

/// The levels of the isolines, ascending, each once: the equal steps, and for each share the middle
/// between the farthest of so many of the vertices that have a finite distance and the next, where
/// a wavefront that swept them in perfect order would be. None when all distances are 0 or
/// infinite.
/// @param shares above 0, below 1
std::vector<double> isoline_levels(std::span<const double> distances,
                                   std::span<const double> shares = {});

/// How far a line may be from the isoline, in mean edge lengths.
inline constexpr double kIsolineError = 1e-3;

/// Polylines on the surface, each within one face. Lines of neighbouring faces meet at the same
/// point, to the last bit.
struct Isolines {
  struct Piece {
    Index face;         ///< as given to the mesh
    double level;       ///< distance of all its points
    std::size_t first;  ///< index of its first point; it ends where the next piece begins
  };
  std::vector<Vec3> points;
  std::vector<Piece> pieces;
};

/// @param windows of the solve that gave the distances
/// @param sources of that solve, in given numbers
/// @param distances in given numbers
/// @param levels ascending
Isolines trace_isolines(const Mesh& mesh, const FinalWindows& windows,
                        std::span<const Source> sources, std::span<const double> distances,
                        std::span<const double> levels);

/// Solves on a fresh solver object and traces the isolines before its windows are gone.
/// @param solver one that keeps its windows (Description::final_windows)
/// @param levels ascending
/// @param distances one entry a vertex; those of an earlier solve, and then those of this one
Isolines solve_isolines(const std::string& solver, const Mesh& mesh, const Query& query,
                        std::span<const double> levels, std::span<double> distances);

}  // namespace geodesic::harness
