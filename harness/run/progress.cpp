#include "harness/run/progress.h"

#include <algorithm>
#include <cmath>

namespace geodesic::harness {
namespace {

constexpr double kProcessSeconds = 0.1;
constexpr double kGrowth = 1.3;       // exponent of the vertex count: 1.1 to 1.5 by solver
constexpr double kUntimedSolves = 3;  // warm-up, counters, phases
constexpr double kMemory = 0.7;       // weight of a cell when the next one is measured

}  // namespace

Forecast::Forecast(const std::vector<Cell>& cells, const Suite& suite) : cells_(cells) {
  for (const Cell& cell : cells) {
    Expected& expected = expected_.emplace_back();
    if (cell.unsupported() != nullptr) continue;
    const double repetitions = cell.repetition < 0 ? suite.repetitions : 1;
    double solves = repetitions;
    if (cell.is_first_repetition()) solves += kUntimedSolves;
    if (has_further_sources(cell)) solves += static_cast<double>(cell.mesh->further_sources.size());
    expected.least = kProcessSeconds + repetitions * suite.min_time;
    expected.work = solves * std::pow(cell.mesh->vertices, kGrowth);
  }
}

double Forecast::pace_of(const Description& solver) const {
  if (const auto own = paces_.find(&solver); own != paces_.end()) {
    return own->second.seconds / own->second.work;
  }
  double sum = 0;
  for (const auto& [each, pace] : paces_) sum += pace.seconds / pace.work;
  return paces_.empty() ? 0 : sum / static_cast<double>(paces_.size());
}

void Forecast::measured(std::size_t cell, double seconds) {
  const Expected& expected = expected_[cell];
  if (expected.work == 0) return;
  Pace& pace = paces_[cells_[cell].solver];
  pace.seconds = kMemory * pace.seconds + std::max(0.0, seconds - expected.least);
  pace.work = kMemory * pace.work + expected.work;
}

double Forecast::seconds_left(std::size_t first) const {
  double seconds = 0;
  for (std::size_t i = first; i < cells_.size(); ++i) {
    seconds += expected_[i].least + expected_[i].work * pace_of(*cells_[i].solver);
  }
  return seconds;
}

CellLines::CellLines(const std::vector<Cell>& cells, const Suite& suite)
    : cells_(cells), forecast_(cells, suite) {}

// "[3/40] mmp/horse/src:0  "
std::string CellLines::heading() const {
  const Cell& cell = cells_[done_];
  std::string text =
      "[" + std::to_string(done_ + 1) + "/" + std::to_string(cells_.size()) + "] " + cell.name();
  if (cell.repetition >= 0) text += " repetition " + std::to_string(cell.repetition);
  if (cell.program != nullptr) text += " by " + cell.program->name;
  return text + "  ";
}

void CellLines::working(const std::string& work) {
  line_.show(heading() + work + ", " + duration(seconds_in_cell()) + " so far");
}

void CellLines::ended(const std::string& result) {
  std::string text = heading() + result;
  const double seconds = seconds_in_cell();
  forecast_.measured(done_++, seconds);
  last_seconds_ += seconds;
  text += "  (" + duration(seconds);
  if (done_ < cells_.size()) {
    text += ", about " + duration(forecast_.seconds_left(done_)) + " left";
  }
  line_.write(text + ')');
}

}  // namespace geodesic::harness
