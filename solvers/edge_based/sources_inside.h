// Sources that are points of faces or edges, not vertices.
#pragma once

#include <vector>

#include "solvers/core/surface_point.h"
#include "solvers/core/tolerance.h"
#include "solvers/core/window.h"

namespace geodesic::edge_based {

/// A wavefront (wavefront.h), and a point of a face of its mesh.
template <class Wavefront>
struct Part {
  Wavefront& wavefront;
  InternalPoint point;
};
template <class Wavefront>
Part(Wavefront&, const InternalPoint&) -> Part<Wavefront>;

/// Starts from a point.
///
/// Next to a corner, rounding of coordinates turns the lines on both sides of it, and may leave a
/// gap behind it. The corner therefore sends windows too, as a source does. They are as long or
/// longer, and soon beaten. If the point is so near to the corner that rounding exceeds the way
/// there and back, its own lines have no direction, and only the corner's are used.
/// @param faces the point in each of its faces
/// @param root as in LastSegment
/// @param part_of returns the Part that works on a face
template <class PartOf>
[[gnu::cold, gnu::noinline]] void begin_inside(const std::vector<InternalPoint>& faces,
                                               double distance, Index root, const PartOf& part_of) {
  bool at_corner = false;
  for (const InternalPoint& in_face : faces) {
    const auto part = part_of(in_face);
    const Mesh& mesh = part.wavefront.mesh();
    spread_in_face(
        mesh, part.point,
        [&](Index h, const Point2& from, double to_apex, bool is_next) {
          const Index apex = mesh.apex(h);
          part.wavefront.reach_first(apex, distance + to_apex, {h, root, from});
          if (is_next) part.wavefront.set_always_emits(apex);
          at_corner |= 2 * to_apex < kCoordinateRounding * mesh.half_edge(h).length;
        },
        [](Index, const Point2&) {});
  }
  if (at_corner) return;
  for (const InternalPoint& in_face : faces) {
    const auto part = part_of(in_face);
    spread_in_face(
        part.wavefront.mesh(), part.point, [](Index, const Point2&, double, bool) {},
        [&](Index h, const Point2& from) {
          part.wavefront.crossing().emit(h, from, distance, root, part.wavefront);
        });
  }
}

}  // namespace geodesic::edge_based
