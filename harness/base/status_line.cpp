#include "harness/base/status_line.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace geodesic::harness {
namespace {

constexpr double kSecondsBetweenLogLines = 60;
constexpr const char* kEraseLine = "\r\033[K";  // on a terminal

}  // namespace

std::string duration(double seconds) {
  char text[40];
  if (seconds < 90) {
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  } else if (seconds < 90 * 60) {
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
  } else {
    std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
  }
  return text;
}

StatusLine::StatusLine() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

void StatusLine::show(const std::string& text) {
  if (on_terminal_) {
    std::cerr << kEraseLine << text << std::flush;
    shown_ = true;
  } else if (watch_.real_seconds() - logged_seconds_ >= kSecondsBetweenLogLines) {
    write(text);
  }
}

void StatusLine::write(const std::string& text) {
  clear();
  logged_seconds_ = watch_.real_seconds();
  std::cerr << text << std::endl;
}

void StatusLine::clear() {
  if (shown_) std::cerr << kEraseLine << std::flush;
  shown_ = false;
}

void CountLine::clear() {
  const std::lock_guard lock(mutex_);
  line_.clear();
}

void CountLine::ended(std::size_t count) {
  const std::lock_guard lock(mutex_);
  ended_ += count;
  const double now = watch_.real_seconds();
  if (now - shown_seconds_ < 1) return;
  shown_seconds_ = now;
  line_.show(std::to_string(ended_) + " of " + std::to_string(total_) + ' ' + unit_ + ", " +
             duration(now) + " so far");
}

}  // namespace geodesic::harness
