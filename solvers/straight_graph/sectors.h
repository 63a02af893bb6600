// Directions around vertices, and which of them go straight on.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "solvers/core/mesh.h"
#include "solvers/straight_graph/graph.h"

namespace geodesic::straight_graph {

/// The angle of the vector (x, y) in radians, from -pi to pi, within 2e-5; 0 for the zero vector.
/// It decides nothing but sectors, which are thousands of times as wide.
inline double rough_angle(double y, double x) {
  const double ax = std::abs(x), ay = std::abs(y);
  const double most = std::max(ax, ay), least = std::min(ax, ay);
  const double t = most > 0 ? least / most : 0, s = t * t;
  // Abramowitz and Stegun 4.4.49, for tangents up to 1.
  double a =
      t * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
  a = ay > ax ? std::numbers::pi / 2 - a : a;
  a = x < 0 ? std::numbers::pi - a : a;
  return y < 0 ? -a : a;
}

/// The angle of a face's corner at the origin of a half-edge.
inline double corner_angle(const HalfEdge& e) { return rough_angle(e.apex_y, e.apex_x); }

/// For each vertex, the angles from some half-edge counter-clockwise to every other one. At a
/// boundary the way round outside of the surface counts as pi, since a path may bend there by any
/// angle to that side. Several fans at a vertex lie side by side, pi apart.
class Sectors {
 public:
  explicit Sectors(const Mesh& mesh);

  /// The direction of a half-edge at its origin, in radians from 0.
  double direction(Index h) const { return direction_[h]; }

  /// @param direction at vertex v in radians; may be beyond the full circle by rounding
  unsigned sector(Index v, double direction) const {
    const int s = static_cast<int>(direction * per_radian_[v]);
    return static_cast<unsigned>(std::clamp(s, 0, static_cast<int>(kSectors) - 1));
  }

  /// Sets Block::shift and width so that a path may go on wherever the angles on both of its sides
  /// are at least pi minus `slack`, and in parts of the two sectors beside. At a corner of a face
  /// so flat (kFlatFace) that rounding dominates its angles, it may go on in all.
  void set_straight_on(Index v, double slack, Block& block) const;

 private:
  /// Gives the half-edges from h on their directions, from `from` on. @return the angle behind them
  double lay_out_fan(const Mesh& mesh, Index h, double from);

  std::vector<float> direction_;            // by half-edge
  std::vector<float> per_radian_;           // by vertex: sectors per radian
  std::vector<std::uint8_t> is_uncertain_;  // by vertex: corner of a flat face
};

}  // namespace geodesic::straight_graph
