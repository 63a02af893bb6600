#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

/// `compare OLD NEW`: two finished runs, cell by cell and overall. Exit code 2 when the new one has
/// a wrong answer, else 3 when something exceeds `--fail-on`.
void add_compare_command(CLI::App& app);

}  // namespace geodesic::harness
