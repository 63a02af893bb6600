// Work in a thread of its own, for a caller who may stop waiting for it.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

namespace geodesic::python {

/// What work and its caller know of each other; used by several threads at a time.
class Task {
 public:
  virtual ~Task() = default;
  /// One more piece of the work is done.
  virtual void count_piece() = 0;
  /// @throws when nobody waits any more; work of several pieces asks before each
  virtual void throw_if_abandoned() const = 0;
};

/// Work that is done in the background.
///
/// A solve cannot be stopped. Who stops waiting leaves what has begun to its threads. Work
/// therefore owns everything that it uses.
class Background {
 public:
  /// @throws std::system_error when a thread cannot be started
  explicit Background(std::function<void(Task&)> work);
  /// Abandons the work.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Waits until the work has ended, but not longer than `most`.
  /// @return whether it has
  /// @throws what the work throws
  bool wait(std::chrono::milliseconds most);
  /// Pieces that are done.
  std::size_t pieces_done() const;

 private:
  class State;
  std::shared_ptr<State> state_;  // shared with the thread
};

}  // namespace geodesic::python
