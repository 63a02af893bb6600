// A slow and simple solver, for cases in which two other solvers differ.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "meshes/oracles/view.h"
#include "solvers/core/solver.h"

namespace geodesic {

/// A solver for meshes of up to some hundred faces.
///
/// A geodesic is a chain of straight segments that bend at vertices. All straight segments between
/// vertices are found by unfolding every strip of faces that is visible from a vertex (view.h), up
/// to the distance of the farthest vertex along edges; every vertex may be a bend. The result is
/// the shortest chain. Lengths are computed in `long double`.
class BruteForce {
 public:
  /// Finds all segments, which takes almost all of the time.
  explicit BruteForce(const Mesh& mesh);

  /// Returns the distances of all vertices from the nearest source, +infinity where unreachable.
  std::vector<double> distances(std::span<const Source> sources) const;

 private:
  std::vector<std::vector<std::pair<Index, Real>>> lines_;  // by external number of a vertex
};

}  // namespace geodesic
