#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace geodesic::harness {

/// Adds every command of geodesic-bench.
/// @param command_line the whole of it, for the record
void add_commands(CLI::App& app, const std::string& command_line);

}  // namespace geodesic::harness
