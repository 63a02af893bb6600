// The mesh of a command that works on one, and the options that prepare it.
#pragma once

#include <optional>
#include <string>

#include "harness/commands/values.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/points.h"
#include "meshes/load.h"

namespace geodesic::harness {

struct OneMesh {
  std::string name;
  std::optional<double> weld;
  AvoidedFiles avoided;
  bool repair = false, cross_non_manifold = false;  // the second is not an option of all
  std::string manifest = default_manifest().string();
};

/// Adds MESH, --weld, --avoid, --avoid-faces, --repair and --manifest.
void add_mesh_options(CLI::App& command, OneMesh& mesh);

struct ReadMesh {
  MeshEntry entry;
  BuiltMesh built;
};

/// Reads the mesh and prints its warnings.
/// @param output file of --output, which must be no input; empty for none
/// @throws HarnessError, MeshError
ReadMesh read_one(const OneMesh& mesh, const std::string& output);

/// The place of a point that has no initial distance. Prints a warning if it is far from the
/// surface. @throws HarnessError as `place`, and for an initial distance
SurfacePoint place_of(const WrittenPoint& point, const NearestPointSearch& surface);

}  // namespace geodesic::harness
