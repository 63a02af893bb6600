// Plug-ins: solvers that are not part of the program, in shared libraries or as programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geodesic::harness {

inline constexpr const char* kPluginOption = "--plugin";
inline constexpr const char* kExternalOption = "--external";

struct Plugin {
  std::string option;  ///< that loads it: kPluginOption or kExternalOption
  std::string value;   ///< value of the option; for --plugin the file, absolute and without links
  std::string sha256;
  std::vector<std::string> solvers;  ///< names under which they were registered
};

/// Loads a library for the rest of the process and registers its solvers like those of the program.
/// @throws HarnessError when the file does not exist, is loaded already, is not a shared library,
///         lacks a symbol or registers no solver, or when a solver has another version of the
///         contract (solvers/core/solver.h) or a name that is taken
void load_plugin(const std::filesystem::path& file);

/// Adds a plug-in whose solvers were registered in another way.
void note_plugin(Plugin plugin);

/// The arguments that make another process of this program load the same plug-ins.
std::vector<std::string> plugin_arguments();

/// The plug-ins in the order of loading.
const std::vector<Plugin>& loaded_plugins();

/// A word in the syntax of a shell: unchanged, or between apostrophes.
std::string quoted(const std::string& word);

/// One line for a shell.
std::string as_shell_line(const std::vector<std::string>& words);

/// One line for a shell: this program as it was called, its plug-ins, then the arguments.
std::string as_command_line(const std::vector<std::string>& arguments);

}  // namespace geodesic::harness
