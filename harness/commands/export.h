#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

/// `export --to FORMAT RESULT`: a result file as another tool reads it, on standard output.
void add_export_command(CLI::App& app);

}  // namespace geodesic::harness
