// Reference distances, computed once a run and kept in the run folder: by a closed form, by brute
// force, or by a solver in a process of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/run/plan.h"

namespace geodesic::harness {

struct Reference {
  std::string solver;  ///< or kClosedForm, kBruteForce
  std::filesystem::path file;
};

class References {
 public:
  /// @param folder exists, in the run folder
  /// @param request names the solver that others are verified by, and the limits; outlives this
  /// @param waiting called about once a second while a solver computes a reference, with its name;
  ///        never by two threads at once
  References(std::filesystem::path folder, const RunRequest& request,
             std::function<void(const std::string& solver)> waiting)
      : folder_(std::move(folder)), request_(request), waiting_(std::move(waiting)) {}

  /// Distances to verify this cell by: from the solver that the suite names, the closed form of the
  /// mesh, brute force where the suite names it and the mesh is small enough, or the best ranked
  /// solver (verify/references.h) that supports the mesh and succeeds.
  /// @throws HarnessError saying why each candidate gave none
  Reference find(const Cell& cell) { return find(cell, /*oracles=*/true); }

  /// The best one that is no independent oracle, where that differs from the given reference, which
  /// is then named on standard error; nothing where both agree or there is none.
  std::optional<Reference> find_other_than(const Reference& oracle, const Cell& cell);

  /// Computes what `find` will need for these cells, for as many sources at a time as there are
  /// threads. Failures are left to `find`.
  void compute_ahead(std::span<const Cell> cells, unsigned threads);

 private:
  Reference find(const Cell& cell, bool oracles);
  // Empty when it was computed; otherwise why not.
  const std::string& compute(const Cell& cell, const std::string& solver,
                             const std::filesystem::path& file);
  std::string solve(const Cell& cell, const std::string& solver, const std::filesystem::path& file);

  std::filesystem::path folder_;
  const RunRequest& request_;
  std::function<void(const std::string&)> waiting_;
  std::mutex mutex_;  // of the map, not of its values: those are of one source, thus of one thread
  std::map<std::string, std::string> tried_;  // by file name: what `compute` returned
};

}  // namespace geodesic::harness
