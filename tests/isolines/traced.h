// Isolines of small meshes, as every solver that hands its windows over gives them.
#pragma once

#include <string>
#include <vector>

#include "harness/recordings/isolines/isolines.h"

namespace geodesic::harness {

/// What is known after a solve.
struct Traced {
  std::vector<double> distances;
  std::vector<double> levels;
  Isolines isolines;
  std::vector<std::vector<Window>> windows;  // by half-edge; empty but for an edge's own

  /// The points of a piece.
  std::span<const Vec3> points(std::size_t piece) const;
};

/// The names of the solvers that hand over windows.
std::vector<std::string> solvers_with_windows();

/// @param levels those of isoline_levels when empty
Traced trace(const std::string& solver, const Mesh& mesh, const std::vector<Source>& sources,
             std::vector<double> levels = {});

}  // namespace geodesic::harness
