// Whether distances are right: against those of another solver, and against bounds that hold for
// every shortest path. No time is published for a solve that fails here.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Largest relative difference that exact distances may have.
inline constexpr double kExactTolerance = 1e-12;

/// Somebody's distances to compare with, one a vertex.
struct Distances {
  std::string solver;
  std::span<const double> values;
};

struct Verdict {
  /// Empty when the distances are right; otherwise one line with the worst vertex of the first
  /// check that failed, both distances and their relative difference.
  std::string error = {};
  double max_relative_error = 0;  ///< against the reference, over vertices that both reach
};

/// Checks, in this order:
/// - no distance is negative or not a number;
/// - the reference: exact distances differ from it by at most kExactTolerance, relative to it, and
///   leave the same vertices unreachable; an upper bound is not below it by more;
/// - the straight line: no vertex is nearer than its distance in space to the nearest source;
/// - the edge graph: an exact distance is at most that along edges;
/// - the triangle inequality: |d(u) - d(v)| <= |uv| along every edge.
/// The bounds have a slack of kExactTolerance relative to the larger distance.
/// @param mesh distances and sources go by the numbers its vertices were given as
/// @param sources all with an initial distance of 0; the solve was without limit
/// @param edge_graph from a solver of upper bounds; may be absent
Verdict verify(const Mesh& mesh, std::span<const Index> sources, Exactness exactness,
               std::span<const double> distances, const Distances& reference,
               const std::optional<Distances>& edge_graph);

}  // namespace geodesic::harness
