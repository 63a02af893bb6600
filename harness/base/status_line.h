// Progress messages of a long task, on standard error.
#pragma once

#include <cstddef>
#include <mutex>
#include <string>

#include "harness/base/clock.h"

namespace geodesic::harness {

/// A duration as text: "35 s", "12 min", "30 h".
std::string duration(double seconds);

/// On a terminal, one line that is kept up to date; in a log, one line a minute.
class StatusLine {
 public:
  StatusLine();

  /// Shows a text. Call it about once a second.
  void show(const std::string& text);

  /// Writes a line that stays, in place of the shown line. A log always gets it.
  void write(const std::string& text);

  /// Erases the shown line.
  void clear();

 private:
  const bool on_terminal_;
  bool shown_ = false;
  double logged_seconds_ = 0;  // when the log was last written to
  Stopwatch watch_;
};

/// A status line that counts: "1200 of 10000 meshes, 95 s so far". Any thread may call it.
class CountLine {
 public:
  /// @param unit noun in the plural: "meshes"
  /// @param ended number of items that need not be done
  CountLine(std::size_t total, std::string unit, std::size_t ended = 0)
      : total_(total), unit_(std::move(unit)), ended_(ended) {}
  ~CountLine() { line_.clear(); }

  void ended(std::size_t count = 1);

  /// Erases the shown line before something else is printed.
  void clear();

 private:
  const std::size_t total_;
  const std::string unit_;
  std::size_t ended_;
  double shown_seconds_ = 0;
  StatusLine line_;
  Stopwatch watch_;
  std::mutex mutex_;
};

}  // namespace geodesic::harness
