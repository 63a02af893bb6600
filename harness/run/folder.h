// The folder that a run writes its results to.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace geodesic::harness {

/// A run folder, locked for other processes during the object's lifetime. The system releases the
/// lock however the process ends. File systems without locks do not protect the folder.
class RunFolder {
 public:
  /// A new folder for results: `path` or `results/runs/<UTC time>-<name>` of the checkout.
  /// @throws HarnessError when it cannot be made, another process has locked it, or it holds
  ///         results already, which never change
  RunFolder(const std::optional<std::filesystem::path>& path, const std::string& name);
  /// A folder that an earlier process made.
  /// @throws HarnessError when there is no such folder, or another process has locked it
  explicit RunFolder(const std::filesystem::path& path);
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder();

  const std::filesystem::path& path() const { return path_; }
  /// Makes `cells/` and `references/`. @throws HarnessError when they cannot be made
  void make_subfolders() const;

 private:
  const std::filesystem::path path_;
  const int lock_;  // descriptor of the folder
};

}  // namespace geodesic::harness
