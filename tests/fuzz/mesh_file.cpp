// Fuzz target: files of one mesh format, read as `geodesic-bench mesh` and `solve` read them.
// FUZZED_MESH is a file name whose extension gives the format.
#include "meshes/load.h"
#include "meshes/summary.h"
#include "solvers/core/mesh.h"
#include "tests/fuzz/input.h"

namespace geodesic::harness {
namespace {

// A loaded mesh is valid for a solver: the constructor of Mesh does not refuse it.
void hand_over(const MeshFile& file, const LoadOptions& options) {
  const LoadedMesh loaded = load_mesh(file, FUZZED_MESH, options);
  Mesh(loaded.soup, Numbering::along_surface);
}

}  // namespace

void fuzz::read_input(std::string_view bytes) {
  const MeshFile file = parse_mesh(bytes, FUZZED_MESH);
  summarize(file.soup);  // also works for a mesh that is refused below
  try {
    hand_over(file, {.repair = false});
  } catch (const MeshError&) {
    hand_over(file, {.repair = true});
  }
}

}  // namespace geodesic::harness
