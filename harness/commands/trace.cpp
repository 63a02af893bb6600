#include <iostream>
#include <memory>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/json.h"
#include "harness/commands/commands.h"
#include "harness/commands/one_mesh.h"
#include "harness/commands/values.h"
#include "harness/corpus/points.h"
#include "meshes/path_file.h"
#include "solvers/paths/straightest.h"

namespace geodesic::harness {
namespace {

struct TraceFlags {
  OneMesh mesh;
  std::string from, output;
  std::vector<double> direction;
  std::optional<double> angle;
  double length = 0;
};

void trace_line(const TraceFlags& flags) {
  const std::vector<WrittenPoint> written = parse_points(flags.from, "--from");
  if (written.size() != 1) throw HarnessError("--from takes one point");
  if (flags.angle.has_value() != flags.direction.empty()) {
    throw HarnessError("one of --direction and --angle is needed: where the line goes");
  }
  if (!flags.output.empty()) check_path_file(flags.output);
  const auto [entry, built] = read_one(flags.mesh, flags.output);
  const Mesh& mesh = *built.mesh;
  const SurfacePoint begin = place_of(written.front(), NearestPointSearch(mesh));
  try {
    const double angle =
        flags.angle
            ? *flags.angle
            : angle_of(mesh, begin, {flags.direction[0], flags.direction[1], flags.direction[2]});
    const StraightestLine line = trace_straightest(mesh, begin, angle, flags.length);
    if (!flags.output.empty())
      write_bytes(flags.output, path_bytes({{Path{0, line.points}}}, flags.output));
    const Json json{{"mesh", entry.name},
                    {"angle", angle},
                    {"total_angle", total_angle(mesh, begin)},
                    {"length", line.length()},
                    {"ends_at_boundary", line.ends_at_boundary},
                    {"end", line.points.back().position}};
    std::cout << json.dump(2) << std::endl;
  } catch (const std::invalid_argument& error) {
    throw HarnessError(entry.name + ": " + error.what());
  }
}

}  // namespace

void add_trace_command(CLI::App& app) {
  const auto flags = std::make_shared<TraceFlags>();
  CLI::App* command = app.add_subcommand(
      "trace", "Go straight on from a point in a direction; print the end as JSON");
  command->footer(
      "\nExample:\n  geodesic-bench trace bunny.ply --from 12 --direction 0,0,1 --length 0.1 -o "
      "line.obj");
  add_mesh_options(*command, flags->mesh);
  command->add_option("--from", flags->from, std::string("where the line begins: ") + kPointForms)
      ->required()
      ->type_name("POINT");
  command
      ->add_option("--direction", flags->direction,
                   "a vector in space, projected to the face, at a vertex to the tangent plane")
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,Z");
  command
      ->add_option("--angle", flags->angle,
                   "angle on the surface in radians, counter-clockwise, as --angles of solve")
      ->excludes("--direction");
  command
      ->add_option("--length", flags->length,
                   "length of the line, which ends at the boundary if it reaches that before")
      ->required();
  command->add_option("-o,--output", flags->output, "file for the line: .obj, .ply or .json")
      ->type_name("FILE");
  command->callback([flags] { trace_line(*flags); });
}

}  // namespace geodesic::harness
