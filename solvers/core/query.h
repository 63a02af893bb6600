// What a solver is asked.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "solvers/core/surface_point.h"

namespace geodesic {

/// A point that distances are measured from.
template <Numbers numbers>
struct SourceIn {
  PointIn<numbers> at;
  double distance = 0;  ///< initial distance at the source, >= 0, finite
};
using Source = SourceIn<Numbers::external>;
using InternalSource = SourceIn<Numbers::internal>;

/// A problem: the distances from the nearest of some sources.
template <Numbers numbers>
struct QueryIn {
  std::vector<SourceIn<numbers>> sources;  ///< at least one; the result is the least over them
  double limit = kInfinity;  ///< vertices farther than this are reported as unreachable
  /// Points whose distances and paths are wanted (RecordingKind::paths).
  std::vector<PointIn<numbers>> targets = {};
  /// Vertices farther than the farthest target are reported as unreachable too. Unless paths are
  /// recorded, a target in a face counts as far as the way to it over a corner.
  bool stop_at_targets = false;
};
using Query = QueryIn<Numbers::external>;
using InternalQuery = QueryIn<Numbers::internal>;

/// The same query by the mesh's internal numbers: as solvers get it.
/// @param query whose points are without defects
InternalQuery in_internal_numbers(const Mesh& mesh, const Query& query);

/// A vertex of the component of each source: the source itself, or a corner of its face.
std::vector<Index> source_vertices(const Mesh& mesh, const InternalQuery& query);

/// Tells a solver when the vertices that a query asks for have their distances.
///
/// A point of a face is at most as far as the way over one of its corners. Once no window or vertex
/// nearer than that waits, its distance is known, and so is that of every vertex nearer than it.
class StopRule {
 public:
  StopRule() = default;
  /// @param distances those that the solver changes
  StopRule(const Mesh& mesh, const InternalQuery& query, std::span<const double> distances);

  /// True when a wavefront whose least key is `key` has nothing left to find. Keys of successive
  /// calls do not fall but by rounding; a solver whose wavefront is not sorted asks with the least
  /// key of all that waits.
  bool is_over(double key) {
    if (key > limit_) return true;
    if (!stops_) return false;
    while (next_ < bounds_.size() && bound(bounds_[next_]) <= key) ++next_;
    return next_ == bounds_.size();
  }

  /// The distance beyond which vertices count as unreachable: the limit, or that of the farthest
  /// target.
  double farthest() const;

 private:
  /// The way to a target over each corner of its face; three times the same vertex otherwise.
  struct Bound {
    Triangle corners;
    std::array<double, 3> rest;
  };
  double bound(const Bound& b) const {
    return std::min({distances_[b.corners[0]] + b.rest[0], distances_[b.corners[1]] + b.rest[1],
                     distances_[b.corners[2]] + b.rest[2]});
  }

  double limit_ = kInfinity;
  bool stops_ = false;
  std::vector<Bound> bounds_;
  std::size_t next_ = 0;  // of bounds_: all before it are known
  std::span<const double> distances_;
};

}  // namespace geodesic
