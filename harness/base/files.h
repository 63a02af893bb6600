// Files that appear whole or not at all, their checksums, and the folders of this program.
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <string_view>

namespace geodesic::harness {

/// The end of a temporary name, which is left behind only by a process that was killed.
inline constexpr const char* kPartOfFile = ".part";

/// Writes to a temporary name in the same folder; `commit` gives the file its name. Destroyed
/// without a commit it leaves nothing behind. A path that is not a regular file (a pipe,
/// /dev/stderr) is written to directly.
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
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes a file, whole or not at all. @throws CannotWrite
void write_bytes(const std::filesystem::path& path, std::string_view bytes);

/// A name as one step of a path: what may mean something to a file system, a shell or a URL becomes
/// %XX, and so does a dot in front. Letters, digits, '_', '-' and '.' stay.
std::string as_file_name(std::string_view name);

/// ASCII letters, digits, ".", "_" and "-".
bool is_plain(char c);

/// What is to name files of a run has plain characters, the first a letter or digit, at most 100.
/// @param kind "corpus name", for the message
/// @throws HarnessError naming kind and name
void check_name(std::string_view kind, std::string_view name);

/// Makes a folder and those that it lies in, unless they are there.
/// @param advice end of the message: "; --out names another"
/// @throws HarnessError when it cannot be made
void make_folder(const std::filesystem::path& folder, const std::string& advice = "");

/// SHA-256 (FIPS 180-4), as 64 lower-case hexadecimal digits.
std::string sha256_of(std::string_view bytes);

/// The same of a file's bytes. @throws HarnessError when the file cannot be read
std::string sha256_of_file(const std::filesystem::path& path);

/// The root of the checkout that the program was built from; of an installed program, the folder
/// with the same files at the same places (share/geodesic-bench beside its bin).
std::filesystem::path data_folder();

/// The folder for what is measured and was given none: results of the checkout, and of the current
/// folder where the program is installed.
std::filesystem::path results_folder();

}  // namespace geodesic::harness
