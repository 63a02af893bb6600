#include "python/native/background.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <shared_mutex>
#include <stdexcept>
#include <thread>
#include <utility>

namespace geodesic::python {

class Background::State final : public Task {
 public:
  void count_piece() override { ++pieces_done_; }
  void throw_if_abandoned() const override {
    if (abandoned_) throw std::runtime_error("abandoned");
  }
  void write_for_caller(const std::function<void()>& write) override {
    const std::shared_lock lock(writing_);
    throw_if_abandoned();
    write();
  }

  std::size_t pieces_done() const { return pieces_done_; }
  void abandon() {
    abandoned_ = true;
    const std::unique_lock lock(writing_);  // after the writes that have begun
  }

  void end(std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    error_ = std::move(error);
    changed_.notify_all();
  }

  bool wait(std::chrono::milliseconds most) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, most, [&] { return ended_; });
    if (error_) std::rethrow_exception(error_);
    return ended_;
  }

 private:
  std::atomic<std::size_t> pieces_done_ = 0;
  std::atomic<bool> abandoned_ = false;
  std::shared_mutex writing_;  // shared by the threads that write
  std::mutex mutex_;           // guards all members below
  std::condition_variable changed_;
  bool ended_ = false;
  std::exception_ptr error_;
};

Background::Background(std::function<void(Task&)> work) : state_(std::make_shared<State>()) {
  std::thread([state = state_, work = std::move(work)]() mutable {
    std::exception_ptr error;
    try {
      std::exchange(work, {})(*state);  // frees what it owns before its end is reported
    } catch (...) {
      error = std::current_exception();
    }
    state->end(std::move(error));
  }).detach();
}

Background::~Background() { state_->abandon(); }

bool Background::wait(std::chrono::milliseconds most) { return state_->wait(most); }

std::size_t Background::pieces_done() const { return state_->pieces_done(); }

}  // namespace geodesic::python
