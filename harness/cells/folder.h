// The folder that a run or a ranking writes its results to.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace geodesic::harness {

/// Locked while it lives: no other process can have it. The system releases the lock, however the
/// process ends; a file system without locks keeps nobody out.
class ResultFolder {
 public:
  /// An empty folder, made where it is not there.
  /// @param out by default `results/<kind>/<UTC time>-<name>` of the checkout
  /// @param kind "runs", "ranks"
  /// @throws HarnessError when it cannot be made, another process has it, or it holds results
  ///         already: those never change
  static ResultFolder make(const std::optional<std::filesystem::path>& out, const std::string& kind,
                           const std::string& name);
  /// One that an earlier process made. @throws HarnessError when there is no such folder, or
  ///         another process has it
  explicit ResultFolder(std::filesystem::path path);
  ResultFolder(ResultFolder&& other) noexcept;
  ResultFolder& operator=(ResultFolder&&) = delete;
  ~ResultFolder();

  const std::filesystem::path& path() const { return path_; }
  /// Makes `cells/` and `references/`. @throws HarnessError when they cannot be made
  void make_subfolders() const;

 private:
  std::filesystem::path path_;
  int lock_;  // descriptor of the folder; -1: moved away
};

}  // namespace geodesic::harness
