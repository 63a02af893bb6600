// The extended context of result files: what is needed to trust and to repeat a run
// (results/README.md describes every key).
#pragma once

#include <string>
#include <vector>

#include "harness/base/json.h"
#include "harness/corpus/manifest.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Version of the format of result files.
inline constexpr int kSchemaVersion = 3;

/// A solver's description with the keys of struct Description.
Json describe(const Description& solver);

/// The present time, ISO 8601 in UTC: "2026-01-31T12:00:00Z".
std::string utc_now();

/// Name, hash, size and topology of a mesh, with the keys of context.geodesic_bench.meshes.
Json describe(const MeshEntry& entry, const TriangleSoup& soup, const Mesh& mesh);

/// Keys that every result file of this program has: schema version, revision, compiler, processor,
/// plug-ins.
Json program_context();

}  // namespace geodesic::harness
