// Windows and their unfolding across a face: the kernel that all window solvers share.
//
// A window (Mitchell, Mount, Papadimitriou 1987; thesis section 3.2.2) is an interval of an edge
// whose points are reached by straight lines, in the unfolded plane, from one (pseudo-)source. It
// is kept in the frame of the half-edge whose face the lines are about to enter (core/mesh.h):
// the edge is the x axis from 0 to its length, the face lies at y > 0, the source at y <= 0.
// Storing the source's position instead of the two end distances spares square roots and digits.
// Rules about windows (which points they reach, which paths beat them): window_predicates.h.
#pragma once

#include <algorithm>
#include <cmath>

#include "solvers/core/mesh.h"
#include "solvers/core/tolerance.h"

namespace geodesic {

/// A point of a half-edge's frame.
struct Point2 {
  double x, y;

  bool operator==(const Point2&) const = default;
};

/// Distance from the origin. Uses the square root, which gives the same bits in every C library;
/// std::hypot does not. Squares of lengths are within range (mesh_input.h).
inline double norm(const Point2& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

/// The geometry of a window. Solvers derive their window types from it.
struct Window {
  double begin, end;  ///< 0 <= begin < end <= length of the half-edge, from its origin
  double x, y;        ///< unfolded position of the (pseudo-)source, y <= 0
  double sigma;       ///< distance from the nearest source to that pseudo-source
};

/// Distance through the window's source to the point (px, py) of the half-edge's frame. Does not
/// check that the line passes through the window.
inline double distance_through(const Window& w, double px, double py) {
  const double dx = px - w.x, dy = py - w.y;
  return w.sigma + std::sqrt(dx * dx + dy * dy);
}

/// Distance to the point at position t of the edge.
inline double distance_at(const Window& w, double t) { return distance_through(w, t, 0.0); }

/// Length of a path to (px, py) that bends at position t of the edge.
inline double distance_over(const Window& w, double t, double px, double py) {
  return distance_at(w, t) + norm(Point2{px - t, py});
}

/// Position on the edge where the window's distance is least.
inline double nearest_position(const Window& w) { return std::clamp(w.x, w.begin, w.end); }

/// Least distance over the window, the key by which windows are queued.
inline double least_distance(const Window& w) { return distance_at(w, nearest_position(w)); }

/// Least distance to (px, py), py >= 0, over paths through the window: straight when the line from
/// the source passes the interval, otherwise bent at its nearer end (thesis Figure 5.3).
inline double least_distance_to(const Window& w, double px, double py) {
  // The line from the source meets the edge at t = x + (px - x) (-y) / (py - y).
  const double height = py - w.y;
  if (height > 0) {
    const double t = w.x + (px - w.x) * (-w.y / height);
    const double bend = std::clamp(t, w.begin, w.end);
    if (bend == t) return distance_through(w, px, py);
    return distance_over(w, bend, px, py);
  }
  // Source and target both lie on the edge's line.
  const double bend = std::clamp(px, w.begin, w.end);
  return distance_at(w, bend) + std::abs(px - bend);
}

/// The face beyond a half-edge, ready for unfolding windows onto its other two edges.
///
/// Children are expressed in the frames of the twins of `previous(h)` (left: from the origin of h
/// to the apex) and `next(h)` (right: from the apex to the head of h): windows in order along h
/// stay in order along left then right.
struct FaceFrame {
  double length;            ///< of the entered half-edge
  double apex_x, apex_y;    ///< the apex in its frame
  double left, right;       ///< lengths of the two other edges
  double left_x, left_y;    ///< unit vector from the origin to the apex
  double right_x, right_y;  ///< unit vector from the apex to the head

  /// Position along the left edge, from the origin of h, of the ray from the source of `w` through
  /// the point t of h, clamped to the edge.
  double on_left(const Window& w, double t) const {
    const double denominator = -w.y * left_x - (t - w.x) * left_y;
    if (!(denominator > 0)) return left;
    return std::clamp(-w.y * t / denominator, 0.0, left);
  }

  /// Position along the right edge, from the apex, of the same ray, clamped to the edge.
  double on_right(const Window& w, double t) const {
    // As on_left, mirrored: u is the distance from the head of h.
    const double denominator = -w.y * right_x - (t - w.x) * right_y;
    if (!(denominator > 0)) return 0.0;
    const double u = -w.y * (length - t) / denominator;
    return std::clamp(right - u, 0.0, right);
  }

  /// The point (px, py) in the frame of the left edge's twin.
  Point2 to_left(double px, double py) const {
    return {px * left_x + py * left_y, py * left_x - px * left_y};
  }

  /// The point (px, py) in the frame of the right edge's twin.
  Point2 to_right(double px, double py) const {
    const double dx = px - apex_x, dy = py - apex_y;
    return {dx * right_x + dy * right_y, dy * right_x - dx * right_y};
  }

  /// The lines of a window that cross the left edge, as a window in the frame of its twin, which
  /// may be void. Rounding does not move the source across the edge.
  /// @param passes_apex some lines of the window cross the right edge: these go up to the apex
  Window left_child(const Window& w, bool passes_apex) const {
    const Point2 from = to_left(w.x, w.y);
    return {on_left(w, w.begin), passes_apex ? left : on_left(w, w.end), from.x,
            std::min(from.y, 0.0), w.sigma};
  }

  /// The same of the right edge.
  /// @param passes_apex some lines of the window cross the left edge
  Window right_child(const Window& w, bool passes_apex) const {
    const Point2 from = to_right(w.x, w.y);
    return {passes_apex ? 0 : on_right(w, w.begin), on_right(w, w.end), from.x,
            std::min(from.y, 0.0), w.sigma};
  }
};

/// @param h the half-edge whose face is entered
inline FaceFrame face_frame(const Mesh& mesh, Index h) {
  const HalfEdge& e = mesh.half_edge(h);
  const HalfEdge& next = mesh.half_edge(Mesh::next(h));
  const double right = next.length;
  const double left = mesh.half_edge(Mesh::previous(h)).length;
  // An edge of length zero takes no window; any unit vector does for it.
  const double per_left = left > 0 ? 1 / left : 0;
  const double per_right = right > 0 ? 1 / right : 0;
  return {.length = e.length,
          .apex_x = e.apex_x,
          .apex_y = e.apex_y,
          .left = left,
          .right = right,
          // If the other two edges coincide, exactly: lines wind around a vertex whose faces have
          // all collapsed, and a rounding error here would change their length at each turn.
          .left_x = right > 0 ? e.apex_x * per_left : 1,
          .left_y = e.apex_y * per_left,
          // The cosine at the head, from the next frame, where it is a scalar product. The
          // difference of length and apex_x has no digits left when the right edge is very short.
          .right_x = e.length > 0 ? next.apex_x / e.length : 0,
          .right_y = -e.apex_y * per_right};
}

/// A point of a half-edge's face in the frame of the twin. In a face without area the point may lie
/// on the edge. Between the edge's ends it is then moved off the edge by kTouchingHeight, so that
/// its lines have a side. A point that coincides with an end is not moved: the windows of a
/// collapsed edge's two ends would propagate around it without end.
inline Point2 seen_from_beyond(const Point2& p, double length) {
  const double margin = kWindowWidth * length;
  const bool between = p.x > margin && p.x < length - margin;
  const double height = between ? std::max(p.y, kTouchingHeight * length) : p.y;
  return {length - p.x, -height};
}

/// The apex of the face of a half-edge, in the frame of the twin.
inline Point2 apex_from_beyond(const HalfEdge& e) {
  return seen_from_beyond({e.apex_x, e.apex_y}, e.length);
}

}  // namespace geodesic
