#include "harness/run/folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/results/context.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

fs::path make_run_folder(const std::optional<fs::path>& path, const std::string& name) {
  std::string time = utc_now();
  std::erase_if(time, [](char c) { return c == '-' || c == ':'; });
  fs::path folder = path.value_or(results_folder() / "runs" / (time + "-" + name));
  make_folder(folder);
  return folder;
}

int lock_folder(const fs::path& path) {
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) {
    throw HarnessError("cannot open the folder '" + path.string() + "': " + std::strerror(errno));
  }
  if (flock(folder, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(folder);
    throw HarnessError("another process is writing to '" + path.string() +
                       "': wait for it to end, or give another folder with --out");
  }
  return folder;
}

}  // namespace

RunFolder::RunFolder(const std::optional<fs::path>& path, const std::string& name)
    : RunFolder(make_run_folder(path, name)) {
  const auto holds = [&](const char* file) { return fs::exists(path_ / file); };
  if (!holds("run.json") && !holds("request.json") && !holds("cells")) return;
  const bool unfinished = holds("request.json") && !holds("run.json");
  throw HarnessError("'" + path_.string() + "' holds a run already: remove it, " +
                     (unfinished ? "continue it with --resume, " : "") +
                     "or give another folder with --out");
}

RunFolder::RunFolder(const fs::path& path) : path_(path), lock_(lock_folder(path)) {}

RunFolder::~RunFolder() { close(lock_); }

void RunFolder::make_subfolders() const {
  make_folder(path_ / "cells");
  make_folder(path_ / "references");
}

}  // namespace geodesic::harness
