#include "harness/commands/commands.h"

#include "harness/commands/compare.h"
#include "harness/commands/export.h"
#include "harness/commands/generate.h"
#include "harness/commands/list.h"
#include "harness/commands/mesh.h"
#include "harness/commands/run.h"
#include "harness/commands/solve.h"

namespace geodesic::harness {

void add_commands(CLI::App& app, const std::string& command_line) {
  add_list_command(app);
  add_mesh_command(app);
  add_generate_command(app);
  add_solve_command(app);
  add_run_command(app, command_line);
  add_compare_command(app);
  add_export_command(app);
  add_cell_commands(app);
}

}  // namespace geodesic::harness
