#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

/// `solve MESH --solver NAME --source V`: one solve, or with `--each` one a source on several
/// threads; a JSON object on standard output, distances in a file.
void add_solve_command(CLI::App& app);

}  // namespace geodesic::harness
