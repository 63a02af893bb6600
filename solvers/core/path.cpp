#include "solvers/core/path.h"

#include <algorithm>
#include <cmath>

namespace geodesic {
namespace {

bool lies_on(const Mesh& mesh, Index face, const InternalPoint& point) {
  if (point.is_vertex()) return std::ranges::count(mesh.triangle(face), point.vertex) > 0;
  if (point.face == face) return true;
  const Index under = edge_under(point);
  return under != kNone && mesh.twin(under) != kNone && mesh.twin(under) / 3 == face;
}

/// A face that contains both points; kNone when there is none.
Index face_of(const Mesh& mesh, const InternalPoint& a, const InternalPoint& b) {
  if (a.is_vertex()) {
    const auto faces = mesh.outgoing(a.vertex);
    const auto shared =
        std::ranges::find_if(faces, [&](Index h) { return lies_on(mesh, h / 3, b); });
    return shared == faces.end() ? kNone : *shared / 3;
  }
  if (lies_on(mesh, a.face, b)) return a.face;
  const Index under = edge_under(a), twin = under == kNone ? kNone : mesh.twin(under);
  return twin != kNone && lies_on(mesh, twin / 3, b) ? twin / 3 : kNone;
}

}  // namespace

void append(Path& path, const Path& next) {
  const double before = path.length();
  path.points.back().face = next.points.front().face;
  for (std::size_t i = 1; i < next.points.size(); ++i) {
    path.points.push_back(next.points[i]);
    path.points.back().travelled += before;
  }
}

Path path_of_points(const Mesh& mesh, const InternalQuery& query,
                    std::span<const InternalPoint> points) {
  const auto source = std::ranges::find(query.sources, points.front(), &InternalSource::at);
  Path path{.source = static_cast<Index>(source - query.sources.begin()), .points = {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    PathPoint point{.at = in_external_numbers(mesh, points[i]),
                    .position = position_of(mesh, points[i])};
    if (i > 0) {
      PathPoint& before = path.points.back();
      const Index face = face_of(mesh, points[i - 1], points[i]);
      before.face = face == kNone ? kNone : mesh.numbers().external_face(face);
      point.travelled = before.travelled + norm(subtract(point.position, before.position));
    }
    path.points.push_back(point);
  }
  return path;
}

}  // namespace geodesic
