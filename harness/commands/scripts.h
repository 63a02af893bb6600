#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

/// Adds the commands that are Python modules (the table in scripts.cpp), but for those that the
/// program has already. `geodesic-bench rank WORDS...` becomes `python3 -m gate.rank WORDS...`,
/// with the program's `--plugin` options before WORDS. In its environment PYTHONPATH begins with
/// the data folder (folders.h), and GEODESIC_BENCH is this program.
void add_script_commands(CLI::App& app);

}  // namespace geodesic::harness
