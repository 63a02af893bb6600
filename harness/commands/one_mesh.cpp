#include "harness/commands/one_mesh.h"

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

ReadMesh read_one(const OneMesh& mesh) {
  ReadMesh read{.entry = find_mesh(mesh.name, mesh.manifest), .built = {}};
  read.built =
      build_mesh(read.entry.file,
                 {.repair = mesh.repair, .weld = mesh.weld, .avoid = read_avoided(mesh.avoided)});
  for (const std::string& warning : read.built.loaded.warnings) {
    warn(read.entry.file.string() + ": " + warning);
  }
  return read;
}

}  // namespace geodesic::harness
