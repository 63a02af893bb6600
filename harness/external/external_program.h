// Programs in any language as solvers (docs/external-solvers.md).
#pragma once

#include <filesystem>
#include <string>

#include "solvers/core/solver.h"

namespace geodesic::harness {

/// A program that reads a mesh file and source vertices, and writes distances.
struct ExternalProgram {
  std::string name;
  /// For /bin/sh, with places for files and numbers (docs/external-solvers.md).
  std::string command;
  Exactness promise = Exactness::unbounded;
  double error_bound = 0;  ///< of a bounded one
  std::string paper = {}, remarks = {};
  std::string install = {};           ///< what to do where it cannot be started
  std::filesystem::path folder = {};  ///< of its description; empty without one
};

/// Registers an external program as a solver, for the rest of the process and for those that it
/// starts.
/// @param word NAME=COMMAND, or a folder with a solver.json
/// @throws HarnessError for a broken description, a command without a place for the mesh, the
///         sources or the distances, and a name that is taken
void add_external_solver(const std::string& word);

}  // namespace geodesic::harness
