#include "harness/base/scratch_folder.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <string>

#include "harness/base/error.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPrefix = "geodesic-bench-of-";  // followed by the process id

void remove_abandoned_folders(const fs::path& temporary) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(temporary, ignored)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(kPrefix)) continue;
    pid_t owner = 0;
    std::from_chars(name.data() + kPrefix.size(), name.data() + name.size(), owner);
    if (owner > 0 && kill(owner, 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), ignored);
  }
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  remove_abandoned_folders(temporary);
  std::string name = temporary / (std::string(kPrefix) + std::to_string(getpid()) + "-XXXXXX");
  if (error || mkdtemp(name.data()) == nullptr) {
    throw HarnessError("cannot make a folder like '" + name +
                       "' for temporary files; set TMPDIR to one that can be written to");
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace geodesic::harness
