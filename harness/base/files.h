// Files that are written completely or not at all, checksums, and the folders of this program.
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "harness/base/part_file.h"

namespace geodesic::harness {

/// The end of a temporary file name. Only a process that was killed, not by a signal of
/// InterruptionGuard, leaves such a file behind.
inline constexpr const char* kPartOfFile = ".part";

/// Writes to a temporary file in the same folder; `commit` renames it. Without a commit, the
/// destructor removes it. A path that is not a regular file (a pipe, /dev/stderr) is written to
/// directly.
class AtomicFile {
 public:
  /// @throws CannotWrite when the file cannot be written, before anything is computed
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& stream() { return stream_; }

  /// @throws CannotWrite when not everything could be written (a full disk)
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path written_;  // the temporary name, or path_ itself
  std::optional<PartFile> part_;   // of the temporary name
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes a file completely or not at all. @throws CannotWrite
void write_bytes(const std::filesystem::path& path, std::string_view bytes);

/// A name as one component of a path. Characters that are special in a file system, a shell or a
/// URL become %XX, and so does a leading dot. Letters, digits, '_', '-' and '.' stay.
std::string as_file_name(std::string_view name);

/// Whether a character is an ASCII letter, a digit, ".", "_" or "-".
bool is_plain(char c);

/// Checks a name that occurs in file names: at most 100 plain characters, the first a letter or
/// digit. @param kind "corpus name", for the message
/// @throws HarnessError with kind and name
void check_name(std::string_view kind, std::string_view name);

/// Makes a folder and its parent folders unless they exist.
/// @param advice end of the error message: "; --out names another"
/// @throws HarnessError when it cannot be made
void make_folder(const std::filesystem::path& folder, const std::string& advice = "");

/// SHA-256 (FIPS 180-4), as 64 lower-case hexadecimal digits.
std::string sha256_of(std::string_view bytes);

/// SHA-256 of the bytes of a file. @throws HarnessError when the file cannot be read
std::string sha256_of_file(const std::filesystem::path& path);

/// The root of the checkout that the program was built from. For an installed program, the folder
/// with the same files at the same places (share/geodesic-bench beside its bin).
std::filesystem::path data_folder();

/// The default folder for measurements: results in the checkout, or in the current folder if the
/// program is installed.
std::filesystem::path results_folder();

}  // namespace geodesic::harness
