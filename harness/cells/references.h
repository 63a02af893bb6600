// Reference distances, computed once a run and kept in the run folder: by a closed form, or by a
// solver in a process of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/cells/plan.h"

namespace geodesic::harness {

struct Reference {
  std::string solver;  ///< or kClosedForm
  std::filesystem::path file;
};

class References {
 public:
  /// @param folder exists
  /// @param named the solver that the suite wants others to be verified by
  /// @param waiting called about once a second while a solver works: with whose reference it is
  References(std::filesystem::path folder, std::optional<std::string> named,
             std::function<void(const std::string& solver)> waiting)
      : folder_(std::move(folder)), named_(std::move(named)), waiting_(std::move(waiting)) {}

  /// Distances to verify this cell by: from the solver that the suite names, the closed form of the
  /// mesh, or the best ranked solver (verify/choose.h) that supports the mesh and succeeds.
  /// @throws HarnessError saying why each candidate gave none
  Reference find(const Cell& cell);

 private:
  std::vector<std::string> candidates(const Cell& cell) const;
  // Empty when it was computed; otherwise why not.
  const std::string& compute(const Cell& cell, const std::string& solver,
                             const std::filesystem::path& file);
  std::string solve(const Cell& cell, const std::string& solver,
                    const std::filesystem::path& file) const;

  std::filesystem::path folder_;
  std::optional<std::string> named_;
  std::function<void(const std::string&)> waiting_;
  std::map<std::string, std::string> tried_;  // by file name: what `compute` returned
};

}  // namespace geodesic::harness
