#include "harness/measure/matrix.h"

#include <mutex>
#include <vector>

#include "harness/base/interruption.h"
#include "harness/base/status_line.h"
#include "meshes/row_solver.h"
#include "meshes/threads.h"

namespace geodesic::harness {
namespace {

class RowProgress {
 public:
  RowProgress(std::size_t rows, std::size_t ended) : rows_(rows), ended_(ended) {}
  ~RowProgress() { line_.clear(); }

  void row_ended() {
    const std::lock_guard lock(mutex_);
    ++ended_;
    const double now = watch_.real_seconds();
    if (now - shown_seconds_ < 1) return;
    shown_seconds_ = now;
    line_.show(std::to_string(ended_) + " of " + std::to_string(rows_) + " rows, " + duration(now) +
               " so far");
  }

 private:
  const std::size_t rows_;
  std::size_t ended_;
  double shown_seconds_ = 0;
  StatusLine line_;
  Stopwatch watch_;
  std::mutex mutex_;
};

}  // namespace

void solve_matrix(const MatrixProblem& problem, unsigned threads, MatrixFile& file) {
  std::vector<std::size_t> open;
  for (std::size_t row = 0; row < problem.sources.size(); ++row) {
    if (!file.has(row)) open.push_back(row);
  }
  RowProgress progress(problem.sources.size(), problem.sources.size() - open.size());
  do_in_threads(open.size(), threads, [&]() -> Worker {
    RowSolver row(std::make_shared<PointSolver>(problem.solver, problem.mesh, problem.inserted),
                  problem.mesh, problem.asked);
    return [&, row = std::move(row)](std::size_t i) mutable {
      throw_if_interrupted();
      row.solve(problem.sources[open[i]]);
      file.put(open[i], row.row());
      progress.row_ended();
    };
  });
}

}  // namespace geodesic::harness
