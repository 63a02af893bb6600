// Files of one mesh format, as `geodesic-bench mesh` and `solve` take them. FUZZED_MESH is the name
// of a file of that format: its extension is the hint.
#include "meshes/load.h"
#include "meshes/summary.h"
#include "solvers/core/mesh.h"
#include "tests/fuzz/input.h"

namespace geodesic::harness {
namespace {

// What has been loaded is fit for a solver: the constructor of Mesh refuses nothing.
void hand_over(const MeshFile& file, const LoadOptions& options) {
  const LoadedMesh loaded = load_mesh(file, FUZZED_MESH, options);
  Mesh(loaded.soup, Numbering::along_surface);
}

}  // namespace

void fuzz::read_input(std::string_view bytes) {
  const MeshFile file = parse_mesh(bytes, FUZZED_MESH);
  summarize(file.soup);  // also of a mesh that is then refused
  try {
    hand_over(file, {.repair = false});
  } catch (const MeshError&) {
    hand_over(file, {.repair = true});
  }
}

}  // namespace geodesic::harness
