#include "tests/isolines/traced.h"

#include <algorithm>

#include "solvers/core/registry.h"

namespace geodesic::harness {

std::span<const Vec3> Traced::points(std::size_t piece) const {
  const auto& pieces = isolines.pieces;
  const std::size_t first = pieces[piece].first;
  const std::size_t end =
      piece + 1 < pieces.size() ? pieces[piece + 1].first : isolines.points.size();
  return {isolines.points.data() + first, end - first};
}

std::vector<std::string> solvers_with_windows() {
  std::vector<std::string> names;
  for (const Description* solver : registered_solvers()) {
    if (solver->final_windows) names.push_back(solver->name);
  }
  return names;
}

Traced trace(const std::string& solver, const Mesh& mesh, const std::vector<Source>& sources,
             std::vector<double> levels) {
  Traced traced{.distances = std::vector<double>(mesh.vertex_count()),
                .levels = std::move(levels),
                .isolines = {},
                .windows = std::vector<std::vector<Window>>(mesh.half_edge_count())};
  const auto object = make_solver(solver, mesh);
  const Query query{.sources = sources};
  object->solve(query, traced.distances);
  if (traced.levels.empty()) traced.levels = isoline_levels(traced.distances);
  const ReadWindows read = [&](const FinalWindows& windows) {
    traced.isolines = trace_isolines(mesh, windows, sources, traced.distances, traced.levels);
    for (Index h = 0; h < mesh.half_edge_count(); ++h) {
      if (h < mesh.twin(h)) windows(h, traced.windows[h]);
    }
  };
  Recording recording;
  recording.what = Record::windows;
  recording.read_windows = &read;
  object->solve(query, traced.distances, &recording);
  return traced;
}

}  // namespace geodesic::harness
