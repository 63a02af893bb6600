#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

/// `verify --solver NAME [--corpus NAME]`: which properties of the conformance suite hold, which
/// fail, and for those the smallest case, the command that reproduces it and where it went wrong.
void add_verify_command(CLI::App& app);

/// The process that examines a solver, started by `verify`.
void add_examine_command(CLI::App& app);

}  // namespace geodesic::harness
