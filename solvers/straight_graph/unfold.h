// Straight lines from a point over the faces of a mesh, until neighbouring lines part.
//
// A wedge holds the lines from the point between two rays that cross one edge. Where it sees the
// apex of the face beyond the edge, the apex is reached and the wedge is split there; where it does
// not, it goes on through the edge that it does see. A wedge narrower than a given angle ends. No
// wedge is trimmed, and none begins at a saddle vertex. In the plane the vertices of a lattice that
// are reached form the Stern-Brocot tree of directions, cut off at that angle.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "solvers/straight_graph/line.h"

namespace geodesic::straight_graph {

inline double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }
inline double dot(const Point2& a, const Point2& b) { return a.x * b.x + a.y * b.y; }

/// A vector given in a frame whose x axis has this direction.
inline Point2 turned(const Point2& axis, const Point2& v) {
  return {axis.x * v.x - axis.y * v.y, axis.y * v.x + axis.x * v.y};
}

/// The line to an apex, in the frame of the half-edge through which it enters the apex's face.
/// Differences of places in the plane would lose digits where the line is far longer than the
/// edges.
/// @param h, apex, side as Unfolder::follow passes them
inline Line line_of(const Mesh& mesh, Index h, const Point2& apex, const Point2& side) {
  const FaceFrame face = face_frame(mesh, h);
  const Point2 along = turned(side, {face.left_x, -face.left_y});
  return {h,
          norm(apex),
          {face.apex_x - dot(along, apex), std::min(face.apex_y - cross(along, apex), 0.0)}};
}

class Unfolder {
 public:
  /// @param angle least angle of a wedge in radians, below pi / 2
  explicit Unfolder(const Mesh& mesh, double angle)
      : mesh_(mesh),
        tangent_(std::tan(angle)),
        most_faces_(static_cast<int>(kFacesTimesAngle / angle)) {}

  /// The lines from the origin of a plane between two rays that cross an edge.
  struct Wedge {
    Index enter;         ///< half-edge of the face behind the edge; kNone: there is none
    Point2 left, right;  ///< ends of the edge
    Point2 along;        ///< unit vector from left to right, more exact than by their places
    Point2 left_ray, right_ray;  ///< points of the rays that bound the wedge

    /// A point of the frame of `enter` in the plane.
    Point2 in_plane(const Point2& p) const {
      const Point2 moved = turned(along, p);
      return {left.x + moved.x, left.y + moved.y};
    }
  };

  struct Always {
    bool operator()(const Wedge& /*wedge*/) const { return true; }
  };

  /// Follows all lines from the origin of a half-edge through the opposite side of its face, as
  /// `follow`. The half-edge lies along the x axis.
  template <class Reach, class MayEnter = Always>
  void follow_from_vertex(Index h, const Reach& reach, const MayEnter& may_enter = {}) {
    const HalfEdge& e = mesh_.half_edge(h);
    // An edge of one of the ends lets no line through.
    if (!(e.length > 0 && mesh_.half_edge(Mesh::previous(h)).length > 0)) return;
    const FaceFrame face = face_frame(mesh_, h);
    follow(mesh_.twin(Mesh::next(h)), {e.apex_x, e.apex_y}, {e.length, 0},
           {face.right_x, face.right_y}, reach, may_enter);
  }

  /// Follows all lines from a point through a half-edge, as `follow`. The axes of the plane are
  /// those of the twin's frame. A point at an end of the half-edge sees nothing through it: by
  /// rounding, its lines have no direction.
  /// @param from the point in the frame of the twin (spread_from)
  template <class Reach, class MayEnter = Always>
  void follow_from_point(Index h, const Point2& from, const Reach& reach,
                         const MayEnter& may_enter = {}) {
    const double length = mesh_.half_edge(h).length;
    const Point2 left = {-from.x, -from.y}, right = {length - from.x, -from.y};
    if (2 * std::min(norm(left), norm(right)) < kCoordinateRounding * length) return;
    follow(mesh_.twin(h), left, right, {1, 0}, reach, may_enter);
  }

  /// Follows all lines from the origin of a plane through an edge.
  /// @param enter half-edge of the face behind the edge; kNone: there is none
  /// @param left, right its origin and its head in the plane; the angle between them is at most pi
  /// @param along unit vector from left to right
  /// @param reach called as (Index h, Point2 apex, Point2 side), from right to left, for each apex
  ///        that a line reaches straight: the half-edge h through which it enters the apex's face,
  ///        the apex in the plane, and the unit vector from the origin of h to it
  /// @param may_enter called as (const Wedge&) for each wedge before it enters a face, which it
  ///        does if the result is true
  template <class Reach, class MayEnter = Always>
  void follow(Index enter, const Point2& left, const Point2& right, const Point2& along,
              const Reach& reach, const MayEnter& may_enter = {}) {
    Wedge w{enter, left, right, along, left, right};
    bool is_alive = is_wide(right, left);
    for (int faces = 0;;) {
      if (is_alive && w.enter != kNone && ++faces <= most_faces_) {
        is_alive = has_length(w.enter) && may_enter(w) && cross_face(w);
        continue;
      }
      if (splits_.empty()) return;
      const Split& split = splits_.back();
      reach(split.enter, split.apex, split.left.along);
      w = split.left;
      is_alive = split.goes_on;
      splits_.pop_back();
    }
  }

 private:
  /// Most faces that the lines through one edge cross, times the least angle: thin faces may be any
  /// number. With half of it errors grow on meshes without such faces, too; with twice it
  /// preparation takes more than 10 exact solves among needles.
  static constexpr double kFacesTimesAngle = 40;

  struct Split {
    Index enter;
    Point2 apex;
    Wedge left;  // the part of the wedge on the left of the apex
    bool goes_on;
  };

  bool is_wide(const Point2& right, const Point2& left) const {
    const double d = dot(right, left);
    return !(d > 0) || cross(right, left) > tangent_ * d;
  }

  /// Across an edge without length no direction continues.
  bool has_length(Index h) const { return mesh_.half_edge(h).length > 0; }

  /// A ray through a vertex reaches what lies behind that vertex, which is none of the wedge's.
  bool is_left(const Point2& right, const Point2& left) const {
    return cross(right, left) > kApexTolerance * std::abs(dot(right, left));
  }

  /// Crosses the face that the wedge enters. @return whether it, or its right part, goes on
  bool cross_face(Wedge& w) {
    const FaceFrame face = face_frame(mesh_, w.enter);
    const Point2 apex = w.in_plane({face.apex_x, face.apex_y});
    const Point2 along_right = turned(w.along, {face.right_x, face.right_y});
    const Point2 along_left = turned(w.along, {face.left_x, face.left_y});
    const Index into_right = mesh_.twin(Mesh::next(w.enter));
    const Index into_left = mesh_.twin(Mesh::previous(w.enter));
    const bool is_left_of_right = is_left(w.right_ray, apex);
    if (is_left_of_right && is_left(apex, w.left_ray)) {
      splits_.push_back({w.enter,
                         apex,
                         {into_left, w.left, apex, along_left, w.left_ray, apex},
                         is_wide(apex, w.left_ray)});
      w = {into_right, apex, w.right, along_right, apex, w.right_ray};
      return is_wide(w.right_ray, apex);
    }
    w.enter = is_left_of_right ? into_right : into_left;
    (is_left_of_right ? w.left : w.right) = apex;
    w.along = is_left_of_right ? along_right : along_left;
    return true;
  }

  const Mesh& mesh_;
  double tangent_;  // of the least angle
  int most_faces_;
  std::vector<Split> splits_;  // those whose left parts wait
};

}  // namespace geodesic::straight_graph
