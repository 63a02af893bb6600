#include "harness/commands/program.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "harness/build_info.h"
#include "harness/cells/interruption.h"
#include "harness/commands/commands.h"
#include "harness/error.h"

namespace geodesic::harness {
namespace {

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

// Commands without a group are the program's own (cells/).
std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    if (!command->get_group().empty()) names.push_back(command->get_name());
  }
  return names;
}

// "no option of solve named '--sorce' (did you mean '--source'?); there are: --help, --solver"
std::string what_exists(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& at = innermost(app);
  const std::vector<std::string> extras = at.remaining();
  const std::vector<std::string> commands = commands_of(at);
  if (!extras.empty() && extras.front().starts_with("-")) {
    return unknown_name("option of " + at.get_name(), extras.front(), options_of(at));
  }
  if (!extras.empty() && !commands.empty()) {
    return unknown_name("command", extras.front(), commands);
  }
  if (!commands.empty()) return "which command? There are: " + join(commands);
  return error.what();
}

int complain(const std::string& message, int code) {
  std::cerr << "geodesic-bench: " << message << '\n';
  return code;
}

}  // namespace

int run_command_line(int argc, char** argv) {
  CLI::App app("Exact geodesic distances on triangle meshes: solvers, and their benchmark",
               "geodesic-bench");
  app.set_version_flag("--version", build_info().version + " (" + build_info().revision + ")");
  app.require_subcommand(1);
  try {
    add_commands(app, join({argv, argv + argc}, " "));
    app.parse(argc, argv);
  } catch (const CLI::RuntimeError& finished) {  // said already why
    return finished.get_exit_code();
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return complain(what_exists(app, error) + " (see --help)", 1);
  } catch (const Interrupted& error) {
    return complain(error.what(), error.exit_code());
  } catch (const WrongAnswer& error) {
    return complain(error.what(), 2);
  } catch (const std::exception& error) {
    return complain(error.what(), 1);
  }
  return 0;
}

}  // namespace geodesic::harness
