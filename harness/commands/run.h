#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

/// `run [SUITE.json] [-- --benchmark_...]`: measures every cell of a suite.
/// @param command_line the whole of it, for the record
void add_run_command(CLI::App& app, const std::string& command_line);

/// `cell SPEC` and `reference SPEC`, which a run starts itself again as; not shown in the help.
void add_cell_commands(CLI::App& app);

}  // namespace geodesic::harness
