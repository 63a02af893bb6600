// The file of distances that `solve --output` writes. Its suffix selects the format.
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>

#include "harness/base/files.h"
#include "solvers/core/geometry.h"

namespace geodesic::harness {

/// Distances from the nearest of some sources:
///
///   .txt  one distance a line; with sources, then a space and the number of the source
///   .csv  a header line, then vertex, distance and, with sources, source
///   .npy  an array of float64, one entry a vertex; with sources, a table of distance and source
///
/// Distances of pairs, without sources, are written as those of vertices, with a column pair in
/// place of vertex.
///
/// Distances from each source by itself, one row for each source:
///
///   .txt  distances, separated by spaces
///   .csv  a header line with the vertices, then each source and its distances
///   .npy  an array of float64, sources by vertices
///
/// Numbers in text have the fewest digits that restore every double. Vertices are in file order.
class DistanceFile {
 public:
  /// Opens the file before anything is computed.
  /// @param file "-" for standard output; this, devices and pipes get text
  /// @throws HarnessError for any other suffix
  /// @throws CannotWrite for the reasons of AtomicFile
  explicit DistanceFile(const std::string& file);

  /// @param sources one for each vertex, kNone (written as -1) where no path leads; may be empty
  /// @param numbered what has the distances, "vertex" or "pair"
  void write(std::span<const double> distances, std::span<const Index> sources = {},
             const std::string& numbered = "vertex");

  /// Begins the rows of several sources.
  void begin_rows(std::size_t sources, std::size_t vertices);
  /// The bytes of a row in the file. Several threads may call it.
  /// @param source as users write it
  std::string row(const std::string& source, std::span<const double> distances) const;
  void write_row(const std::string& row) { *to_ << row; }

  /// @throws CannotWrite when not everything could be written
  void commit();

 private:
  enum class Format : unsigned char { text, csv, npy };
  static Format format_of(const std::string& file);

  Format format_;
  std::optional<AtomicFile> file_;  // empty for standard output
  std::ostream* to_;
};

}  // namespace geodesic::harness
