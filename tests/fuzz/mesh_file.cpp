#include "tests/fuzz/mesh_file.h"

#include "meshes/load.h"
#include "meshes/summary.h"
#include "solvers/core/mesh.h"

namespace geodesic::harness::fuzz {
namespace {

// What has been loaded is fit for a solver: the constructor of Mesh refuses nothing.
void hand_over(const MeshFile& file, const std::string& name, const LoadOptions& options) {
  const LoadedMesh loaded = load_mesh(file, name, options);
  Mesh(loaded.soup, Numbering::along_surface);
}

}  // namespace

void read_mesh_file(std::string_view bytes, const std::string& name) {
  const MeshFile file = parse_mesh(bytes, name);
  summarize(file.soup);  // also of a mesh that is then refused
  try {
    hand_over(file, name, {.repair = false});
  } catch (const MeshError&) {
    hand_over(file, name, {.repair = true});
  }
}

}  // namespace geodesic::harness::fuzz
