// The commands of geodesic-bench, one file each. Each function adds one with its options.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace geodesic::harness {

/// The whole of geodesic-bench: parses the command line, runs the command, and writes errors to the
/// error stream in one line.
/// @returns the process's exit code: 0 good, 1 a wrong request or an error, 2 a wrong answer; a
///          command that is a script has its own
int run_command_line(int argc, char** argv);

/// `list`: solvers with their descriptions, and the meshes of a corpus.
void add_list_command(CLI::App& app);

/// `mesh FILE`: the contents of a mesh file and its defects.
void add_mesh_command(CLI::App& app);

/// `generate NAME [--parameter value ...] -o FILE` and `generate --list`.
void add_generate_command(CLI::App& app);

/// `solve MESH --solver NAME --source V`: one solve, or with `--each` one for each source on
/// several threads; a JSON object on standard output, distances in a file.
void add_solve_command(CLI::App& app);

/// `verify --solver NAME [--corpus NAME]`: which properties of solvers hold, which
/// fail, and for those the smallest case, the command that reproduces it and where it went wrong.
void add_verify_command(CLI::App& app);

/// The processes that `verify` starts; not shown in the help.
void add_check_commands(CLI::App& app);

/// `run [SUITE.json] [-- --benchmark_...]`: measures every cell of a suite.
/// @param command_line the whole of it, for the record
void add_run_command(CLI::App& app, const std::string& command_line);

/// `cell SPEC` and `reference SPEC`, the processes that a run starts (cells/cell.h); not shown in
/// the help.
void add_cell_commands(CLI::App& app);

/// The commands that are Python modules (the table in scripts.cpp). `geodesic-bench rank WORDS...`
/// becomes `python3 -m gate.rank WORDS...`, with the program's `--plugin` options before WORDS. In
/// its environment PYTHONPATH begins with the data folder (base/files.h), and GEODESIC_BENCH is
/// this program.
void add_script_commands(CLI::App& app);

}  // namespace geodesic::harness
