// Files of matrices that are written row by row, in any order, and may be continued.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace geodesic::harness {

/// What a file is to hold.
struct MatrixPlan {
  std::filesystem::path file;  ///< .npy
  std::size_t rows = 0, columns = 0;
  bool single_precision = false;  ///< float32, otherwise float64
  /// 64 characters that differ for every other problem: an unfinished file is only continued
  /// when they are the same.
  std::string problem;
};

/// A matrix while it is written, to FILE.unfinished. What was put there stays when the process is
/// killed. One process at a time has it. It is written through a memory map: its room on the disk
/// is taken at once, the process needs memory for the rows that are being written only.
class MatrixFile {
 public:
  /// @param resume whether an unfinished file is continued; without one the matrix begins anew
  /// @throws HarnessError for another extension, for an unfinished file when it is not to be
  ///         continued, is of another problem or in use, and when there is no room for the file
  MatrixFile(const MatrixPlan& plan, bool resume);
  ~MatrixFile();
  MatrixFile(const MatrixFile&) = delete;
  MatrixFile& operator=(const MatrixFile&) = delete;

  /// Whether the row was put here before this object was made.
  bool has(std::size_t row) const { return before_[row] != 0; }
  /// @param values one a column, infinite where there is no distance; several threads may put
  ///        different rows at a time
  void put(std::size_t row, std::span<const double> values);
  /// Gives the whole file its name. @throws CannotWrite
  void finish();

 private:
  class Unfinished;
  std::unique_ptr<Unfinished> file_;
  std::size_t bytes_a_row_;
  bool single_precision_;
  std::size_t numbers_at_ = 0, flags_at_ = 0;
  std::string before_;   // a byte a row
  char* map_ = nullptr;  // of the whole file
};

/// What a row of a file is put into while it is unfinished.
std::filesystem::path unfinished(const std::filesystem::path& file);

}  // namespace geodesic::harness
