// Intervals that hold the true distances, whatever is rounded: the judge of the other oracles.
#pragma once

#include <boost/multiprecision/mpfi.hpp>
#include <span>
#include <vector>

#include "solvers/core/solver.h"

namespace geodesic {

/// Bounds of 100 digits, rounded outwards by every operation (MPFI).
using Interval = boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<100>,
                                               boost::multiprecision::et_off>;

/// For meshes of up to some hundred faces.
///
/// As BruteForce, this unfolds every strip of faces that can be seen from a vertex, but a line
/// counts twice: its length bounds the distance from below where it may lie inside the strip, and
/// from above where it certainly does, seen through each edge of the strip. A line through a vertex
/// is never certain; the two lines that meet there are as long, and bound it from above.
class Enclosures {
 public:
  /// Finds the lines: all the work.
  explicit Enclosures(const Mesh& mesh);

  /// Of the distances to all vertices from the nearest source: +infinity on both sides where no
  /// path leads, above alone where no path is certain.
  std::vector<Interval> distances(std::span<const Source> sources) const;

 private:
  std::vector<std::vector<std::pair<Index, Interval>>> lines_;  // per vertex: to which, and length
};

}  // namespace geodesic
