// Plug-ins: solvers that are not part of the program, in shared libraries or as programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geodesic::harness {

struct Plugin {
  std::string option;  ///< that names it: "--plugin", "--external"
  std::string value;   ///< of the option; of --plugin the file, absolute and without links
  std::string sha256;
  std::vector<std::string> solvers;  ///< names, as they were registered
};

/// Loads the library for the rest of the process; its solvers are then registered like those of
/// the program.
/// @throws HarnessError when there is no such file, it is loaded already, it is not a shared
///         library or lacks a symbol, or it registers no solver, one of another version of the
///         contract (solvers/core/solver.h), or one whose name is taken
void load_plugin(const std::filesystem::path& file);

/// Adds what registers solvers in another way. @param plugin whose solvers are registered
void note_plugin(Plugin plugin);

/// The arguments that make another process of this program load the same plug-ins.
std::vector<std::string> plugin_arguments();

/// In the order of loading.
const std::vector<Plugin>& loaded_plugins();

/// A word as a shell takes it: unchanged, or between apostrophes.
std::string quoted(const std::string& word);

/// As one line for a shell, with this program as it was called and its plug-ins in front.
std::string as_command_line(const std::vector<std::string>& arguments);

}  // namespace geodesic::harness
