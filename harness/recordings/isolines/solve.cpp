#include "harness/recordings/isolines/solve.h"

#include "solvers/core/registry.h"

namespace geodesic::harness {

Isolines solve_isolines(const std::string& solver, const Mesh& mesh, const Query& query,
                        std::span<const double> levels, std::span<double> distances) {
  const std::vector<double> known(distances.begin(), distances.end());
  Isolines isolines;
  const ReadWindows read = [&](const FinalWindows& windows) {
    isolines = trace_isolines(mesh, windows, query.sources, known, levels);
  };
  Recording recording;
  recording.what = Record::windows;
  recording.read_windows = &read;
  make_solver(solver, mesh)->solve(query, distances, &recording);
  return isolines;
}

}  // namespace geodesic::harness
