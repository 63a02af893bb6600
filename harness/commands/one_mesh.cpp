#include "harness/commands/one_mesh.h"

#include "harness/base/error.h"
#include "harness/commands/solving/answers.h"

namespace geodesic::harness {

void add_mesh_options(CLI::App& command, OneMesh& mesh) {
  command.add_option("mesh", mesh.name, "mesh file, or name of the manifest")
      ->required()
      ->type_name("MESH");
  add_weld_option(command, mesh.weld);
  add_avoid_options(command, mesh.avoided);
  command.add_flag("--repair", mesh.repair, "repair defects of the mesh; joins no vertices");
  command.add_option("--manifest", mesh.manifest, "list of meshes and corpora")->type_name("FILE");
}

ReadMesh read_one(const OneMesh& mesh, const std::string& output) {
  ReadMesh read{.entry = find_mesh(mesh.name, mesh.manifest), .built = {}};
  check_output_differs("--output", output,
                       {{"mesh", read.entry.file},
                        {"--avoid", mesh.avoided.vertices},
                        {"--avoid-faces", mesh.avoided.faces}});
  read.built = build_mesh(read.entry.file,
                          {.repair = mesh.repair,
                           .weld = mesh.weld,
                           .avoid = read_avoided(mesh.avoided),
                           .non_manifold_edges = mesh.cross_non_manifold ? NonManifoldEdges::crossed
                                                                         : NonManifoldEdges::cut});
  for (const std::string& warning : read.built.loaded.warnings) {
    warn(read.entry.file.string() + ": " + warning);
  }
  return read;
}

SurfacePoint place_of(const WrittenPoint& point, const NearestPointSearch& surface) {
  if (point.initial) throw HarnessError(point.text + ": only a source has an initial distance");
  const PlacedPoint placed = place(point, surface);
  if (placed.from_surface) {
    const std::string remark = surface.remark_if_far(*placed.from_surface);
    if (!remark.empty()) warn(point.text + ' ' + remark);
  }
  return placed.at;
}

}  // namespace geodesic::harness
