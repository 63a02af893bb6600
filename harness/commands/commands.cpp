#include "harness/commands/commands.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <string_view>
#include <utility>

#include "harness/base/build_info.h"
#include "harness/base/error.h"
#include "harness/base/interruption.h"
#include "harness/base/plugins.h"
#include "harness/commands/values.h"
#include "harness/external/external_program.h"

namespace geodesic::harness {
namespace {

// The options load plug-ins while the command line is parsed, before any command runs.
void add_plugin_options(CLI::App& app) {
  const auto add = [&](const std::string& option, const char* type, const char* help) {
    app.add_option_function<std::vector<std::string>>(
           option,
           [option](const std::vector<std::string>& values) {
             for (const std::string& value : values) load_by_option(option, value);
           },
           help)
        ->allow_extra_args(false)
        ->type_name(type);
  };
  add(kPluginOption, "FILE", "shared library with more solvers; repeatable");
  add(kExternalOption, "NAME=COMMAND",
      "program in any language as a solver: a command with {mesh}, {sources} and {distances}, "
      "or a folder with a solver.json; repeatable");
}

void add_commands(CLI::App& app, const std::string& command_line) {
  add_list_command(app);
  add_mesh_command(app);
  add_generate_command(app);
  add_solve_command(app);
  add_path_command(app);
  add_trace_command(app);
  add_verify_command(app);
  add_run_command(app, command_line);
  add_plugin_options(app);
  for (CLI::App* command : app.get_subcommands(nullptr)) {
    add_plugin_options(*command);
    check_values(*command);
  }
  check_values(app);
  add_script_commands(app);
  app.get_subcommand("verify")->preparse_callback(
      [command_line](std::size_t) { require_text(command_line); });
  add_cell_commands(app);
  add_check_command(app);
}

// The subcommand that the user gave, as far as it was understood.
const CLI::App& innermost(const CLI::App& app) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  return given.empty() ? app : innermost(*given.front());
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    if (option->nonpositional()) names.push_back(option->get_name());
  }
  return names;
}

// Commands without a group are internal: the processes that this program starts.
std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    if (!command->get_group().empty()) names.push_back(command->get_name());
  }
  return names;
}

// "no option of solve named '--sorce' (did you mean '--source'?); there are: --help, --solver"
// Empty when every word is known.
std::string unknown_word(const CLI::App& at) {
  const std::vector<std::string> extras = at.remaining();
  const std::vector<std::string> commands = commands_of(at);
  if (extras.empty() || at.get_allow_extras()) return {};
  if (extras.front().starts_with("-")) {
    return unknown_name("option of " + at.get_name(), extras.front(), options_of(at));
  }
  if (!commands.empty()) return unknown_name("command", extras.front(), commands);
  return at.get_name() + ": unexpected '" + extras.front() + "'";
}

// Replaces messages of CLI11 that would puzzle users.
std::string reworded(const CLI::ParseError& error) {
  const std::string said = error.what(), conversion = "Could not convert: ";
  if (const std::size_t at = said.find(": 1 required"); at != std::string::npos) {
    return said.substr(0, at) + " needs a value";
  }
  for (const auto& [limit, takes] :
       {std::pair(": At Most ", " takes at most "), std::pair(": At least ", " takes at least ")}) {
    const std::string middle = " required but received ";
    const std::size_t at = said.find(limit), received = said.find(middle);
    if (at == std::string::npos || received == std::string::npos) continue;
    const std::size_t number = at + std::string_view(limit).size();
    const std::string count = said.substr(number, received - number);
    return said.substr(0, at) + takes + count + (count == "1" ? " value" : " values") + ", not " +
           said.substr(received + middle.size());
  }
  // Words that are not numbers were refused before (values.h).
  return said.starts_with(conversion) ? said.substr(conversion.size()) + " is too large" : said;
}

std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& at = innermost(app);
  std::string what = unknown_word(at);
  if (what.empty()) {
    const bool no_command = dynamic_cast<const CLI::RequiredError*>(&error) && &at == &app;
    what = no_command ? "which command? There are: " + join(commands_of(app)) : reworded(error);
  }
  return what + " (see geodesic-bench " + (&at == &app ? "" : at.get_name() + ' ') + "--help)";
}

int complain(const std::string& message, int code) {
  std::cerr << "geodesic-bench: " << harmless(message) << '\n';
  return code;
}

// The descriptor of a closed stream would be reused for the next file that is opened, and printed
// text would go to that file. Reading and writing these streams still fails.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

int run(CLI::App& app, int argc, char** argv) {
  try {
    add_commands(app, as_shell_line({argv, argv + argc}));
    std::vector<std::string> words = with_weld_distance({argv + 1, argv + argc});
    std::ranges::reverse(words);  // as CLI11 takes them
    app.parse(std::move(words));
  } catch (const CLI::RuntimeError& finished) {  // its message has been printed
    return finished.get_exit_code();
  } catch (const CLI::Success& help) {
    const std::string unknown = unknown_word(innermost(app));
    return unknown.empty() ? app.exit(help) : complain(unknown, 1);
  } catch (const CLI::ParseError& error) {
    return complain(explain(app, error), 1);
  } catch (const Interrupted& error) {
    return complain(error.what(), error.exit_code());
  } catch (const WrongAnswer& error) {
    return complain(error.what(), 2);
  } catch (const std::exception& error) {
    return complain(error.what(), 1);
  }
  return 0;
}

// On a full disk the exit code is an error.
int finish(int code) {
  if (std::cout.flush()) return code;
  return complain(
      "standard output could not be written completely: is it closed, or the disk full?",
      std::max(code, 1));
}

}  // namespace

int run_command_line(int argc, char** argv) {
  occupy_closed_streams();
  CLI::App app("Exact geodesic distances on triangle meshes: solvers and their benchmark",
               "geodesic-bench");
  app.set_version_flag("--version", build_info().version + " (" + build_info().revision + ")");
  app.require_subcommand(1);
  return finish(run(app, argc, argv));
}

}  // namespace geodesic::harness
