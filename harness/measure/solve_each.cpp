#include "harness/measure/solve_each.h"

#include <map>
#include <mutex>

#include "harness/base/clock.h"
#include "meshes/row_solver.h"
#include "meshes/threads.h"

namespace geodesic::harness {
namespace {

/// Accepts items in any order, from several threads, and delivers them in order.
class InOrder {
 public:
  explicit InOrder(const std::function<void(Kept)>& deliver) : deliver_(deliver) {}

  void put(std::size_t position, Kept item) {
    const std::lock_guard lock(mutex_);
    early_.emplace(position, std::move(item));
    for (auto first = early_.begin(); first != early_.end() && first->first == next_;
         first = early_.erase(first)) {
      deliver_(std::move(first->second));
      ++next_;
    }
  }

 private:
  const std::function<void(Kept)>& deliver_;
  std::mutex mutex_;
  std::map<std::size_t, Kept> early_;  // items that wait for an earlier one
  std::size_t next_ = 0;
};

}  // namespace

void solve_each(PointSolver solver, const Mesh& mesh, std::span<const std::vector<Source>> sets,
                const Query& asked, unsigned threads,
                const std::function<Kept(const SingleSolve&)>& keep,
                const std::function<void(Kept)>& deliver) {
  InOrder results(deliver);
  SolverForEachThread solvers(std::move(solver));
  do_in_threads(sets.size(), threads, [&]() -> Worker {
    RowSolver row(solvers.next(), mesh, asked);
    return [&, row = std::move(row)](std::size_t i) mutable {
      const double cpu_start = thread_cpu_seconds();
      const Stopwatch watch;
      row.solve(sets[i]);
      results.put(i, keep({.number = i,
                           .distances = row.distances(),
                           .at_targets = row.at_targets(),
                           .cpu_seconds = thread_cpu_seconds() - cpu_start,
                           .real_seconds = watch.real_seconds(),
                           .instruction_set = row.instruction_set()}));
    };
  });
}

}  // namespace geodesic::harness
