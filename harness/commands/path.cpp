#include <iostream>
#include <memory>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/json.h"
#include "harness/commands/commands.h"
#include "harness/commands/one_mesh.h"
#include "harness/commands/values.h"
#include "harness/corpus/points.h"
#include "harness/corpus/solvers.h"
#include "meshes/path_file.h"
#include "solvers/core/registry.h"
#include "solvers/paths/through.h"

namespace geodesic::harness {
namespace {

struct PathFlags {
  OneMesh mesh;
  std::string through, output, solver = "edge-based";
  ThroughOptions how;
};

void find_path(const PathFlags& flags) {
  const std::vector<WrittenPoint> written = parse_points(flags.through, "--through");
  if (!flags.output.empty()) check_path_file(flags.output);
  const auto [entry, built] = read_one(flags.mesh, flags.output);
  const NearestPointSearch surface(*built.mesh);
  std::vector<SurfacePoint> points;
  for (const WrittenPoint& point : written) points.push_back(place_of(point, surface));
  try {
    const std::string unable = unsupported(solver_named(flags.solver), *built.mesh);
    if (!unable.empty()) throw HarnessError(unable);
    const std::unique_ptr<Solver> solver = make_solver(flags.solver, *built.mesh);
    if (!solver->description().abilities.paths) {
      throw HarnessError(solver->description().name +
                         " does not remember paths: take another solver, such as edge-based");
    }
    const Path path = path_through(*solver, *built.mesh, points, flags.how);
    if (!flags.output.empty()) write_bytes(flags.output, path_bytes({{path}}, flags.output));
    const Json json{{"mesh", entry.name},
                    {"length", path.length()},
                    {"faces", path.points.size() - 1},
                    {"closed", flags.how.closed},
                    {"straightened", flags.how.straighten}};
    std::cout << json.dump(2) << std::endl;
  } catch (const std::invalid_argument& error) {
    throw HarnessError(entry.name + ": " + error.what());
  }
}

}  // namespace

void add_path_command(CLI::App& app) {
  const auto flags = std::make_shared<PathFlags>();
  CLI::App* command = app.add_subcommand(
      "path", "Shortest paths from each point to the next one, joined; print the length as JSON");
  command->footer(
      "\nExamples:\n  geodesic-bench path bunny.ply --through 0,12,at:0,0.1,0 -o path.obj\n"
      "  geodesic-bench path handle.ply --through 5,99,310 --closed --straighten -o loop.obj");
  add_mesh_options(*command, flags->mesh);
  add_crossing_option(*command, flags->mesh.cross_non_manifold);
  command
      ->add_option("--through", flags->through,
                   std::string("two points or more, separated by commas: ") + kPointForms)
      ->required()
      ->type_name("POINTS");
  command->add_flag("--closed", flags->how.closed, "go back from the last point to the first one");
  command->add_flag("--straighten", flags->how.straighten,
                    "pull the path tight: the locally shortest curve of its class, which keeps its "
                    "ends unless it is closed, and need not pass the other points");
  command->add_option("--solver", flags->solver, "solver (default: " + flags->solver + ")")
      ->type_name("NAME");
  command->add_option("-o,--output", flags->output, "file for the path: .obj, .ply or .json")
      ->type_name("FILE");
  command->callback([flags] { find_path(*flags); });
}

}  // namespace geodesic::harness
