// A folder for files that processes of this program hand to one another.
#pragma once

#include <filesystem>

namespace geodesic::harness {

/// Made below the system's folder of temporary files, and removed with this object. One whose
/// process was killed is removed by the next that makes one.
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
