// A slow and plain solver: the third opinion where two solvers differ.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "meshes/oracles/view.h"
#include "solvers/core/solver.h"

namespace geodesic {

/// For meshes of up to some hundred faces.
///
/// A geodesic is a chain of straight segments that bend at vertices. All straight segments between
/// vertices are found by unfolding every strip of faces that can be seen from a vertex (view.h), as
/// long as it lies nearer than the farthest vertex along edges; every vertex may be a bend. The
/// result is the shortest chain. Lengths are kept in `long double`.
class BruteForce {
 public:
  /// Finds the segments: all the work.
  explicit BruteForce(const Mesh& mesh);

  /// Distances to all vertices from the nearest source, +infinity where no path leads.
  std::vector<double> distances(std::span<const Source> sources) const;

 private:
  std::vector<std::vector<std::pair<Index, Real>>> lines_;  // by external number of a vertex
};

}  // namespace geodesic
