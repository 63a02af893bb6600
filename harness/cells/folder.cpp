#include "harness/cells/folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/results/context.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

void make_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw HarnessError("cannot make the folder '" + folder.string() + "': " + error.message());
  }
}

}  // namespace

RunFolder RunFolder::make(const std::optional<fs::path>& out, const std::string& corpus) {
  std::string time = utc_now();
  std::erase_if(time, [](char c) { return c == '-' || c == ':'; });
  const fs::path path = out.value_or(results_folder() / "runs" / (time + "-" + corpus));
  make_folders(path);
  RunFolder folder(path);
  const auto holds = [&](const char* file) { return fs::exists(folder.path() / file); };
  if (std::ranges::any_of(std::array{"run.json", "request.json", "cells"}, holds)) {
    const bool unfinished = holds("request.json") && !holds("run.json");
    throw HarnessError("'" + folder.path().string() + "' holds a run already: remove it, " +
                       (unfinished ? "continue it with --resume, " : "") +
                       "or give another folder with --out");
  }
  return folder;
}

RunFolder::RunFolder(fs::path path)
    : path_(std::move(path)), lock_(open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (lock_ < 0) {
    throw HarnessError("cannot open the folder '" + path_.string() + "': " + std::strerror(errno));
  }
  if (flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(lock_);
    throw HarnessError("another process is writing to '" + path_.string() +
                       "': wait for it to end, or give another folder with --out");
  }
}

RunFolder::RunFolder(RunFolder&& other) noexcept
    : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}

RunFolder::~RunFolder() {
  if (lock_ >= 0) close(lock_);
}

void RunFolder::make_subfolders() const {
  make_folders(path_ / "cells");
  make_folders(path_ / "references");
}

}  // namespace geodesic::harness
