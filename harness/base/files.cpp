#include "harness/base/files.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <sstream>

#include "harness/base/build_info.h"
#include "harness/base/error.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

// Makes a new file and does not follow an existing symbolic link.
// @return whether the file was made
bool create(const fs::path& path) {
  constexpr mode_t kMode = 0666;  // the umask takes bits away
  unlink(path.c_str());
  const int file = open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, kMode);
  return file >= 0 && close(file) == 0;
}

// Empty if the program is not installed. Relative to the program, because the prefix may be moved.
fs::path installed_data() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  const fs::path data = (program.parent_path() / build_info().installed_data).lexically_normal();
  return fs::exists(data / "datasets" / "manifest.json") ? data : fs::path();
}

}  // namespace

bool is_plain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x80 && (std::isalnum(byte) != 0 || c == '.' || c == '_' || c == '-');
}

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)), written_(path_) {
  std::error_code ignored;
  auto mode = std::ios::out | std::ios::binary;
  if (fs::is_directory(path_, ignored)) {
    throw CannotWrite(path_, "it is a folder");
  }
  if (!fs::exists(path_, ignored) || fs::is_regular_file(path_, ignored)) {
    written_ += std::to_string(getpid()).insert(0, 1, '.') + kPartOfFile;
    part_.emplace(written_);
    if (!create(written_)) throw CannotWrite(path_, std::strerror(errno));
    mode |= std::ios::in;  // opens the existing file and creates none
  }
  stream_.open(written_, mode);
  if (!stream_) throw CannotWrite(path_, std::strerror(errno));
}

AtomicFile::~AtomicFile() {
  if (committed_ || written_ == path_) return;
  stream_.close();
  std::error_code ignored;
  fs::remove(written_, ignored);
}

void AtomicFile::commit() {
  stream_.close();  // fails if not everything could be written
  if (!stream_) throw CannotWrite(path_, std::strerror(errno));
  std::error_code error;
  if (written_ != path_) fs::rename(written_, path_, error);
  if (error) throw CannotWrite(path_, error.message());
  committed_ = true;
}

void write_bytes(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.commit();
}

std::string as_file_name(std::string_view name) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string file;
  for (const char c : name) {
    if (is_plain(c) && (c != '.' || !file.empty())) {
      file += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      file += {'%', kDigits[byte / 16], kDigits[byte % 16]};
    }
  }
  return file;
}

void check_name(std::string_view kind, std::string_view name) {
  constexpr std::size_t kLongest = 100;
  const bool begins = !name.empty() && is_plain(name[0]) && !std::ispunct(name[0]);
  if (begins && name.size() <= kLongest && std::ranges::all_of(name, is_plain)) return;
  throw HarnessError("invalid " + std::string(kind) + " '" + excerpt(name) + "': use at most " +
                     std::to_string(kLongest) +
                     " letters, digits, '.', '_' and '-', and begin with a letter or digit");
}

void make_folder(const fs::path& folder, const std::string& advice) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return;
  throw HarnessError("cannot make the folder '" + folder.string() + "': " + error.message() +
                     advice);
}

std::string sha256_of(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int size = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) {
    hex += "0123456789abcdef"[digest[i] >> 4];
    hex += "0123456789abcdef"[digest[i] & 15];
  }
  return hex;
}

std::string sha256_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw HarnessError("cannot read '" + path.string() + "'");
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return sha256_of(bytes.view());
}

fs::path data_folder() {
  const fs::path installed = installed_data();
  return installed.empty() ? fs::path(build_info().source_folder) : installed;
}

fs::path results_folder() {
  const fs::path root = installed_data().empty() ? data_folder() : fs::current_path();
  return root / "results";
}

}  // namespace geodesic::harness
