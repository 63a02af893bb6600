// A triangulation of the same surface whose edges can be flipped: its edges are straight lines over
// the faces of the mesh.
#pragma once

#include <unordered_map>
#include <vector>

#include "solvers/core/mesh.h"
#include "solvers/core/surface_point.h"
#include "solvers/core/window.h"

namespace geodesic::flip_out {

/// Half-edges keep the mesh's numbers. The other sides of boundary edges follow; they have no face.
/// As in the mesh, each half-edge has the frame of its face: lengths alone say little about the
/// angles of needles. The direction in which a flipped half-edge leaves its vertex is stored as an
/// angle, as in Sharp, Soliman, Crane 2019, "Navigating intrinsic triangulations", section 3.2.
class IntrinsicMesh {
 public:
  explicit IntrinsicMesh(const Mesh& mesh);

  Index origin(Index h) const { return origin_[h]; }
  Index head(Index h) const { return origin_[twin_[h]]; }
  Index twin(Index h) const { return twin_[h]; }
  Index next(Index h) const { return next_[h]; }
  bool has_face(Index h) const { return next_[h] != kNone; }
  /// False also if both sides of the edge belong to one face, wrapped around a cone.
  bool has_two_faces(Index h) const {
    const Index twin = twin_[h];
    return has_face(h) && has_face(twin) && next_[h] != twin && previous(h) != twin;
  }
  double length(Index h) const { return frame_[h].length; }

  /// Returns the half-edge of the mesh between two neighbours.
  Index between(Index from, Index to) const;
  /// The next half-edge at its origin, counter-clockwise and clockwise; kNone beyond a boundary.
  Index left_of(Index h) const { return has_face(h) ? twin_[previous(h)] : kNone; }
  Index right_of(Index h) const { return next_[twin_[h]]; }
  /// Angle of the face of h at its origin, in radians; requires has_face(h).
  double angle(Index h) const;

  /// Replaces the edge by the other diagonal of its faces; needs has_two_faces(h), convex together.
  void flip(Index h);
  /// Undoes all flips.
  void reset();

  /// Appends the points at which the line of a half-edge crosses edges of the mesh, and its head.
  /// @throws std::runtime_error if the line misses its end by rounding
  void trace(Index h, std::vector<InternalPoint>& points) const;

 private:
  /// An angle in a face of the mesh at a vertex, counter-clockwise from a half-edge of the face.
  struct Direction {
    Index half_edge;
    double angle;
  };

  struct Frame {
    double length;
    Point2 apex;
  };

  Index previous(Index h) const { return next_[next_[h]]; }
  /// Joins three half-edges to a face.
  void join(Index first, Index second, Index third);
  /// Direction of a line at this angle to the left of h.
  Direction direction_beside(Index h, double angle) const;

  const Mesh& mesh_;
  std::vector<Index> next_, twin_, origin_;
  std::vector<Frame> frame_;
  std::unordered_map<Index, Direction> direction_;  // by flipped half-edge
  std::vector<Index> changed_;                      // by flips; may have duplicates
};

}  // namespace geodesic::flip_out
