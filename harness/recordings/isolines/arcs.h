// The isolines within one face, as arcs of circles.
//
// A shortest path enters the face through a window of an edge, or it comes through a corner of the
// face; then it is straight. So the points at one distance that are reached through one window lie
// on a circle about the window's unfolded (pseudo-)source, within the wedge of its rays. Such an
// arc belongs to the isoline where no other wedge offers a shorter path. All points are in the
// frame of the face's first half-edge (core/mesh.h).
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "solvers/core/window.h"

namespace geodesic::harness {

inline Point2 operator+(const Point2& a, const Point2& b) { return {a.x + b.x, a.y + b.y}; }
inline Point2 operator-(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }
inline Point2 operator*(double s, const Point2& a) { return {s * a.x, s * a.y}; }

inline double dot(const Point2& a, const Point2& b) { return a.x * b.x + a.y * b.y; }
/// Positive when b points to the left of a.
inline double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }
inline Point2 left_of(const Point2& a) { return {-a.y, a.x}; }
inline double norm(const Point2& a) { return std::sqrt(dot(a, a)); }
inline double separation(const Point2& a, const Point2& b) { return norm(b - a); }

/// The rays from a centre that enter the face between two points, which lie on one of its edges
/// (a window's ends) or are two of its corners (the centre being the third).
struct Wedge {
  Point2 centre;
  double sigma;        ///< distance from the nearest source to the centre
  Point2 first, last;  ///< clockwise about the centre from `first` to `last`
};

/// A part of a circle; clockwise, so that shorter distances lie on its right.
struct Arc {
  Point2 centre, axis;  ///< the unit vector `axis` has angle 0
  double radius;
  double from, to;  ///< clockwise angles in radians, 0 <= from < to <= pi

  Point2 at(double angle) const;
  Point2 begin() const { return at(from); }
  Point2 middle() const { return at(0.5 * (from + to)); }
  Point2 end() const { return at(to); }
  double length() const { return radius * (to - from); }
};

/// Finds the arcs of a face's isolines; one object for many faces uses its memory again.
class ArcFinder {
 public:
  /// @param corners counter-clockwise, of a face with an area
  void set_face(const std::array<Point2, 3>& corners, std::span<const Wedge> wedges);

  /// The arcs at which the least distance through the wedges equals the level, in no order. The end
  /// of each is the beginning of another, or lies on an edge, up to some kSpeck.
  /// @param arcs overwritten
  void find(double level, std::vector<Arc>& arcs);

  /// Shorter arcs are left out; relative to the longest edge of the face. Where circles nearly
  /// touch, rounding makes arcs as long as about the root of itself.
  static constexpr double kSpeck = 1e-6;

 private:
  struct Circle {
    Point2 centre;
    double sigma;
    Point2 first, last;  // directions of the wedge's rays
    double opening;      // angle between them
    double near, far;    // bounds of the distance from the centre to points of the face
    double radius = 0;   // at the level; not positive when nothing is that near
  };

  void find_on(const Circle& circle, std::vector<Arc>& arcs);
  void add_visible(const Arc& arc, const Circle& circle, std::vector<Arc>& arcs);
  void cut_by_line(const Arc& arc, const Point2& point, const Point2& direction);
  void cut_by_rival(const Arc& arc, const Circle& rival);
  void cut_at(const Arc& arc, const Point2& from_centre);
  template <class Keep>
  void parts_between_cuts(const Arc& arc, Keep keep, std::vector<Arc>& parts);
  bool in_face(const Point2& p) const;
  bool is_beaten(const Point2& p) const;

  std::array<Point2, 3> corners_;
  std::array<Point2, 3> directions_;  // of the edges, from corner to corner
  double size_ = 0;                   // length of the longest edge
  double level_ = 0;
  std::vector<Circle> circles_;        // one a wedge
  std::vector<const Circle*> rivals_;  // those that may come nearer on an arc
  std::vector<double> cuts_;           // angles where that may change
  std::vector<Arc> within_;            // parts of one circle that lie in the face
};

}  // namespace geodesic::harness
