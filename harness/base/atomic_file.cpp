#include "harness/base/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <sstream>

#include "harness/base/error.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void cannot_write(const fs::path& path) {
  throw CannotWrite("cannot write '" + path.string() + "': " + std::strerror(errno));
}

// Makes a new file: a link that somebody else has put there is not followed.
// @return whether it could
bool create(const fs::path& path) {
  constexpr mode_t kMode = 0666;  // less what the umask takes away
  unlink(path.c_str());
  const int file = open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, kMode);
  return file >= 0 && close(file) == 0;
}

}  // namespace

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)), written_(path_) {
  std::error_code ignored;
  auto mode = std::ios::out | std::ios::binary;
  if (fs::is_directory(path_, ignored)) {
    throw CannotWrite("cannot write '" + path_.string() + "': it is a folder");
  }
  if (!fs::exists(path_, ignored) || fs::is_regular_file(path_, ignored)) {
    written_ += std::to_string(getpid()).insert(0, 1, '.') + kPartOfFile;
    if (!create(written_)) cannot_write(path_);
    mode |= std::ios::in;  // opens what is there, and creates nothing
  }
  stream_.open(written_, mode);
  if (!stream_) cannot_write(path_);
}

AtomicFile::~AtomicFile() {
  if (committed_ || written_ == path_) return;
  stream_.close();
  std::error_code ignored;
  fs::remove(written_, ignored);
}

void AtomicFile::commit() {
  stream_.flush();
  if (!stream_) cannot_write(path_);
  stream_.close();
  if (!stream_) cannot_write(path_);
  std::error_code error;
  if (written_ != path_) fs::rename(written_, path_, error);
  if (error) throw CannotWrite("cannot write '" + path_.string() + "': " + error.message());
  committed_ = true;
}

void write_bytes(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.commit();
}

void write_json(const fs::path& path, const Json& json) {
  AtomicFile file(path);
  file.stream() << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  file.commit();
}

Json read_json(const fs::path& path, const std::string& wanted) {
  const auto unreadable = [&](const char* why) {
    return HarnessError("cannot read '" + path.string() + "': " + why +
                        (wanted.empty() ? "" : "; name " + wanted));
  };
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw unreadable("it is a folder");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  if (!file || text.bad()) throw unreadable(std::strerror(errno));
  return parse_json(text.view(), path.string());
}

}  // namespace geodesic::harness
