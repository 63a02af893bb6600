#include "harness/measure/matrix_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "meshes/formats/npy.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void cannot_write(const fs::path& path, int error) {
  throw CannotWrite("cannot write '" + path.string() + "': " + std::strerror(error));
}

template <class T>
void store(std::span<const double> values, char* at) {
  for (const double value : values) {
    store_little_endian(static_cast<T>(value), at);
    at += sizeof(T);
  }
}

// The system keeps the pages until they are on the disk; the process needs them no more.
void give_back(char* begin, std::size_t bytes) {
  static const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto at = reinterpret_cast<std::uintptr_t>(begin), first = at & ~(page - 1);
  madvise(reinterpret_cast<void*>(first), at + bytes - first, MADV_DONTNEED);
}

}  // namespace

// FILE.unfinished, opened and locked.
class MatrixFile::Unfinished {
 public:
  Unfinished(const MatrixPlan& plan, bool resume) : file_(plan.file), path_(unfinished(plan.file)) {
    file_descriptor_.number = open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor() < 0) cannot_write(path_, errno);
    if (flock(descriptor(), LOCK_EX | LOCK_NB) != 0) {
      refuse("another process is writing it");
    }
    if (size() > 0 && !resume) {
      refuse("holds rows of an unfinished matrix: continue it with --resume, or remove it");
    }
    has_rows_ = size() > 0;
  }
  ~Unfinished() {
    std::error_code ignored;
    if (!has_rows_) fs::remove(path_, ignored);
  }
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

  const fs::path& path() const { return path_; }
  int descriptor() const { return file_descriptor_.number; }

  std::size_t size() const {
    const off_t end = lseek(descriptor(), 0, SEEK_END);
    if (end < 0) cannot_write(path_, errno);
    return static_cast<std::size_t>(end);
  }

  // Bytes at a place, fewer where the file ends.
  std::string read(std::size_t at, std::size_t count) const {
    std::string bytes(count, '\0');
    std::size_t done = 0;
    while (done < count) {
      const ssize_t got =
          pread(descriptor(), bytes.data() + done, count - done, static_cast<off_t>(at + done));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) cannot_write(path_, errno);
      if (got == 0) break;
      done += static_cast<std::size_t>(got);
    }
    bytes.resize(done);
    return bytes;
  }

  void write(std::size_t at, std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t done = pwrite(descriptor(), bytes.data(), bytes.size(), static_cast<off_t>(at));
      if (done < 0 && errno == EINTR) continue;
      if (done < 0) cannot_write(path_, errno);
      at += static_cast<std::size_t>(done);
      bytes.remove_prefix(static_cast<std::size_t>(done));
    }
  }

  // Takes the room on the disk: a map of a file that cannot grow would end the process.
  void allocate(std::size_t bytes) const {
    int error = EINTR;
    while (error == EINTR) error = posix_fallocate(descriptor(), 0, static_cast<off_t>(bytes));
    if (error == 0) return;
    throw CannotWrite("cannot write '" + path_.string() +
                      "': " + std::to_string(bytes / 1'000'000) + " MB: " + std::strerror(error));
  }

  void truncate(std::size_t bytes) const {
    if (ftruncate(descriptor(), static_cast<off_t>(bytes)) != 0) cannot_write(path_, errno);
  }

  void rename_to_file() const {
    std::error_code error;
    fs::rename(path_, file_, error);
    if (error) throw CannotWrite("cannot write '" + file_.string() + "': " + error.message());
  }

  // Nothing is left behind of a file without any.
  void keep_rows() { has_rows_ = true; }

  [[noreturn]] void refuse(const std::string& why) const {
    throw HarnessError("'" + path_.string() + "' " + why);
  }

 private:
  fs::path file_, path_;
  // Closes what it is given.
  struct Descriptor {
    int number = -1;
    ~Descriptor() {
      if (number >= 0) close(number);
    }
  };

  Descriptor file_descriptor_;
  std::atomic<bool> has_rows_ = false;
};

// The .npy file, then a byte a row that says whether it is there, then the problem: what follows
// the numbers is cut off at the end.
MatrixFile::MatrixFile(const MatrixPlan& plan, bool resume)
    : bytes_a_row_(plan.columns * (plan.single_precision ? sizeof(float) : sizeof(double))),
      single_precision_(plan.single_precision) {
  if (plan.file.extension() != ".npy") {
    throw HarnessError("'" + plan.file.string() + "': a matrix is written as .npy");
  }
  file_ = std::make_unique<Unfinished>(plan, resume);
  const std::string_view type = single_precision_ ? npy_type<float>() : npy_type<double>();
  const std::string header =
      npy_header("'" + std::string(type) + "'",
                 "(" + std::to_string(plan.rows) + ", " + std::to_string(plan.columns) + ")");
  numbers_at_ = header.size();
  flags_at_ = numbers_at_ + plan.rows * bytes_a_row_;
  const std::size_t problem_at = flags_at_ + plan.rows;
  bytes_ = problem_at + plan.problem.size();
  if (file_->size() == 0) {
    file_->allocate(bytes_);
    file_->write(problem_at, plan.problem);
    file_->write(0, header);
  } else if (file_->size() != bytes_ || file_->read(0, header.size()) != header ||
             file_->read(problem_at, plan.problem.size()) != plan.problem) {
    file_->refuse("is of another problem than this one: remove it, or name another --matrix");
  }
  before_ = file_->read(flags_at_, plan.rows);
  void* const map =
      mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED, file_->descriptor(), 0);
  if (map == MAP_FAILED) cannot_write(file_->path(), errno);
  map_ = static_cast<char*>(map);
}

MatrixFile::~MatrixFile() { munmap(map_, bytes_); }

void MatrixFile::put(std::size_t row, std::span<const double> values) {
  char* const begin = map_ + numbers_at_ + row * bytes_a_row_;
  single_precision_ ? store<float>(values, begin) : store<double>(values, begin);
  map_[flags_at_ + row] = 1;
  file_->keep_rows();
  give_back(begin, bytes_a_row_);
}

void MatrixFile::finish() {
  file_->truncate(flags_at_);
  file_->rename_to_file();
}

fs::path unfinished(const fs::path& file) { return fs::path(file) += ".unfinished"; }

}  // namespace geodesic::harness
