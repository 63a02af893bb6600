#include "harness/recordings/files.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "meshes/formats/npy.h"
#include "solvers/core/progress.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

// Per cent of the reachable vertices that are reached at a snapshot.
constexpr std::array<int, 3> kMoments{25, 50, 75};
constexpr double share(int moment) { return moment / 100.0; }
constexpr int kFrames = Progress::kSteps;

template <class To, class From>
std::vector<To> flattened(const std::vector<std::array<From, 3>>& rows) {
  std::vector<To> numbers;
  numbers.reserve(3 * rows.size());
  for (const auto& row : rows) {
    for (const From number : row) numbers.push_back(static_cast<To>(number));
  }
  return numbers;
}

constexpr const char* kPathPieces = "path_pieces.npy";
constexpr const char* kCells = "cells.npy";

// A window in the form for figures: on the edge between two vertices of the file.
struct WindowOfFile {
  Index origin, head;
  double begin, end;  // shares of the edge from `origin`
  double distance;
};

std::vector<WindowOfFile> as_in_file(const std::vector<WavefrontWindow>& windows,
                                     const Mesh& mesh) {
  std::vector<WindowOfFile> rows;
  rows.reserve(windows.size());
  for (const WavefrontWindow& w : windows) {
    const double length = mesh.half_edge(w.half_edge).length;
    rows.push_back({mesh.numbers().external_vertex(mesh.origin(w.half_edge)),
                    mesh.numbers().external_vertex(mesh.head(w.half_edge)), w.begin / length,
                    w.end / length, w.distance});
  }
  return rows;
}

void write_snapshot(const fs::path& folder, const std::string& name, const Mesh& mesh,
                    const WavefrontSnapshot& snapshot) {
  using W = WindowOfFile;
  write_bytes(
      folder / (name + ".npy"),
      npy_table_bytes(
          as_in_file(snapshot.windows, mesh), npy_column<std::uint32_t>("origin", &W::origin),
          npy_column<std::uint32_t>("head", &W::head), npy_column<float>("begin", &W::begin),
          npy_column<float>("end", &W::end), npy_column<double>("distance", &W::distance)));
}

void write_reached_by(const fs::path& folder, const Mesh& mesh, std::span<const Index> reached_by) {
  std::vector<std::uint32_t> in_file(reached_by.size());
  for (Index v = 0; v < reached_by.size(); ++v) {
    in_file[mesh.numbers().external_vertex(v)] = reached_by[v];
  }
  write_bytes(folder / "reached_by.npy", npy_bytes<std::uint32_t>(in_file));
}

}  // namespace

RecordingFolders recording_folders(const std::string& mesh, const std::string& source,
                                   const std::string& solver) {
  const fs::path of_mesh = fs::path("recordings") / as_file_name(mesh);
  const fs::path of_source = of_mesh / ("src" + as_file_name(source));
  return {.mesh = of_mesh, .source = of_source, .solver = of_source / as_file_name(solver)};
}

Recording wavefront_recording(bool frames) {
  Recording recording;
  recording.kind = RecordingKind::wavefront;
  if (frames) {  // they include the moments
    for (int i = 1; i <= kFrames; ++i) recording.snapshots_at.push_back(i / double{kFrames});
  } else {
    for (const int moment : kMoments) recording.snapshots_at.push_back(share(moment));
  }
  return recording;
}

void write_surface(const fs::path& folder, const TriangleSoup& soup) {
  make_folder(folder);
  const fs::path vertices = folder / "vertices.npy", faces = folder / "faces.npy";
  if (!fs::exists(vertices)) {
    write_bytes(vertices, npy_bytes<float>(flattened<float>(soup.positions), 3));
  }
  if (!fs::exists(faces)) {
    write_bytes(faces, npy_bytes<std::uint32_t>(flattened<std::uint32_t>(soup.triangles), 3));
  }
}

void write_vertex_distances(const fs::path& folder, std::span<const double> distances) {
  make_folder(folder);
  const fs::path file = folder / "distances.npy";
  if (!fs::exists(file)) write_bytes(file, npy_bytes(distances));
}

void write_wavefront(const fs::path& folder, const Mesh& mesh, const Recording& recording) {
  make_folder(folder);
  using Sample = WavefrontSample;
  write_bytes(
      folder / "curve.npy",
      npy_table_bytes(recording.curve, npy_column<std::uint32_t>("reached", &Sample::reached),
                      npy_column<std::uint64_t>("windows", &Sample::windows),
                      npy_column<double>("least", &Sample::least),
                      npy_column<double>("mean", &Sample::mean),
                      npy_column<double>("sd", &Sample::sd)));
  const bool frames = recording.snapshots_at.size() == kFrames;
  for (const WavefrontSnapshot& snapshot : recording.snapshots) {
    for (const int moment : kMoments) {
      if (share(moment) == snapshot.share) {
        write_snapshot(folder, "snapshot-" + std::to_string(moment), mesh, snapshot);
      }
    }
    if (frames) {
      const int frame = static_cast<int>(snapshot.share * kFrames);
      write_snapshot(folder, "frame-" + std::to_string(frame), mesh, snapshot);
    }
  }
  if (frames) write_reached_by(folder, mesh, recording.reached_by);
}

bool has_paths(const fs::path& folder) { return fs::exists(folder / kPathPieces); }
bool has_cells(const fs::path& folder) { return fs::exists(folder / kCells); }

void write_paths(const fs::path& folder, const FigurePaths& paths) {
  make_folder(folder);
  using Piece = FigurePaths::Piece;
  write_bytes(folder / "path_points.npy", npy_bytes<float>(flattened<float>(paths.points), 3));
  write_bytes(folder / kPathPieces,
              npy_table_bytes(paths.pieces, npy_column<std::uint32_t>("target", &Piece::target),
                              npy_column<std::uint32_t>("first", &Piece::first)));
}

void write_cells(const fs::path& folder, const FigureCells& cells) {
  make_folder(folder);
  write_bytes(folder / "cell_sources.npy", npy_bytes<std::uint32_t>(cells.sources));
  write_bytes(folder / kCells, npy_bytes<std::uint32_t>(cells.nearest));
}

}  // namespace geodesic::harness
