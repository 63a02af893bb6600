// Files of matrices that are written row by row, in any order, and may be gone on with.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace geodesic::harness {

/// What a file is to hold.
struct MatrixPlan {
  std::filesystem::path
      file;  ///< .npy: all distances; .npz: the finite ones, as scipy.sparse's CSR
  std::size_t rows = 0, columns = 0;
  bool single_precision = false;  ///< float32, otherwise float64
  /// 64 characters that differ for every other problem: an unfinished file is only gone on with
  /// when they are the same.
  std::string problem;
};

/// A matrix while it is written, to FILE.unfinished. What was put there stays when the process is
/// killed. One process at a time has it.
class MatrixFile {
 public:
  virtual ~MatrixFile() = default;
  MatrixFile(const MatrixFile&) = delete;
  MatrixFile& operator=(const MatrixFile&) = delete;

  /// Whether the row was put here before this object was made.
  virtual bool has(std::size_t row) const = 0;
  /// @param values one a column, infinite where there is no distance; several threads may put
  ///        different rows at a time
  /// @throws CannotWrite
  virtual void put(std::size_t row, std::span<const double> values) = 0;
  /// Gives the whole file its name. @throws CannotWrite
  virtual void finish() = 0;

 protected:
  MatrixFile() = default;
};

/// A .npy file is written through a memory map: its room on the disk is taken at once, the process
/// needs memory for the rows that are being written only. A .npz file is put together at the end,
/// from rows in the order in which they came.
/// @param resume whether an unfinished file is gone on with; without one the matrix begins anew
/// @throws HarnessError for another extension, for an unfinished file when it is not to be gone on
///         with, is of another problem or in use, and when there is no room for the file
std::unique_ptr<MatrixFile> open_matrix(const MatrixPlan& plan, bool resume);

/// What a row of a file is put into while it is unfinished.
std::filesystem::path unfinished(const std::filesystem::path& file);

}  // namespace geodesic::harness
