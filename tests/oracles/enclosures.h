// Intervals that contain the true distances despite rounding. They judge the other oracles.
#pragma once

#include <boost/multiprecision/mpfi.hpp>
#include <span>
#include <vector>

#include "solvers/core/solver.h"

namespace geodesic {

/// An interval with bounds of 100 digits, which every operation rounds outwards (MPFI).
using Interval = boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<100>,
                                               boost::multiprecision::et_off>;

/// Encloses the distances on meshes of up to some hundred faces.
///
/// Like BruteForce, this class unfolds every strip of faces that can be seen from a vertex. The
/// length of a line is a lower bound of the distance if the line may lie inside the strip. It is an
/// upper bound if the line certainly crosses each edge of the strip. A line through a vertex is
/// never certain; the two lines that meet there have the same length and give the upper bound.
class Enclosures {
 public:
  /// Finds all lines between vertices. This takes nearly all of the time.
  explicit Enclosures(const Mesh& mesh);

  /// Intervals of the distances from the nearest source to all vertices. Both bounds are +infinity
  /// for a vertex without a path; only the upper bound is, if no path is certain.
  std::vector<Interval> distances(std::span<const Source> sources) const;

 private:
  std::vector<std::vector<std::pair<Index, Interval>>> lines_;  // per vertex: (other end, length)
};

}  // namespace geodesic
