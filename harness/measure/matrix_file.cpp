#include "harness/measure/matrix_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
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

template <class T>
void store(std::span<const double> values, char* at) {
  for (const double value : values) {
    store_little_endian(static_cast<T>(value), at);
    at += sizeof(T);
  }
}

// The system keeps the pages until they are on the disk. The process no longer needs them.
void give_back(char* begin, std::size_t bytes) {
  static const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto at = reinterpret_cast<std::uintptr_t>(begin), first = at & ~(page - 1);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): rounded to pages
  madvise(reinterpret_cast<void*>(first), at + bytes - first, MADV_DONTNEED);
}

}  // namespace

// The file FILE.unfinished: opened, locked and mapped into memory.
class MatrixFile::Unfinished {
 public:
  Unfinished(const MatrixPlan& plan, bool resume) : file_(plan.file), path_(unfinished(plan.file)) {
    file_descriptor_.number = open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file_descriptor_.number < 0) throw CannotWrite(path_, std::strerror(errno));
    if (flock(file_descriptor_.number, LOCK_EX | LOCK_NB) != 0) {
      refuse("another process is writing it");
    }
    has_rows_ = size() > 0;
    if (has_rows_ && !resume) {
      refuse("holds rows of an unfinished matrix: continue it with --resume, or remove it");
    }
  }
  ~Unfinished() {
    if (map_ != nullptr) munmap(map_, bytes_);
    std::error_code ignored;
    if (!has_rows_) fs::remove(path_, ignored);
  }
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

  std::size_t size() const { return fs::file_size(path_); }

  // Reserves disk space for a new file. Writing to a map on a full disk would end the process.
  char* map(std::size_t bytes) {
    int error = has_rows_ ? 0 : EINTR;
    while (error == EINTR) {
      error = posix_fallocate(file_descriptor_.number, 0, static_cast<off_t>(bytes));
    }
    if (error != 0) {
      throw CannotWrite(path_, std::to_string(bytes / 1'000'000) + " MB: " + std::strerror(error));
    }
    void* const map =
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file_descriptor_.number, 0);
    if (map == MAP_FAILED) throw CannotWrite(path_, std::strerror(errno));
    bytes_ = bytes;
    return map_ = static_cast<char*>(map);
  }

  // Cuts off everything after the first `bytes` bytes, and gives the file its final name.
  void finish(std::size_t bytes) const {
    std::error_code error;
    fs::resize_file(path_, bytes, error);
    if (!error) fs::rename(path_, file_, error);
    if (error) throw CannotWrite(file_, error.message());
  }

  // The destructor removes a file without rows.
  void keep_rows() { has_rows_ = true; }

  [[noreturn]] void refuse(const std::string& why) const {
    throw HarnessError("'" + path_.string() + "' " + why);
  }

 private:
  fs::path file_, path_;
  // Closes its file descriptor.
  struct Descriptor {
    int number = -1;
    ~Descriptor() {
      if (number >= 0) close(number);
    }
  };

  Descriptor file_descriptor_;
  std::atomic<bool> has_rows_ = false;
  char* map_ = nullptr;
  std::size_t bytes_ = 0;
};

// The layout is the .npy file, one byte for each row (1 if the row is there), and the problem. What
// follows the numbers is cut off at the end.
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
  const std::size_t problem_at = flags_at_ + plan.rows, bytes = problem_at + plan.problem.size();
  const std::size_t before = file_->size();
  if (before == 0 || before == bytes) map_ = file_->map(bytes);
  if (before == 0) {
    std::ranges::copy(plan.problem, map_ + problem_at);
    std::ranges::copy(header, map_);
  } else if (before != bytes || std::string_view(map_, header.size()) != header ||
             std::string_view(map_ + problem_at, plan.problem.size()) != plan.problem) {
    file_->refuse("is of another problem than this one: remove it, or name another --matrix");
  }
  before_.assign(map_ + flags_at_, plan.rows);
}

MatrixFile::~MatrixFile() = default;

void MatrixFile::put(std::size_t row, std::span<const double> values) {
  char* const begin = map_ + numbers_at_ + row * bytes_a_row_;
  single_precision_ ? store<float>(values, begin) : store<double>(values, begin);
  map_[flags_at_ + row] = 1;
  file_->keep_rows();
  give_back(begin, bytes_a_row_);
}

void MatrixFile::finish() { file_->finish(flags_at_); }

fs::path unfinished(const fs::path& file) { return fs::path(file) += ".unfinished"; }

}  // namespace geodesic::harness
