#include "harness/commands/commands.h"

#include "harness/base/error.h"
#include "harness/base/plugins.h"
#include "harness/commands/generate.h"
#include "harness/commands/list.h"
#include "harness/commands/mesh.h"
#include "harness/commands/run.h"
#include "harness/commands/scripts.h"
#include "harness/commands/solve.h"
#include "harness/commands/values.h"
#include "harness/commands/verify.h"

namespace geodesic::harness {
namespace {

// Options are looked at before any command runs.
void add_plugin_option(CLI::App& app) {
  app.add_option_function<std::vector<std::string>>(
         "--plugin",
         [](const std::vector<std::string>& files) {
           for (const std::string& file : files) load_plugin(file);
         },
         "a shared library with more solvers; may be given several times")
      ->allow_extra_args(false)
      ->type_name("FILE");
}

}  // namespace

void add_commands(CLI::App& app, const std::string& command_line) {
  add_list_command(app);
  add_mesh_command(app);
  add_generate_command(app);
  add_solve_command(app);
  add_verify_command(app);
  add_run_command(app, command_line);
  add_plugin_option(app);
  for (CLI::App* command : app.get_subcommands(nullptr)) {
    add_plugin_option(*command);
    check_values(*command);
  }
  check_values(app);
  add_script_commands(app);
  app.get_subcommand("verify")->preparse_callback(
      [command_line](std::size_t) { require_text(command_line); });
  add_cell_commands(app);
  add_examine_command(app);
}

}  // namespace geodesic::harness
