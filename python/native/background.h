// Work in threads of its own, for a caller who may stop waiting for it.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

namespace geodesic::python {

/// Does one piece of work after the other, in one thread.
using Worker = std::function<void(std::size_t piece)>;

/// Pieces of work that are done in the background.
///
/// A solve cannot be stopped. Who stops waiting leaves the pieces that have begun to their threads,
/// and no other piece begins. A worker therefore owns everything that it uses.
class Background {
 public:
  /// Starts on the pieces 0 to count - 1: every thread makes a worker of its own, and takes the
  /// next piece whenever it is free.
  /// @param threads at least 1; no more than there are pieces are started
  /// @throws std::system_error when a thread cannot be started
  Background(std::size_t count, unsigned threads, std::function<Worker()> make_worker);
  /// No other piece begins.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Waits until all pieces are done or one has failed, but not longer than `most`.
  /// @return whether all are done
  /// @throws the exception of a piece, or of making a worker
  bool wait(std::chrono::milliseconds most);
  /// Pieces that are done.
  std::size_t done() const;

 private:
  struct State;
  static void work(State& state);

  std::shared_ptr<State> state_;  // shared with the threads
};

}  // namespace geodesic::python
