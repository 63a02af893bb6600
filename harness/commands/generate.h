#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

/// `generate NAME [--parameter value ...] -o FILE` and `generate --list`.
void add_generate_command(CLI::App& app);

}  // namespace geodesic::harness
