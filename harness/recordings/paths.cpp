#include "harness/recordings/paths.h"

#include <algorithm>

#include "harness/corpus/sources.h"
#include "solvers/core/registry.h"
#include "solvers/paths/paths.h"

namespace geodesic::harness {

FigurePaths solve_figure_paths(const std::string& solver, const Mesh& mesh, const Query& query,
                               std::span<double> distances) {
  const Index first = query.sources.front().at.vertex;
  const std::vector<Index> ends = spread_vertices(mesh, first, kFigurePaths + 1, distances);
  const auto fresh = make_solver(solver, mesh);
  const Paths paths = geodesic::solve_paths(*fresh, mesh, query);
  FigurePaths traced;
  for (const Index target : std::span(ends).subspan(1)) {
    traced.pieces.push_back({target, traced.points.size()});
    for (const PathPoint& point : paths.to_vertex(target).points) {
      traced.points.push_back(point.position);
    }
  }
  std::ranges::copy(paths.distances(), distances.begin());
  return traced;
}

FigureCells solve_figure_cells(const std::string& solver, const Mesh& mesh,
                               const std::vector<Index>& sources) {
  FigureCells cells{.sources = sources, .nearest = {}};
  const auto fresh = make_solver(solver, mesh);
  cells.nearest = geodesic::solve_paths(*fresh, mesh, query_from(sources)).nearest_sources();
  return cells;
}

}  // namespace geodesic::harness
