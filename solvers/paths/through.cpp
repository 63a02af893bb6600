#include "solvers/paths/through.h"

#include <stdexcept>

#include "solvers/paths/paths.h"
#include "solvers/paths/straighten.h"

namespace geodesic {

Path path_through(Solver& solver, const Mesh& mesh, std::span<const SurfacePoint> points,
                  const ThroughOptions& options) {
  if (points.size() < 2) throw std::invalid_argument("a path through points needs at least two");
  Path path;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i + 1 == points.size() && !options.closed) break;
    const SurfacePoint& to = points[(i + 1) % points.size()];
    const Query piece{.sources = {{.at = points[i]}}, .targets = {to}, .stop_at_targets = true};
    const Path next = solve_paths(solver, mesh, piece).to_target(0);
    if (i == 0) {
      path = next;
    } else {
      append(path, next);
    }
  }
  return options.straighten ? straightened(mesh, path, options.closed) : path;
}

}  // namespace geodesic
