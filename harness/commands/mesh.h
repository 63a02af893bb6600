// `geodesic-bench mesh FILE`: what a mesh file holds and what is wrong with it.
#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

void add_mesh_command(CLI::App& app);

}  // namespace geodesic::harness
