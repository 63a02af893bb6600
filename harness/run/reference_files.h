// Reference distances, computed once per run and kept in the run folder. They come from a closed
// form, brute force, or a solver in a separate process.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <set>
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

class ReferenceFiles {
 public:
  /// @param folder an existing folder in the run folder
  /// @param request names the reference and has the limits; must outlive this object
  /// @param waiting called about once a second while a solver computes a reference, with its name;
  ///        never by two threads at once
  ReferenceFiles(std::filesystem::path folder, const RunRequest& request,
                 std::function<void(const std::string& solver)> waiting)
      : folder_(std::move(folder)), request_(request), waiting_(std::move(waiting)) {}

  /// The reference for this cell (choose_reference of verify/references.h) among the solver that
  /// the suite names, the closed form of the mesh, brute force if the suite names it and the mesh
  /// is small enough, and the ranked solvers that support the mesh. A contradicted oracle is
  /// reported on standard error, once a source.
  /// @throws HarnessError with the reason why each candidate failed
  Reference find(const Cell& cell);

  /// The distances from each further source of the cell's mesh, by the best solver that can verify
  /// the cell's (without arbitration between two: the cell has passed that from its own source).
  /// @throws HarnessError as `find`
  Reference find_further(const Cell& cell);

  /// Computes the references that `find` will need for these cells, of each source in a thread of
  /// its own. They share the memory limit. `find` reports failures, and tries again those that
  /// ran out of memory beside others.
  void compute_ahead(std::span<const Cell* const> cells);

 private:
  // Returns why the distances could not be computed; empty when they were.
  // @param each from each further source, not from the cell's own
  std::string compute(const Cell& cell, const std::string& solver,
                      const std::filesystem::path& file, bool each = false);
  Failure solve(const Cell& cell, const std::string& solver, const std::filesystem::path& file,
                bool each);
  std::filesystem::path file_of(const Cell& cell, const std::string& source,
                                const std::string& by) const;

  std::filesystem::path folder_;
  const RunRequest& request_;
  std::function<void(const std::string&)> waiting_;
  std::size_t at_a_time_ = 1;
  // Guards the containers; each value of the map is for one source, used by one thread.
  std::mutex mutex_;
  std::map<std::string, std::string> tried_;  // results of `compute`, by file name
  std::set<std::string> reported_;            // lines on standard error
};

}  // namespace geodesic::harness
