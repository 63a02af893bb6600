// A file that appears whole or not at all.
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <string_view>

#include "harness/base/json.h"

namespace geodesic::harness {

/// The end of a temporary name, which is left behind only by a process that was killed.
inline constexpr const char* kPartOfFile = ".part";

/// Writes to a temporary name in the same folder; `commit` gives the file its name. Destroyed
/// without a commit it leaves nothing behind. A path that is no regular file (a pipe, /dev/stderr)
/// is written to directly.
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

/// Writes indented JSON, whole or not at all; bytes that are no UTF-8 become U+FFFD. @throws
/// CannotWrite
void write_json(const std::filesystem::path& path, const Json& json);

/// @param wanted what a user should have named, for the message when there is no such file
/// @throws HarnessError when the file cannot be read, and as `parse_json`
Json read_json(const std::filesystem::path& path, const std::string& wanted = "");

}  // namespace geodesic::harness
