// Where a run keeps its recordings.
#pragma once

#include <filesystem>
#include <string>

#include "solvers/core/geometry.h"

namespace geodesic::harness {

/// Folders below the run folder.
struct RecordingFolders {
  std::filesystem::path mesh;    ///< `recordings/<mesh>`
  std::filesystem::path source;  ///< `recordings/<mesh>/src<vertex>`
  std::filesystem::path solver;  ///< `recordings/<mesh>/src<vertex>/<solver>`
};

/// Any name gives a folder of its own: what is no letter, digit, ".", "_" or "-" is written %XX.
RecordingFolders recording_folders(const std::string& mesh, Index source,
                                   const std::string& solver);

}  // namespace geodesic::harness
