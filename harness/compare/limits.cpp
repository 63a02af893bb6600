#include "harness/compare/limits.h"

#include <cmath>
#include <cstdio>

#include "harness/base/error.h"

namespace geodesic::harness {
namespace {

double fraction_of(const std::string& word, const std::string& percent) {
  double value = -1;
  char rest = 0;
  if (std::sscanf(percent.c_str(), "%lf%%%c", &value, &rest) != 1 || !(value >= 0) ||
      !std::isfinite(value) || !percent.ends_with("%")) {
    throw HarnessError("--fail-on: '" + word + "' should be like time=10%");
  }
  return value / 100;
}

// "mmp/cube/src:0: time 1.25 times (4.1 ms to 5.1 ms)"
std::string line(const std::string& where, const std::string& what, double ratio, double before,
                 double after, const char* unit) {
  char text[120];
  std::snprintf(text, sizeof text, ": %s %.4g times (%.6g%s to %.6g%s)", what.c_str(), ratio,
                before, unit, after, unit);
  return where + text;
}

bool counter_exceeds(const NumberChange& change, double limit) {
  return change.after > (1 + limit) * change.before;
}

bool memory_exceeds(const NumberChange& change, double limit) {
  const double growth = change.after - change.before;
  return change.after > (1 + limit) * change.before && growth > kMemoryFloor;
}

}  // namespace

Limits parse_limits(const std::vector<std::string>& words) {
  Limits limits;
  for (const std::string& word : words) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string kind = word.substr(0, equals);
    std::optional<double>* limit = kind == "time"       ? &limits.time
                                   : kind == "counters" ? &limits.counters
                                   : kind == "memory"   ? &limits.memory
                                                        : nullptr;
    if (limit == nullptr) {
      throw HarnessError(unknown_name("kind of limit", kind, {"counters", "memory", "time"}));
    }
    *limit = fraction_of(word, word.substr(std::min(equals + 1, word.size())));
  }
  return limits;
}

std::vector<std::string> exceeded(const Comparison& comparison, const Limits& limits) {
  std::vector<std::string> lines;
  if (!limits.time && !limits.counters && !limits.memory) return lines;
  for (const CellChange& cell : comparison.cells) {
    if (cell.lost()) lines.push_back(cell.name + ": was ok, now " + cell.failed_after);
    for (const NumberChange& counter : cell.counters) {
      if (limits.counters && counter_exceeds(counter, *limits.counters)) {
        lines.push_back(
            line(cell.name, counter.name, counter.ratio(), counter.before, counter.after, ""));
      }
    }
    if (limits.memory && cell.memory && memory_exceeds(*cell.memory, *limits.memory)) {
      lines.push_back(line(cell.name, "memory", cell.memory->ratio(), cell.memory->before,
                           cell.memory->after, " B"));
    }
    if (limits.time && cell.time && cell.time->resolved() &&
        cell.time->ratio() > 1 + *limits.time) {
      lines.push_back(
          line(cell.name, "time", cell.time->ratio(), cell.time->before, cell.time->after, " ms"));
    }
  }
  for (const Overall& mean : comparison.overall) {
    if (limits.time && mean.ratio.low > 1 + *limits.time) {
      char text[80];
      std::snprintf(text, sizeof text, ": time %.4g times [%.4g, %.4g] over %zu cells",
                    mean.ratio.value, mean.ratio.low, mean.ratio.high, mean.cells);
      lines.push_back(mean.of + text);
    }
  }
  return lines;
}

}  // namespace geodesic::harness
