#include "python/native/background.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace geodesic::python {

struct Background::State {
  State(std::size_t pieces, std::function<Worker()> maker)
      : count(pieces), make_worker(std::move(maker)) {}

  const std::size_t count;
  const std::function<Worker()> make_worker;
  std::mutex mutex;  // of all below
  std::condition_variable changed;
  std::size_t begun = 0;
  std::size_t done = 0;
  std::exception_ptr error;

  bool take(std::size_t& piece) {
    const std::lock_guard lock(mutex);
    if (begun >= count) return false;
    piece = begun++;
    return true;
  }

  void finish() {
    const std::lock_guard lock(mutex);
    if (++done == count) changed.notify_all();
  }

  void fail(std::exception_ptr why) {
    const std::lock_guard lock(mutex);
    begun = count;
    if (!error) error = std::move(why);
    changed.notify_all();
  }

  void begin_no_more() {
    const std::lock_guard lock(mutex);
    begun = count;
  }
};

void Background::work(State& state) try {
  const Worker worker = state.make_worker();
  for (std::size_t piece = 0; state.take(piece);) {
    worker(piece);
    state.finish();
  }
} catch (...) {
  state.fail(std::current_exception());
}

Background::Background(std::size_t count, unsigned threads, std::function<Worker()> make_worker)
    : state_(std::make_shared<State>(count, std::move(make_worker))) {
  try {
    for (std::size_t i = 0; i < std::min<std::size_t>(threads, count); ++i) {
      std::thread([state = state_] { work(*state); }).detach();
    }
  } catch (...) {
    state_->begin_no_more();
    throw;
  }
}

Background::~Background() { state_->begin_no_more(); }

bool Background::wait(std::chrono::milliseconds most) {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait_for(lock, most,
                           [&] { return state_->error || state_->done == state_->count; });
  if (state_->error) std::rethrow_exception(state_->error);
  return state_->done == state_->count;
}

std::size_t Background::done() const {
  const std::lock_guard lock(state_->mutex);
  return state_->done;
}

}  // namespace geodesic::python
