// Matrix files that are written row by row, in any order, and can be continued.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace geodesic::harness {

/// The contents of a matrix file.
struct MatrixPlan {
  std::filesystem::path file;  ///< .npy
  std::size_t rows = 0, columns = 0;
  bool single_precision = false;  ///< float32, otherwise float64
  /// 64 characters that differ for different problems. An unfinished file is continued only when
  /// they are the same.
  std::string problem;
};

/// A matrix while it is written, to FILE.unfinished. Its rows stay when the process is killed. One
/// process at a time may use it. It is a memory map: its disk space is reserved at once, and the
/// process needs memory only for the rows that are being written.
class MatrixFile {
 public:
  /// @param resume whether to continue an unfinished file; without one the matrix begins anew
  /// @throws HarnessError for another extension, when there is no room for the file, and for an
  ///         unfinished file that is not to be continued, has another problem or is in use
  MatrixFile(const MatrixPlan& plan, bool resume);
  ~MatrixFile();
  MatrixFile(const MatrixFile&) = delete;
  MatrixFile& operator=(const MatrixFile&) = delete;

  /// Whether the file had the row before this object was made.
  bool has(std::size_t row) const { return before_[row] != 0; }
  /// Writes a row. Several threads may write different rows at a time.
  /// @param values one for each column, infinite where there is no distance
  void put(std::size_t row, std::span<const double> values);
  /// Gives the complete file its final name. @throws CannotWrite
  void finish();

 private:
  class Unfinished;
  std::unique_ptr<Unfinished> file_;
  std::size_t bytes_a_row_;
  bool single_precision_;
  std::size_t numbers_at_ = 0, flags_at_ = 0;
  std::string before_;   // one byte for each row
  char* map_ = nullptr;  // the whole file
};

/// The name of a matrix file while it is unfinished.
std::filesystem::path unfinished(const std::filesystem::path& file);

}  // namespace geodesic::harness
