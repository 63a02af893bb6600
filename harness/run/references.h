// Reference distances, computed once per run and kept in the run folder. They come from a closed
// form, brute force, or a solver in a separate process.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/run/cell.h"
#include "harness/run/plan.h"

namespace geodesic::harness {

struct Reference {
  std::string solver;  ///< name of a solver, kClosedForm or kBruteForce
  std::filesystem::path file;
};

class References {
 public:
  /// @param folder an existing folder in the run folder
  /// @param request names the reference and has the limits; must outlive this object
  /// @param waiting called about once a second while a solver computes a reference, with its name;
  ///        never by two threads at once
  References(std::filesystem::path folder, const RunRequest& request,
             std::function<void(const std::string& solver)> waiting)
      : folder_(std::move(folder)), request_(request), waiting_(std::move(waiting)) {}

  /// The reference for this cell: the solver that the suite names, the closed form of the mesh,
  /// brute force if the suite names it and the mesh is small enough, or the best ranked solver
  /// (verify/references.h) that supports the mesh and succeeds.
  /// @throws HarnessError with the reason why each candidate failed
  Reference find(const Cell& cell) { return find(cell, /*oracles=*/true); }

  /// The best reference that is no independent oracle, if it differs from `oracle`. The difference
  /// is reported on standard error. Nothing when both agree or there is no other reference.
  std::optional<Reference> find_other_than(const Reference& oracle, const Cell& cell);

  /// Computes the references that `find` will need for these cells, of each source in a thread of
  /// its own. They share the memory limit. `find` reports failures, and tries again those that
  /// ran out of memory beside others.
  void compute_ahead(std::span<const Cell* const> cells);

 private:
  Reference find(const Cell& cell, bool oracles);
  // Returns why the distances could not be computed; empty when they were.
  std::string compute(const Cell& cell, const std::string& solver,
                             const std::filesystem::path& file);
  Failure solve(const Cell& cell, const std::string& solver, const std::filesystem::path& file);

  std::filesystem::path folder_;
  const RunRequest& request_;
  std::function<void(const std::string&)> waiting_;
  std::size_t at_a_time_ = 1;
  std::mutex mutex_;  // guards the map; each of its values is for one source, used by one thread
  std::map<std::string, std::string> tried_;  // results of `compute`, by file name
};

}  // namespace geodesic::harness
