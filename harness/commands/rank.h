// geodesic-bench rank: one solver against others, in paired times.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace geodesic::harness {

/// @param command_line as given, for the record
void add_rank_command(CLI::App& app, const std::string& command_line);

}  // namespace geodesic::harness
