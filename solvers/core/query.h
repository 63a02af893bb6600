// The input of a solve: sources, limit and targets.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "solvers/core/surface_point.h"

namespace geodesic {

/// A source: a point from which distances are measured.
template <Numbers numbers>
struct SourceIn {
  PointIn<numbers> at;
  double distance = 0;  ///< initial distance at the source, >= 0, finite
};
using Source = SourceIn<Numbers::external>;
using InternalSource = SourceIn<Numbers::internal>;

/// A query: the distances from the nearest of some sources.
template <Numbers numbers>
struct QueryIn {
  std::vector<SourceIn<numbers>> sources;  ///< at least one; the result is the least over them
  double limit = kInfinity;  ///< vertices farther than this are reported as unreachable
  /// Points whose distances and paths are requested (RecordingKind::paths).
  std::vector<PointIn<numbers>> targets = {};
  /// Vertices farther than the farthest target are reported as unreachable too. Unless paths are
  /// recorded, the distance of a target in a face is the shortest way to it over a corner.
  bool stop_at_targets = false;
};
using Query = QueryIn<Numbers::external>;
using InternalQuery = QueryIn<Numbers::internal>;

/// Returns the same query in the mesh's internal numbers, for the solver.
/// @param query its points have no defects
InternalQuery in_internal_numbers(const Mesh& mesh, const Query& query);

/// Decides when the vertices that a query needs have their final distances.
///
/// A point of a face is at most as far as the way over one of its corners. Once no waiting window
/// or vertex is nearer than that, its distance is final, and so is that of every nearer vertex.
class StopRule {
 public:
  StopRule() = default;
  /// @param distances the solver's, which it goes on to change
  StopRule(const Mesh& mesh, const InternalQuery& query, std::span<const double> distances);

  /// True when a wavefront whose least key is `key` can no longer change the result. The keys of
  /// successive calls decrease only by rounding. A solver whose wavefront is not sorted must pass
  /// the least key of all waiting windows or vertices.
  bool is_over(double key) {
    if (key > limit_) return true;
    if (!stops_) return false;
    while (next_ < bounds_.size() && bound(bounds_[next_]) <= key) ++next_;
    return next_ == bounds_.size();
  }

  /// The distance beyond which vertices count as unreachable: the limit, or the distance of the
  /// farthest target.
  double farthest() const;

 private:
  /// Corners of a target's face, with the way from each to the target; a vertex is repeated thrice.
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
  std::size_t next_ = 0;  // index into bounds_: the distances of all before it are final
  std::span<const double> distances_;
};

}  // namespace geodesic
