#include "harness/base/folders.h"

#include "harness/base/build_info.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

// Empty where the program is not installed. Relative to the program: the prefix may be moved.
fs::path installed_data() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  const fs::path data = (program.parent_path() / build_info().installed_data).lexically_normal();
  return fs::exists(data / "datasets" / "manifest.json") ? data : fs::path();
}

}  // namespace

fs::path data_folder() {
  const fs::path installed = installed_data();
  return installed.empty() ? fs::path(build_info().source_folder) : installed;
}

fs::path results_folder() {
  const fs::path root = installed_data().empty() ? data_folder() : fs::current_path();
  return root / "results";
}

}  // namespace geodesic::harness
