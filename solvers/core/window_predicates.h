// What a window's lines reach, and which paths beat them: rules that all window solvers share.
#pragma once

#include <algorithm>
#include <cmath>

#include "solvers/core/tolerance.h"
#include "solvers/core/window.h"

namespace geodesic {

/// True when the window is too narrow to matter, or trimming has emptied it.
/// @param length of the edge
inline bool is_void(const Window& w, double length) {
  return !(w.end - w.begin > kWindowWidth * length);
}

/// True when the window's source lies almost on the edge, inside the interval: the apex of a face
/// without area. All its lines, in whatever direction, pass the edge in one point. An interval that
/// ends there therefore does not show which lines are left.
inline bool source_on_edge(const Window& w, double length) {
  return w.y > -kFlatFace * length && w.begin <= w.x && w.x <= w.end;
}

/// Largest rounding of a distance that is far shorter than the edges whose frames its window has
/// come through: a source near a long edge still has coordinates along that edge. Two windows of
/// one source then differ by as much, and it is chance which of them is shorter.
inline double coordinate_rounding(const Mesh& mesh) {
  double longest_edge = 0;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    longest_edge = std::max(longest_edge, mesh.half_edge(h).length);
  }
  return kCoordinateRounding * longest_edge;
}

/// True when rounding of coordinates turns the window's line through position t, because its source
/// is next to the edge there.
inline bool is_turned_by_rounding(const Window& w, double t, double rounding) {
  return std::abs(t - w.x) - w.y < kNextToEdge * rounding;
}

/// Positive when (px, py) lies to the right of the line from the source of w through t. The value
/// is scaled by the line's length and the distance between point and source.
inline double right_of(const Window& w, double t, double px, double py) {
  return (px - w.x) * -w.y - (t - w.x) * (py - w.y);
}

/// The sides of a point beyond the edge on which lines of a window pass. With both, a line leads to
/// the point.
struct Sides {
  bool left, right;

  bool operator==(const Sides&) const = default;
};

/// Position of a point beyond the edge relative to the lines of a window.
class WindowSight {
 public:
  /// @param p in the frame of the window, p.y >= 0
  WindowSight(const Window& w, const Point2& p)
      : from_source_{p.x - w.x, p.y - w.y},
        right_of_begin_(right_of(w, w.begin, p.x, p.y)),
        right_of_end_(right_of(w, w.end, p.x, p.y)) {}

  /// Some line passes the point on this side.
  bool left() const { return right_of_begin_ > 0; }
  bool right() const { return right_of_end_ < 0; }
  Sides sides() const { return {left(), right()}; }
  /// This end of the interval lies on the line from the source to the point, within kApexReach.
  bool at_begin() const { return is_at(right_of_begin_); }
  bool at_end() const { return is_at(right_of_end_); }
  /// Some line passes the point itself. Other paths to it bend at an end of the interval.
  bool reaches() const { return (left() || at_begin()) && (right() || at_end()); }

 private:
  bool is_at(double side) const {
    const Point2& p = from_source_;
    return std::abs(side) <= kApexReach * (p.x * p.x + p.y * p.y);
  }

  Point2 from_source_;  // to the point
  double right_of_begin_, right_of_end_;
};

/// Calls land(side, child) for each child of a window that crosses a face: `side` is the half-edge
/// through which the child's lines leave the face, `child` is in the frame of its twin, and may be
/// void.
/// @param h the half-edge whose face is entered; face and sight are those of w and h
template <class Land>
void for_each_child(Index h, const FaceFrame& face, const Window& w, const WindowSight& sight,
                    const Land& land) {
  const bool left = sight.left(), right = sight.right();
  if (left) land(Mesh::previous(h), face.left_child(w, right));
  if (right) land(Mesh::next(h), face.right_child(w, left));
}

/// Length of the window's shortest path to the apex, which its lines pass on the sides `seen`.
inline double distance_to_apex(const Window& w, Sides seen, const FaceFrame& face) {
  if (seen.left && seen.right) return distance_through(w, face.apex_x, face.apex_y);
  return distance_over(w, seen.left ? w.end : w.begin, face.apex_x, face.apex_y);
}

/// One angle, two sides (Chen and Han 1990, section 3; thesis section 5.1.2). A line that begins on
/// one side of a path to the apex and passes the apex on the other side crosses that path inside
/// the face. It is beaten there if its window's path to the apex is longer.
/// @param seen the sides on which lines pass the apex that begin between `begin` and `end`
/// @param path position on the edge of a shorter path to the apex
/// @return the sides on which some lines do not cross the path
inline Sides sides_not_crossing(Sides seen, double begin, double end, double path) {
  return {seen.left && !(begin >= path), seen.right && !(end <= path)};
}

/// Position where the line from the window's source to the apex crosses the line of the edge.
inline double apex_line_position(const Window& w, const FaceFrame& face) {
  const double up = std::max(face.apex_y - w.y, kLeastHeight);
  return w.x + (face.apex_x - w.x) * (-w.y / up);
}

/// The length of a path with the margin by which a window must be longer to be beaten by the path.
inline double with_margin(double length) { return length * (1 + kPathMargin); }

/// True when a path to position t of the edge is shorter than the window's line there.
/// @param rival the length of the path, with_margin
inline bool is_beaten_at(const Window& w, double t, double rival) {
  // rival < sigma + |source t|, squared to spare the root.
  const double straight = rival - w.sigma, dx = t - w.x;
  return (straight < 0) | (straight * straight < dx * dx + w.y * w.y);
}

/// Distances of the two ends of an edge, for comparison with its windows.
struct EndpointBounds {
  double length;
  double at_origin, at_head;  ///< with_margin

  EndpointBounds(double edge, double origin, double head)
      : length(edge), at_origin(with_margin(origin)), at_head(with_margin(head)) {}

  /// True when every point of the window can be reached along the edge from one end of the edge at
  /// least as well (the filter of Xin and Wang 2009): d(origin) + end < sigma + |source - end|, or
  /// the mirror.
  bool beat(const Window& w) const {
    return is_beaten_at(w, w.end, at_origin + w.end) ||
           is_beaten_at(w, w.begin, at_head + (length - w.begin));
  }

  /// As `beat`, for a window over the whole edge.
  /// @param to_origin, to_head distances of the edge's ends through the window
  bool beat_whole(double to_origin, double to_head) const {
    return (at_origin + length < to_head) | (at_head + length < to_origin);
  }
};

/// True when a path of length a beats one of length b by more than rounding.
/// @param rounding of coordinates
inline bool is_shorter(double a, double b, double rounding) {
  return a < b * (1 - kPathMargin) - rounding;
}

}  // namespace geodesic
