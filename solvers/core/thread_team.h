// Threads that work through one list of pieces after another and wait for each other in between.
//
// A list takes tens of microseconds, so waiting threads spin and do not sleep.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace geodesic {

class ThreadTeam {
 public:
  /// Runs work(team, thread) in up to `threads` threads, including this one, until all have ended;
  /// fewer if no more can start. All must make the same calls of `share`.
  /// @param threads at least 1; more than `most` are useless
  /// @param most largest number of pieces of a list
  /// @throws the exception that a piece threw
  template <class Work>
  static void run(unsigned threads, std::size_t most, const Work& work) {
    ThreadTeam team(most);
    {
      std::vector<std::jthread> others;
      try {
        for (unsigned t = 1; t < std::min<std::size_t>(threads, most); ++t) {
          others.emplace_back([&, t] {
            team.wait_for_start();
            work(team, t);
          });
        }
      } catch (const std::system_error&) {  // no more threads: the existing ones do the work
      }
      team.start(static_cast<unsigned>(others.size()) + 1);
      work(team, 0U);
    }
    if (team.failure_) std::rethrow_exception(team.failure_);
  }

  /// Calls piece(i) for i from 0 to count - 1, each once in some thread, then then() in one of
  /// them, before any continues. Makes no more calls once one has thrown.
  /// @param thread the calling one
  /// @param count at most `most`
  /// @param home called with i: the thread that takes piece i, unless another is free earlier
  /// @param piece, then the functions to call
  template <class Home, class Piece, class Then>
  void share(unsigned thread, std::size_t count, const Home& home, const Piece& piece,
             const Then& then) {
    for (const bool steals : {false, true}) {
      for (std::size_t i = 0; i < count; ++i) {
        if (!steals && home(i) != thread) continue;
        if (taken_[i].load(std::memory_order_relaxed) || !take(i)) continue;
        attempt([&] { piece(i); });
      }
    }
    const unsigned list = list_.load(std::memory_order_relaxed);
    if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == threads_) {
      attempt(then);
      has_stopped_ = has_failed_.load(std::memory_order_relaxed);
      arrived_.store(0, std::memory_order_relaxed);
      for (std::size_t i = 0; i < count; ++i) taken_[i].store(false, std::memory_order_relaxed);
      list_.store(list + 1, std::memory_order_release);
      return;
    }
    for (unsigned looks = 0; list_.load(std::memory_order_acquire) == list; ++looks) pause(looks);
  }

  /// A home for `share`: equal runs of successive pieces for each thread.
  auto in_equal_parts(std::size_t count) const {
    return [this, count](std::size_t i) { return static_cast<unsigned>(i * threads_ / count); };
  }

  /// Whether a call has thrown. Between two calls of `share`, all threads get the same answer.
  bool has_stopped() const { return has_stopped_; }

 private:
  explicit ThreadTeam(std::size_t most) : taken_(most) {}

  void start(unsigned threads) {
    threads_ = threads;
    list_.store(1, std::memory_order_release);
  }
  void wait_for_start() const {
    for (unsigned looks = 0; list_.load(std::memory_order_acquire) == 0; ++looks) pause(looks);
  }

  /// @return false when another thread has taken piece i
  bool take(std::size_t i);

  template <class Call>
  void attempt(const Call& call) {
    if (has_failed_.load(std::memory_order_relaxed)) return;
    try {
      call();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      has_failed_.store(true, std::memory_order_relaxed);
    }
  }

  static void pause(unsigned looks) {
    constexpr unsigned kEagerLooks = 4000;  // about 50 us; then others may need the processor
    if (looks >= kEagerLooks) return std::this_thread::yield();
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
  }

  std::vector<std::atomic<bool>> taken_;  // by piece of the current list
  unsigned threads_ = 1;
  bool has_stopped_ = false;
  std::exception_ptr failure_;
  std::mutex mutex_;
  std::atomic<bool> has_failed_ = false;
  // Each on a cache line of its own, since all threads write them.
  alignas(64) std::atomic<unsigned> arrived_ = 0;
  alignas(64) std::atomic<unsigned> list_ = 0;  // number of the current list; 0 before the first
};

}  // namespace geodesic
