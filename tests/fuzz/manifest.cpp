// Fuzz target: manifests of meshes, and look-ups in them.
#include "harness/corpus/manifest.h"

#include "tests/fuzz/input.h"

namespace geodesic::harness {

void fuzz::read_input(std::string_view bytes) {
  const Manifest manifest(parse_json(bytes, "manifest.json"), "manifest.json", ".");
  for (const MeshEntry& mesh : manifest.meshes()) {
    if (!mesh.available()) how_to_get(mesh);
  }
  for (const auto& [name, members] : manifest.corpora()) manifest.corpus(name);
  manifest.mesh("no such mesh");
}

}  // namespace geodesic::harness
