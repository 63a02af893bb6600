// The work of `geodesic-bench verify`: a solver held to all that the contract promises, with a line
// for each property.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/verify/random_check.h"

namespace geodesic::harness {

struct VerifyRequest {
  std::vector<std::string> solvers;    ///< one; random meshes: any, or all
  std::optional<RandomMeshes> random;  ///< on these alone
  std::string property;                ///< this one alone; empty: all
  std::string corpus;                  ///< on its meshes the distances too; empty: none
  std::vector<std::string> meshes;     ///< names or files, on which likewise
  std::vector<Source> sources;         ///< on those; empty: some of each
  bool each = false;                   ///< every source is a query of its own
  double limit = kInfinity;
  double time_limit = 60;     ///< seconds that a property may take
  double shrink = 20;         ///< seconds spent on making a failing mesh smaller; 0 saves none
  std::filesystem::path out;  ///< folder for failing meshes; empty: failures-NAME, of the solver,
                              ///< and failures for random ones
  std::string vectors;        ///< corpus/solvers.h
  std::filesystem::path manifest;
};

/// Prints to standard output what holds and what fails, the smallest case of the first failures,
/// and what explains them.
/// @return whether nothing fails
/// @throws HarnessError when nothing fails, but something could not be checked
bool verify_solver(const VerifyRequest& request);

}  // namespace geodesic::harness
