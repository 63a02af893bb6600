#include "harness/commands/commands.h"

#include "harness/base/error.h"
#include "harness/base/plugins.h"
#include "harness/commands/compare.h"
#include "harness/commands/export.h"
#include "harness/commands/generate.h"
#include "harness/commands/list.h"
#include "harness/commands/mesh.h"
#include "harness/commands/rank.h"
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

// Result files keep the command line, and names from it, as JSON.
void require_text(CLI::App& command, const std::string& command_line) {
  command.preparse_callback([command_line](std::size_t) {
    if (harmless(command_line) == command_line) return;
    throw HarnessError(
        "a word of the command line has a control character in it, or bytes that are no UTF-8, "
        "which no result file can hold: rename the file or folder");
  });
}

}  // namespace

void add_commands(CLI::App& app, const std::string& command_line) {
  add_list_command(app);
  add_mesh_command(app);
  add_generate_command(app);
  add_solve_command(app);
  add_verify_command(app);
  add_run_command(app, command_line);
  add_rank_command(app, command_line);
  add_compare_command(app);
  add_export_command(app);
  add_plugin_option(app);
  for (CLI::App* command : app.get_subcommands(nullptr)) {
    add_plugin_option(*command);
    check_values(*command);
  }
  check_values(app);
  add_script_commands(app);
  for (const char* name : {"run", "rank", "verify"}) {
    require_text(*app.get_subcommand(name), command_line);
  }
  add_cell_commands(app);
  add_examine_command(app);
}

}  // namespace geodesic::harness
