// Work in its own thread, for a caller that may stop waiting for it.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

namespace geodesic::python {

/// The link between work and its caller. Several threads may use it at a time.
class Task {
 public:
  virtual ~Task() = default;
  /// Counts one more finished piece of the work.
  virtual void count_piece() = 0;
  /// @throws when the caller no longer waits; work of several pieces calls this before each piece
  virtual void throw_if_abandoned() const = 0;
  /// Calls `write`, which uses memory of the caller, while the caller cannot abandon the work.
  /// @throws as throw_if_abandoned; `write` is then not called
  virtual void write_for_caller(const std::function<void()>& write) = 0;
};

/// Work in the background.
///
/// A solve cannot be stopped. When the caller stops waiting, solves that have begun go on in their
/// threads. The work must therefore own everything that it uses, except within
/// Task::write_for_caller.
class Background {
 public:
  /// @throws std::system_error when a thread cannot be started
  explicit Background(std::function<void(Task&)> work);
  /// Abandons the work, after the calls of Task::write_for_caller that have begun.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Waits until the work has ended, but not longer than `most`.
  /// @return whether the work has ended
  /// @throws the exception of the work
  bool wait(std::chrono::milliseconds most);
  /// Number of finished pieces.
  std::size_t pieces_done() const;

 private:
  class State;
  std::shared_ptr<State> state_;  // shared with the thread
};

}  // namespace geodesic::python
