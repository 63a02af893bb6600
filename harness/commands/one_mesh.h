// The mesh of a command that works on one, and the options that prepare it.
#pragma once

#include <optional>
#include <string>

#include "harness/commands/values.h"
#include "harness/corpus/manifest.h"
#include "meshes/load.h"

namespace geodesic::harness {

struct OneMesh {
  std::string name;
  std::optional<double> weld;
  AvoidedFiles avoided;
  bool repair = false;
  std::string manifest = default_manifest().string();
};

/// Adds MESH, --weld, --avoid, --avoid-faces, --repair and --manifest.
void add_mesh_options(CLI::App& command, OneMesh& mesh);

struct ReadMesh {
  MeshEntry entry;
  BuiltMesh built;
};

/// Reads the mesh and prints its warnings. @throws HarnessError, MeshError
ReadMesh read_one(const OneMesh& mesh);

}  // namespace geodesic::harness
