#include "harness/cells/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "harness/results/row.h"

namespace geodesic::harness {
namespace {

constexpr double kSecondsBetweenLogLines = 60;
constexpr const char* kEraseLine = "\r\033[K";  // on a terminal

// Windows grow about as n^1.5; the constant is the start of a process. A guess serves: it only
// weighs large meshes against small ones.
double estimated_work(const Cell& cell) {
  if (cell.mesh->unsupported.contains(cell.solver->name)) return 0;
  return 5e4 + std::pow(cell.mesh->vertices, 1.5);
}

std::string duration(double seconds) {
  char text[40];
  if (seconds < 90) {
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  } else {
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
  }
  return text;
}

}  // namespace

Progress::Progress(const std::vector<Cell>& cells)
    : cells_(cells), on_terminal_(isatty(STDERR_FILENO) == 1) {}

double Progress::seconds_left() const {
  double seconds = 0;
  for (std::size_t i = done_; i < cells_.size(); ++i) {
    const auto known = paces_.find(cells_[i].solver->name);
    const Pace& pace = known == paces_.end() ? paces_.at("") : known->second;
    if (pace.work > 0) seconds += estimated_work(cells_[i]) * pace.seconds / pace.work;
  }
  return seconds;
}

// "[3/40] mmp/horse/src:0  "
std::string Progress::heading() const {
  const Cell& cell = cells_[done_];
  std::string text =
      "[" + std::to_string(done_ + 1) + "/" + std::to_string(cells_.size()) + "] " + cell.name();
  if (cell.repetition >= 0) text += " repetition " + std::to_string(cell.repetition);
  if (cell.program != nullptr) text += " by " + cell.program->name;
  return text + "  ";
}

void Progress::working(const std::string& work) {
  const double now = watch_.real_seconds();
  const std::string line = heading() + work + ", " + duration(seconds_in_cell());
  if (on_terminal_) {
    std::cerr << kEraseLine << line << std::flush;
  } else if (now - std::max(told_seconds_, last_seconds_) >= kSecondsBetweenLogLines) {
    told_seconds_ = now;
    std::cerr << line << " so far" << std::endl;
  }
}

void Progress::ended(const std::string& result) {
  const std::string line = heading() + result;
  const Cell& cell = cells_[done_++];
  const double seconds = seconds_in_cell();
  for (const std::string& solver : {cell.solver->name, std::string()}) {
    Pace& pace = paces_[solver];
    pace.seconds += seconds;
    pace.work += estimated_work(cell);
  }
  last_seconds_ += seconds;
  if (on_terminal_) std::cerr << kEraseLine;
  std::cerr << line << "  (" << duration(seconds);
  if (done_ < cells_.size()) std::cerr << ", about " << duration(seconds_left()) << " left";
  std::cerr << ')' << std::endl;
}

}  // namespace geodesic::harness
