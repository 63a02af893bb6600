// What a long task is doing, on standard error.
#pragma once

#include <string>

#include "harness/base/clock.h"

namespace geodesic::harness {

/// "35 s", "12 min", "30 h"
std::string duration(double seconds);

/// On a terminal one line that is kept up to date; elsewhere, in a log, a line a minute.
class StatusLine {
 public:
  StatusLine();

  /// To be called about once a second.
  void show(const std::string& text);

  /// Writes a line that stays, in place of the one that is shown; in a log always.
  void write(const std::string& text);

  /// Takes away the line that is shown.
  void clear();

 private:
  const bool on_terminal_;
  bool shown_ = false;
  double logged_seconds_ = 0;  // when the log was last written to
  Stopwatch watch_;
};

}  // namespace geodesic::harness
