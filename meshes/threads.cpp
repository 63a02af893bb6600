#include "meshes/threads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace geodesic {
namespace {

class Pieces {
 public:
  explicit Pieces(std::size_t count) : count_(count) {}

  void work(const std::function<Worker()>& make_worker) {
    std::size_t piece = 0;
    try {
      const Worker worker = make_worker();
      while ((piece = next_++) < count_) worker(piece);
    } catch (...) {
      next_ = count_;
      const std::lock_guard lock(mutex_);
      if (error_ && failed_ < piece) return;
      error_ = std::current_exception();
      failed_ = piece;
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  const std::size_t count_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr error_;
  std::size_t failed_ = 0;
};

}  // namespace

void do_in_threads(std::size_t count, unsigned threads,
                   const std::function<Worker()>& make_worker) {
  Pieces pieces(count);
  {
    std::vector<std::jthread> others;  // joined at the end of the block
    try {
      for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i) {
        others.emplace_back([&] { pieces.work(make_worker); });
      }
    } catch (const std::system_error&) {  // no more threads: the existing ones do the pieces
    }
    pieces.work(make_worker);
  }
  pieces.rethrow();
}

}  // namespace geodesic
