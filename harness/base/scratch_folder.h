// A folder for files that processes of this program pass to each other.
#pragma once

#include <filesystem>

namespace geodesic::harness {

/// Made in the system's folder of temporary files, and removed with this object. If its process is
/// killed, the next constructor removes the folder.
class ScratchFolder {
 public:
  /// @throws HarnessError when it cannot be made
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::filesystem::path& file) const { return path_ / file; }

 private:
  std::filesystem::path path_;
};

}  // namespace geodesic::harness
