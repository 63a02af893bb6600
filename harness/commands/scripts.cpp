#include "harness/commands/commands.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/json.h"
#include "harness/base/plugins.h"
#include "harness/base/process.h"
#include "harness/external/external_program.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

// A command that is a Python module below the data folder.
struct Script {
  const char* name;
  const char* module;
  const char* help;
};

constexpr Script kScripts[] = {
    {"compare", "gate.compare", "Compare two finished runs, cell by cell and overall"},
    {"rank", "gate.rank", "Rank a solver against others by interleaved times"},
    {"merge", "results.merge", "Join the shards of a run (run --shard K/N)"},
    {"report", "plots.report", "Draw the tables, figures and the HTML report of a run"},
    {"plot", "plots", "Draw only the tables and figures of a run that are named"},
    {"view", "view", "Make a page that turns a model and plays the wavefronts of solvers"},
    {"check", "gate.check_run", "Check a run: verified cells, complete counters, known failures"},
    {"publish", "gate.publish", "Write a run as a file to contribute"},
    {"check-result", "gate.check_result", "Check a contributed result file"},
};

constexpr const char* kHasPackages =
    "import importlib.util as u, sys; "
    "sys.exit(sys.version_info < (3, 11) or not all(map(u.find_spec, "
    "('numpy', 'scipy', 'matplotlib'))))";

bool has_packages(const fs::path& python) {
  if (access(python.c_str(), X_OK) != 0) return false;
  return run_program(python, {"-c", kHasPackages}, [] {}).succeeded();
}

// Tries Debian's interpreter first: the documentation names its packages, and another python3 on
// the PATH may lack them.
fs::path find_python() {
  std::string folders = "/usr/bin";
  if (const char* path = std::getenv("PATH")) folders += std::string(":") + path;
  std::istringstream list(folders);
  for (std::string folder; std::getline(list, folder, ':');) {
    fs::path python = fs::path(folder) / "python3";
    if (has_packages(python)) return python;
  }
  throw HarnessError(
      "no python3 (3.11 or newer) with numpy, scipy and matplotlib was found: install Debian's "
      "packages python3-numpy, python3-scipy and python3-matplotlib");
}

void set_environment() {
  std::string path = data_folder().string();
  if (const char* others = std::getenv("PYTHONPATH"); others != nullptr && *others != '\0') {
    path += std::string(":") + others;
  }
  setenv("PYTHONPATH", path.c_str(), 1);
  setenv("GEODESIC_BENCH", fs::read_symlink("/proc/self/exe").c_str(), 1);
  setenv("GEODESIC_PLUGINS", Json(plugin_arguments()).dump().c_str(), 1);
}

// Loads the plug-ins among the words before "--". Returns the other words.
std::vector<std::string> load_plugins(const std::vector<std::string>& words) {
  const auto end = std::ranges::find(words, "--");
  std::vector<std::string> others;
  for (auto word = words.begin(); word != end; ++word) {
    const std::size_t equals = word->find('=');
    const std::string option = word->substr(0, equals);
    if (option != kPluginOption && option != kExternalOption) {
      others.push_back(*word);
    } else if (equals != std::string::npos) {
      load_by_option(option, word->substr(equals + 1));
    } else if (++word != end) {
      load_by_option(option, *word);
    } else {
      throw HarnessError(option + " needs a value");
    }
  }
  others.insert(others.end(), end, words.end());
  return others;
}

// Replaces this process, so that the exit code and signals are those of the script.
[[noreturn]] void run_script(const Script& script, const std::vector<std::string>& arguments) {
  const std::string python = find_python();
  // With -P, modules of the current folder cannot replace those of the program.
  std::vector<std::string> words{python, "-P", "-m", script.module};
  const std::vector<std::string> others = load_plugins(arguments);
  words.insert(words.end(), others.begin(), others.end());
  const std::vector<char*> argv = argv_of(words);
  set_environment();
  std::cout.flush();
  execv(python.c_str(), argv.data());
  throw HarnessError("cannot start " + python + ": " + std::strerror(errno));
}

}  // namespace

void add_script_commands(CLI::App& app) {
  for (const Script& script : kScripts) {
    const auto is_taken = [&](const CLI::App* other) { return other->get_name() == script.name; };
    if (std::ranges::any_of(app.get_subcommands(nullptr), is_taken)) continue;
    CLI::App* command = app.add_subcommand(script.name, script.help);
    command->prefix_command()->set_help_flag();  // the script gets all words, --help too
    command->callback([command, &script] { run_script(script, command->remaining()); });
  }
}

}  // namespace geodesic::harness
