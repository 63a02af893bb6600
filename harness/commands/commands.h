// The commands of geodesic-bench, one file each. Each function adds one command with its options.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace geodesic::harness {

/// Runs geodesic-bench: parses the command line, runs the command, and writes errors as one line to
/// the error stream.
/// @returns the exit code of the process: 0 for success, 1 for a wrong request or an error, 2 for a
///          wrong answer; a command that is a script has its own codes
int run_command_line(int argc, char** argv);

/// `list`: solvers with their descriptions, and the meshes of a corpus.
void add_list_command(CLI::App& app);

/// `mesh FILE`: the contents of a mesh file and its defects.
void add_mesh_command(CLI::App& app);

/// `generate NAME [--parameter value ...] -o FILE` and `generate --list`.
void add_generate_command(CLI::App& app);

/// `solve MESH --solver NAME --source V`: one solve, or with `--each` one solve for each source on
/// several threads. Prints a JSON object and writes distances to a file.
void add_solve_command(CLI::App& app);

/// `path MESH --through POINTS`: paths through several points, closed and straightened on request.
void add_path_command(CLI::App& app);

/// `trace MESH --from POINT --direction X,Y,Z --length L`: a straightest line.
void add_trace_command(CLI::App& app);

/// `verify --solver NAME [--corpus NAME]`: checks properties of solvers. For a failure it prints
/// the smallest case, the command that reproduces it and the place of the error.
void add_verify_command(CLI::App& app);

/// Commands of the processes that `verify` starts. The help does not show them.
void add_check_command(CLI::App& app);

/// `run [SUITE.json] [-- --benchmark_...]`: measures every cell of a suite.
/// @param command_line the complete command line, for the record
void add_run_command(CLI::App& app, const std::string& command_line);

/// `cell SPEC` and `reference SPEC`, the processes that a run starts (run/cell.h). The help does
/// not show them.
void add_cell_commands(CLI::App& app);

/// The commands that are Python modules (the table in scripts.cpp). `geodesic-bench rank WORDS...`
/// becomes `python3 -m gate.rank WORDS...`. Plug-ins among the words are loaded, so that a wrong
/// one is refused, and left out. In its environment PYTHONPATH begins with the data folder
/// (base/files.h), GEODESIC_BENCH is this program, and GEODESIC_PLUGINS has the words that load the
/// plug-ins into it, as a list in JSON.
void add_script_commands(CLI::App& app);

}  // namespace geodesic::harness
