// Reference distances, computed once a run by a process of their own and kept in the run folder.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "harness/cells/plan.h"

namespace geodesic::harness {

struct Reference {
  std::string solver;
  std::filesystem::path file;
};

class References {
 public:
  /// @param folder exists
  /// @param named the solver that the suite wants others to be verified by
  References(std::filesystem::path folder, std::optional<std::string> named)
      : folder_(std::move(folder)), named_(std::move(named)) {}

  /// Distances to verify this cell by, from the best ranked solver (verify/choose.h) that supports
  /// the mesh and succeeds.
  /// @throws HarnessError saying why each candidate gave none
  Reference find(const Cell& cell);

 private:
  // Empty when it was computed; otherwise why not.
  const std::string& compute(const Cell& cell, const std::string& solver,
                             const std::filesystem::path& file);

  std::filesystem::path folder_;
  std::optional<std::string> named_;
  std::map<std::string, std::string> tried_;  // by file name: what `compute` returned
};

}  // namespace geodesic::harness
