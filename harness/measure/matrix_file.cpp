#include "harness/measure/matrix_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <utility>
#include <vector>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/measure/npz.h"
#include "meshes/formats/npy.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void cannot_write(const fs::path& path, int error) {
  throw CannotWrite("cannot write '" + path.string() + "': " + std::strerror(error));
}

// Closes what it is given.
struct Descriptor {
  int number = -1;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

// FILE.unfinished, opened and locked.
class Unfinished {
 public:
  Unfinished(const MatrixPlan& plan, bool resume) : file_(plan.file), path_(unfinished(plan.file)) {
    file_descriptor_.number = open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor() < 0) cannot_write(path_, errno);
    if (flock(descriptor(), LOCK_EX | LOCK_NB) != 0) {
      refuse("another process is writing it");
    }
    if (size() > 0 && !resume) {
      refuse(
          "holds rows of a matrix that was not finished: --resume goes on with it; or remove it");
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

  void refuse(const std::string& why) const {
    throw HarnessError("'" + path_.string() + "' " + why);
  }
  void refuse_other_problem() const {
    refuse("is of another problem than this one: remove it, or name another --matrix");
  }

 private:
  fs::path file_, path_;
  Descriptor file_descriptor_;
  std::atomic<bool> has_rows_ = false;
};

template <class T>
std::string dense_header(const MatrixPlan& plan) {
  return npy_header("'" + std::string(npy_type<T>()) + "'",
                    "(" + std::to_string(plan.rows) + ", " + std::to_string(plan.columns) + ")");
}

// The .npy file, then a byte a row that says whether it is there, then the problem: what follows
// the numbers is cut off at the end.
template <class T>
class DenseFile final : public MatrixFile {
 public:
  DenseFile(const MatrixPlan& plan, bool resume)
      : file_(plan, resume), rows_(plan.rows), columns_(plan.columns) {
    const std::string header = dense_header<T>(plan);
    numbers_at_ = header.size();
    flags_at_ = numbers_at_ + rows_ * columns_ * sizeof(T);
    const std::size_t problem_at = flags_at_ + rows_;
    bytes_ = problem_at + plan.problem.size();
    if (file_.size() == 0) {
      file_.allocate(bytes_);
      file_.write(problem_at, plan.problem);
      file_.write(0, header);
    } else if (file_.size() != bytes_ || file_.read(0, header.size()) != header ||
               file_.read(problem_at, plan.problem.size()) != plan.problem) {
      file_.refuse_other_problem();
    }
    before_ = file_.read(flags_at_, rows_);
    void* const map =
        mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED, file_.descriptor(), 0);
    if (map == MAP_FAILED) cannot_write(file_.path(), errno);
    map_ = static_cast<char*>(map);
  }
  ~DenseFile() override { munmap(map_, bytes_); }

  bool has(std::size_t row) const override { return before_[row] != 0; }

  void put(std::size_t row, std::span<const double> values) override {
    char* const begin = map_ + numbers_at_ + row * columns_ * sizeof(T);
    char* at = begin;
    for (const double value : values) {
      store_little_endian(static_cast<T>(value), at);
      at += sizeof(T);
    }
    map_[flags_at_ + row] = 1;
    file_.keep_rows();
    give_back(begin, at);
  }

  void finish() override {
    file_.truncate(flags_at_);
    file_.rename_to_file();
  }

 private:
  // The system keeps the pages until they are on the disk; the process needs them no more.
  static void give_back(char* begin, char* end) {
    static const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto first = reinterpret_cast<std::uintptr_t>(begin) & ~(page - 1);
    madvise(reinterpret_cast<void*>(first), reinterpret_cast<std::uintptr_t>(end) - first,
            MADV_DONTNEED);
  }

  Unfinished file_;
  std::size_t rows_, columns_;
  std::size_t numbers_at_ = 0, flags_at_ = 0, bytes_ = 0;
  std::string before_;  // a byte a row
  char* map_ = nullptr;
};

// The problem, then a record a row: its number, how many entries it has, their columns, their
// values. A record that is cut off at the end was being written.
template <class T>
class SparseFile final : public MatrixFile {
 public:
  SparseFile(const MatrixPlan& plan, bool resume)
      : file_(plan, resume), output_(plan.file), columns_(plan.columns), records_(plan.rows) {
    if (file_.size() == 0) {
      file_.write(0, plan.problem);
    } else if (file_.read(0, plan.problem.size()) != plan.problem) {
      file_.refuse_other_problem();
    }
    end_ = plan.problem.size();
    while (read_record()) {
    }
    file_.truncate(end_);
    before_.resize(records_.size());
    for (std::size_t row = 0; row < records_.size(); ++row) before_[row] = records_[row].at != 0;
  }

  bool has(std::size_t row) const override { return before_[row]; }

  void put(std::size_t row, std::span<const double> values) override {
    std::string columns, numbers;
    std::uint64_t entries = 0;
    for (std::size_t column = 0; column < values.size(); ++column) {
      if (std::isinf(values[column])) continue;
      append_little_endian(columns, static_cast<std::int64_t>(column));
      append_little_endian(numbers, static_cast<T>(values[column]));
      ++entries;
    }
    std::string record;
    append_little_endian(record, std::uint64_t{row});
    append_little_endian(record, entries);
    record.append(columns).append(numbers);
    const std::lock_guard lock(mutex_);
    file_.write(end_, record);
    records_[row] = {end_ + kRecordHead, entries};
    end_ += record.size();
    file_.keep_rows();
  }

  void finish() override {
    AtomicFile output(output_);
    NpzWriter npz(output.stream());
    write_begins(npz);
    begin<std::int64_t>(npz, "indices.npy", entries());
    for (const Record& record : records_) npz.append(file_.read(record.at, columns_of(record)));
    npz.end();
    begin<T>(npz, "data.npy", entries());
    for (const Record& record : records_) {
      npz.append(file_.read(record.at + columns_of(record), record.entries * sizeof(T)));
    }
    npz.end();
    npz.add("shape.npy",
            npy_bytes<std::int64_t>(std::vector{static_cast<std::int64_t>(records_.size()),
                                                static_cast<std::int64_t>(columns_)}));
    npz.add("format.npy", npy_header("'|S3'", "()") + "csr");
    npz.finish();
    output.commit();
    fs::remove(file_.path());
  }

 private:
  static constexpr std::size_t kRecordHead = 16;
  struct Record {
    std::size_t at = 0;  // of its columns in the file; 0: the row is not there
    std::uint64_t entries = 0;
  };

  static std::size_t columns_of(const Record& record) {
    return record.entries * sizeof(std::int64_t);
  }

  bool read_record() {
    const std::string head = file_.read(end_, kRecordHead);
    if (head.size() < kRecordHead) return false;
    const auto row = load_number<std::uint64_t>(head.data(), std::endian::little);
    const auto entries = load_number<std::uint64_t>(head.data() + 8, std::endian::little);
    if (row >= records_.size() || entries > columns_) return false;
    const Record record{end_ + kRecordHead, entries};
    const std::size_t end = record.at + columns_of(record) + entries * sizeof(T);
    if (end > file_.size()) return false;
    records_[row] = record;
    end_ = end;
    return true;
  }

  std::uint64_t entries() const {
    std::uint64_t sum = 0;
    for (const Record& record : records_) sum += record.entries;
    return sum;
  }

  void write_begins(NpzWriter& npz) const {
    std::vector<std::int64_t> begins{0};
    for (const Record& record : records_) {
      begins.push_back(begins.back() + static_cast<std::int64_t>(record.entries));
    }
    npz.add("indptr.npy", npy_bytes<std::int64_t>(begins));
  }

  template <class Number>
  static void begin(NpzWriter& npz, const std::string& name, std::uint64_t count) {
    npz.begin(name);
    npz.append(npy_header("'" + std::string(npy_type<Number>()) + "'",
                          "(" + std::to_string(count) + ",)"));
  }

  Unfinished file_;
  fs::path output_;
  std::size_t columns_;
  std::vector<Record> records_;  // by row
  std::vector<bool> before_;     // by row: there when this object was made
  std::size_t end_ = 0;          // of the last whole record
  std::mutex mutex_;
};

}  // namespace

fs::path unfinished(const fs::path& file) { return fs::path(file) += ".unfinished"; }

std::unique_ptr<MatrixFile> open_matrix(const MatrixPlan& plan, bool resume) {
  const bool sparse = plan.file.extension() == ".npz";
  if (!sparse && plan.file.extension() != ".npy") {
    throw HarnessError("'" + plan.file.string() +
                       "': a matrix is written as .npy, or with --limit as .npz");
  }
  if (plan.single_precision) {
    if (sparse) return std::make_unique<SparseFile<float>>(plan, resume);
    return std::make_unique<DenseFile<float>>(plan, resume);
  }
  if (sparse) return std::make_unique<SparseFile<double>>(plan, resume);
  return std::make_unique<DenseFile<double>>(plan, resume);
}

}  // namespace geodesic::harness
