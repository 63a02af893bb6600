#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

/// `list`: solvers with their descriptions, and the meshes of a corpus.
void add_list_command(CLI::App& app);

}  // namespace geodesic::harness
