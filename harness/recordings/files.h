// The files of recordings, from which figures are drawn (results/README.md describes each).
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "harness/recordings/paths.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Folders of a recording, relative to the run folder.
struct RecordingFolders {
  std::filesystem::path mesh;    ///< `recordings/<mesh>`
  std::filesystem::path source;  ///< `recordings/<mesh>/src<source>`
  std::filesystem::path solver;  ///< `recordings/<mesh>/src<source>/<solver>`
};

/// Different names give different folders: bytes other than letters, digits, ".", "_" and "-" are
/// written %XX.
RecordingFolders recording_folders(const std::string& mesh, const std::string& source,
                                   const std::string& solver);

/// A Recording with the options that `write_wavefront` needs.
/// @param frames whether to record every step of progress, for moving pictures, or only three steps
Recording wavefront_recording(bool frames = false);

/// Writes vertices.npy and faces.npy unless they exist.
/// @throws HarnessError when a file cannot be written, as the other functions do
void write_surface(const std::filesystem::path& folder, const TriangleSoup& soup);

/// Writes distances.npy unless it exists. @param distances in the order of the file
void write_vertex_distances(const std::filesystem::path& folder, std::span<const double> distances);

/// Writes curve.npy and the recorded ones of snapshot-25.npy, -50 and -75. With frames, also writes
/// frame-1.npy to frame-64.npy and reached_by.npy.
/// @param recording with the options of wavefront_recording
void write_wavefront(const std::filesystem::path& folder, const Mesh& mesh,
                     const Recording& recording);

/// Whether the folder has the files of `write_paths`, or those of `write_cells`.
bool has_paths(const std::filesystem::path& folder);
bool has_cells(const std::filesystem::path& folder);

/// Writes path_points.npy and path_pieces.npy.
void write_paths(const std::filesystem::path& folder, const FigurePaths& paths);

/// Writes cell_sources.npy and cells.npy.
void write_cells(const std::filesystem::path& folder, const FigureCells& cells);

}  // namespace geodesic::harness
