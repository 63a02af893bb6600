// The file of distances that `solve --output` writes; its suffix says how.
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>

#include "harness/base/files.h"
#include "solvers/core/geometry.h"

namespace geodesic::harness {

/// From the nearest of some sources:
///
///   .txt  a distance a line, and behind a space the number of its source
///   .csv  vertex,distance and source, below a line of these names
///   .npy  an array of float64, one entry a vertex; with sources a table, distance and source
///
/// From each source by itself, a row a source:
///
///   .txt  distances, separated by spaces
///   .csv  the source and its distances, below a line of the vertices
///   .npy  an array of float64, sources by vertices
///
/// Numbers in text have the fewest digits that bring every double back. Vertices are in file order.
class DistanceFile {
 public:
  /// Opened before anything is computed.
  /// @param file "-" is standard output, which gets text, as devices and pipes do
  /// @throws HarnessError for any other suffix
  /// @throws CannotWrite as AtomicFile
  explicit DistanceFile(const std::string& file);

  /// @param sources one a vertex, kNone (written as -1) where no path leads; or none at all
  void write(std::span<const double> distances, std::span<const Index> sources = {});

  /// Begins rows of sources.
  void begin_rows(std::size_t sources, std::size_t vertices);
  /// What a row is in the file; may be called by several threads.
  /// @param source as it is written by users
  std::string row(const std::string& source, std::span<const double> distances) const;
  void write_row(const std::string& row) { *to_ << row; }

  /// @throws CannotWrite when not everything could be written
  void commit();

 private:
  enum class Format : unsigned char { text, csv, npy };
  static Format format_of(const std::string& file);

  Format format_;
  std::optional<AtomicFile> file_;  // none: standard output
  std::ostream* to_;
};

}  // namespace geodesic::harness
