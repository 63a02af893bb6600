// The shortest line in a sleeve.
#pragma once

#include <array>
#include <vector>

#include "solvers/paths/sleeve.h"

namespace geodesic {

/// Whether c lies on the left of the line from a to b (> 0): twice the area of the triangle.
inline double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
inline double length_between(const Point2& a, const Point2& b) {
  return norm(Point2{b.x - a.x, b.y - a.y});
}

/// A face laid out in the plane, with its corners in the order of its triangle.
struct LaidFace {
  Index face;
  std::array<Point2, 3> corners;
};

/// Lays out a face with the origin of its first side at (0, 0), and its head on the x axis.
LaidFace lay_out(const Mesh& mesh, Index face);
/// Lays out the face beyond a side next to the face of that side.
LaidFace lay_out_beyond(const Mesh& mesh, const LaidFace& laid, Index side);

/// An edge that the sleeve crosses, laid out in the plane.
struct Gate {
  Point2 left, right;
  const Point2& end(bool on_left) const { return on_left ? left : right; }
};
inline Gate gate_of(const LaidFace& laid, Index side) {
  return {laid.corners[Mesh::next(side) % 3], laid.corners[side % 3]};
}

/// A vertex of the sleeve at which a line bends or which it touches.
struct Bend {
  Index vertex = kNone;
  bool left = false;  ///< the side of the sleeve on which it lies
  std::size_t first = 0,
              end = 0;  ///< the crossings of edges at the vertex: from first to before end
  Point2 at = {0, 0};
  /// The angle in the sleeve from the line before to the line behind, in radians: at least pi, up
  /// to rounding.
  double inside = 0;
  double before = 0, behind = 0;  ///< lengths of the line to the bends or ends next to it
};

/// The shortest line in a sleeve.
struct SleeveLine {
  Point2 begin, end;
  std::vector<Gate> gates;  ///< by crossing
  std::vector<Bend> bends;
  double length = 0;
};

/// Returns the shortest line, in time linear in the sleeve: the funnel algorithm (Lee and Preparata
/// 1984, "Euclidean shortest paths in the presence of rectilinear barriers", section 4), in faces
/// laid out in one plane. A vertex that the line touches counts as a bend, up to rounding.
SleeveLine shortest_line(const Mesh& mesh, const Sleeve& sleeve);

/// The angle at a vertex from one direction to another, through the inside of a sleeve on whose
/// left or right the vertex lies: between -pi and pi.
double angle_inside(const Point2& at, const Point2& from, const Point2& to, bool left);

}  // namespace geodesic
