// The file of distances that `solve --output` writes. Its suffix selects the format.
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>

#include "harness/base/files.h"
#include "solvers/core/mesh.h"

namespace geodesic::harness {

/// Further numbers of each vertex, as many as there are distances; those that are not wanted are
/// empty.
struct VertexColumns {
  std::span<const Index> sources = {};  ///< kNone (written as -1) where no path leads
  std::span<const double> angles = {};  ///< PolarCoordinates (solvers/paths/straightest.h)
};

/// Distances from the nearest of some sources:
///
///   .txt  one distance a line; then, after a space each, the source and the angle if wanted
///   .csv  a header line, then vertex, distance and, if wanted, source and angle
///   .npy  an array of float64, one entry a vertex; with further columns, a table of all
///   .ply, .vtk  the mesh with its distances and sources (meshes/field_file.h)
///
/// Distances of pairs, without sources, are written as those of vertices, with a column pair in
/// place of vertex.
///
/// Distances from each source, or from each set of sources, one row for each:
///
///   .txt  distances, separated by spaces
///   .csv  a header line with the vertices, then the sources of each row and its distances
///   .npy  an array of float64, rows by vertices
///
/// Numbers in text have the fewest digits that restore every double. Vertices are in file order.
class DistanceFile {
 public:
  /// Opens the file before anything is computed.
  /// @param file "-" for standard output; this, devices and pipes get text
  /// @throws HarnessError for any other suffix
  /// @throws CannotWrite for the reasons of AtomicFile
  explicit DistanceFile(const std::string& file);

  /// Whether it is a mesh, which has the distances of one query.
  bool is_mesh() const { return format_ == Format::mesh; }

  /// @param more without angles for a mesh
  void write(const Mesh& mesh, std::span<const double> distances, const VertexColumns& more);
  void write_pairs(std::span<const double> distances) { write_table(distances, {}, "pair"); }

  /// Begins the rows of several sources, or of several sets of them.
  /// @param named name of the first column of .csv, which has the sources
  void begin_rows(std::size_t rows, std::size_t vertices, const std::string& named);
  /// The bytes of a row in the file. Several threads may call it.
  /// @param sources as users write them
  std::string row(const std::string& sources, std::span<const double> distances) const;
  void write_row(const std::string& row) { *to_ << row; }

  /// @throws CannotWrite when not everything could be written
  void commit();

 private:
  enum class Format : unsigned char { text, csv, npy, mesh };
  static Format format_of(const std::string& file);
  void write_table(std::span<const double> distances, const VertexColumns& more,
                   const std::string& numbered);

  std::string name_;
  Format format_;
  std::optional<AtomicFile> file_;  // empty for standard output
  std::ostream* to_;
};

}  // namespace geodesic::harness
