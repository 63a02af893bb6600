// The work of `geodesic-bench verify`: checks every property that the contract requires of a solver
// and prints a line for each.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/verify/random_check.h"

namespace geodesic::harness {

struct VerifyRequest {
  std::vector<std::string> solvers;    ///< one; for random meshes any number, none for all
  std::optional<RandomMeshes> random;  ///< check on random meshes only
  std::filesystem::path file;          ///< the only case to check (saved_case.h); empty: none
  std::string property;                ///< the only one to check; empty: all
  std::string corpus;                  ///< whose meshes are checked, too; empty: none
  std::vector<std::string> meshes;     ///< names or files of more meshes to check
  std::vector<Source> sources;         ///< on the meshes above; empty: some vertices of each
  bool each = false;                   ///< every source is a query of its own
  double limit = kInfinity;
  double time_limit = 60;     ///< seconds per property
  double shrink = 20;         ///< seconds for making a failing mesh smaller; with 0 none is saved
  std::filesystem::path out;  ///< folder for failing meshes; empty: failures-SOLVER, or
                              ///< failures for random meshes
  std::string vectors;        ///< name of the instruction set (corpus/solvers.h)
  std::filesystem::path manifest;
};

/// Prints to standard output which properties hold and which fail, and the smallest cases of the
/// first failures with explanations.
/// @return whether nothing fails
/// @throws HarnessError when nothing fails, but something could not be checked
bool verify_solver(const VerifyRequest& request);

}  // namespace geodesic::harness
