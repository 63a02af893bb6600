#include "solvers/core/start.h"

#include <utility>

#include "solvers/core/tolerance.h"

namespace geodesic {
namespace {

void add_point(const Mesh& mesh, const InternalSource& source, Index root, Start& start) {
  std::vector<StartWindow> windows;
  bool at_corner = false;
  spread_from(
      mesh, source.at,
      [&](Index h, const Point2& from, double to_apex, bool is_next) {
        start.vertices.push_back(
            {mesh.apex(h), source.distance + to_apex, is_next, {h, root, from}});
        at_corner |= 2 * to_apex < kCoordinateRounding * mesh.half_edge(h).length;
      },
      [&](Index h, const Point2& from) {
        const double length = mesh.half_edge(h).length;
        windows.push_back({h, {0, length, from.x, from.y, source.distance}, root});
      });
  if (!at_corner) start.windows.insert(start.windows.end(), windows.begin(), windows.end());
}

}  // namespace

Start::Start(const Mesh& mesh, InternalQuery lowered) : query(std::move(lowered)) {
  for (Index i = 0; i < query.sources.size(); ++i) {
    const InternalSource& source = query.sources[i];
    if (source.at.is_vertex()) {
      const Index v = source.at.vertex;
      vertices.push_back({v, source.distance, true, {kNone, v, {0, 0}}});
    } else {
      add_point(mesh, source, mesh.vertex_count() + i, *this);
    }
  }
}

}  // namespace geodesic
