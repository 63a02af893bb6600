// A triangulation of the same surface whose edges can be flipped: its edges are straight lines over
// the faces of the mesh.
#pragma once

#include <unordered_map>
#include <vector>

#include "solvers/core/mesh.h"
#include "solvers/core/surface_point.h"
#include "solvers/core/window.h"

namespace geodesic::flip_out {

/// Half-edges keep the mesh's numbers; behind them come those of the other side of boundary edges,
/// which have no face. As in the mesh each has the frame of its face: lengths alone say little of
/// the angles of needles. Where a half-edge that was flipped leaves its vertex is kept as Sharp,
/// Soliman, Crane 2019, "Navigating intrinsic triangulations", section 3.2: as an angle.
class IntrinsicMesh {
 public:
  explicit IntrinsicMesh(const Mesh& mesh);

  Index origin(Index h) const { return origin_[h]; }
  Index head(Index h) const { return origin_[twin_[h]]; }
  Index twin(Index h) const { return twin_[h]; }
  Index next(Index h) const { return next_[h]; }
  bool has_face(Index h) const { return next_[h] != kNone; }
  /// False also where both sides of an edge are of one face, wrapped around a cone.
  bool has_two_faces(Index h) const {
    const Index twin = twin_[h];
    return has_face(h) && has_face(twin) && next_[h] != twin && previous(h) != twin;
  }
  double length(Index h) const { return frame_[h].length; }

  /// A half-edge of the mesh between two neighbours.
  Index between(Index from, Index to) const;
  /// The next half-edge of its origin, counter-clockwise and clockwise; kNone beyond a boundary.
  Index left_of(Index h) const { return has_face(h) ? twin_[previous(h)] : kNone; }
  Index right_of(Index h) const { return next_[twin_[h]]; }
  /// Of the face of h, at its origin, in radians; has_face(h).
  double angle(Index h) const;

  /// Replaces the edge by the other diagonal of its faces; has_two_faces(h), convex together.
  void flip(Index h);
  /// Undoes all flips.
  void reset();

  /// Adds the points at which a half-edge's line crosses edges of the mesh, and its head.
  /// @throws std::runtime_error when rounding has led the line astray
  void trace(Index h, std::vector<InternalPoint>& points) const;

 private:
  /// Within the angle of a face of the mesh at a vertex, counter-clockwise from its half-edge.
  struct Direction {
    Index half_edge;
    double angle;
  };

  struct Frame {
    double length;
    Point2 apex;
  };

  Index previous(Index h) const { return next_[next_[h]]; }
  /// To a face.
  void join(Index first, Index second, Index third);
  /// Of a line to the left of h, which it encloses this angle with.
  Direction direction_beside(Index h, double angle) const;

  const Mesh& mesh_;
  std::vector<Index> next_, twin_, origin_;
  std::vector<Frame> frame_;
  std::unordered_map<Index, Direction> direction_;  // of flipped half-edges
  std::vector<Index> changed_;                      // by flips; some several times
};

}  // namespace geodesic::flip_out
