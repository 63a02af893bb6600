// Programs in any language as solvers (docs/external-solvers.md).
#pragma once

#include <filesystem>
#include <string>

#include "solvers/core/solver.h"

namespace geodesic::harness {

/// A program that reads a mesh file and source vertices, and writes distances.
struct ExternalProgram {
  std::string name;
  /// Command for /bin/sh, with placeholders for files and numbers (docs/external-solvers.md).
  std::string command;
  Exactness promise = Exactness::unbounded;
  double error_bound = 0;  ///< of a bounded program
  std::string paper = {}, remarks = {};
  std::string install = {};           ///< advice for when the program cannot be started
  std::filesystem::path folder = {};  ///< folder of its description; empty without one
};

/// Registers an external program as a solver, for the rest of this process and for the processes
/// that it starts.
/// @param word NAME=COMMAND, or a folder with a solver.json
/// @throws HarnessError when the description is broken, the command has no place for the mesh, the
///         sources or the distances, or the name is taken
void add_external_solver(const std::string& word);

/// Loads what an option of the command line names: kPluginOption as load_plugin, kExternalOption as
/// add_external_solver.
void load_by_option(const std::string& option, const std::string& value);

}  // namespace geodesic::harness
