#pragma once

namespace geodesic::harness {

/// The whole of geodesic-bench: understands the command line, does what it says, and complains on
/// the error stream in one line.
/// @returns the process's exit code: 0 good, 1 a wrong request or an error, 2 a wrong answer,
///          3 a comparison above its limits
int run_command_line(int argc, char** argv);

}  // namespace geodesic::harness
