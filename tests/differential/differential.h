// Every exact solver on many random meshes, against brute force, an independent oracle, or another.
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "tests/differential/random_case.h"

namespace geodesic::differential {

struct Request {
  std::uint64_t meshes = 200;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> only;  ///< this mesh of the seed alone
  unsigned jobs = 1;
  std::vector<std::string> solvers;  ///< empty: all that are not unbounded
  std::filesystem::path out;         ///< folder for failing meshes
  double shrink = 30;                ///< seconds spent on making a failing mesh smaller
};

/// Solves all meshes, prints how far the solvers are apart and, of each solver's first disagreement
/// beyond the tolerance of its kind of mesh, a small mesh and commands that repeat it.
/// @return whether there was none
/// @throws HarnessError when a file cannot be written
bool run_differential(const Request& request, std::ostream& report);

}  // namespace geodesic::differential
