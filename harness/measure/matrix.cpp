#include "harness/measure/matrix.h"

#include <vector>

#include "harness/base/interruption.h"
#include "harness/base/status_line.h"
#include "meshes/row_solver.h"
#include "meshes/threads.h"

namespace geodesic::harness {

void solve_matrix(const MatrixProblem& problem, PointSolver solver, unsigned threads,
                  MatrixFile& file) {
  std::vector<std::size_t> open;
  for (std::size_t row = 0; row < problem.sources.size(); ++row) {
    if (!file.has(row)) open.push_back(row);
  }
  SolverForEachThread solvers(std::move(solver));
  CountLine progress(problem.sources.size(), "rows", problem.sources.size() - open.size());
  do_in_threads(open.size(), threads, [&]() -> Worker {
    RowSolver row(solvers.next(), problem.mesh, problem.asked);
    return [&, row = std::move(row)](std::size_t i) mutable {
      throw_if_interrupted();
      row.solve(problem.sources[open[i]]);
      file.put(open[i], row.row());
      progress.ended();
    };
  });
}

}  // namespace geodesic::harness
