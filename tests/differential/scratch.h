// Where random meshes leave what generators read.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace geodesic::differential {

/// A folder for the calling thread, removed with it.
class Scratch {
 public:
  /// @throws std::runtime_error when it cannot be made
  Scratch() {
    std::string name =
        (std::filesystem::temp_directory_path() / "geodesic-differential-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
    folder_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace geodesic::differential
