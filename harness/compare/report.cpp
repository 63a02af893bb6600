#include "harness/compare/report.h"

#include <algorithm>

#include "harness/base/error.h"
#include "harness/base/json.h"
#include "harness/results/text_table.h"

namespace geodesic::harness {
namespace {

constexpr const char* kAbsent = "-";
constexpr const char* kUnresolved = "~";

std::string ratio(double value) { return number(value, "%.3f"); }

struct Tally {
  std::size_t slower = 0, faster = 0, unresolved = 0, counted_differently = 0;
};

Tally tally(const Comparison& comparison) {
  Tally sums;
  for (const CellChange& cell : comparison.cells) {
    if (!cell.counters.empty()) ++sums.counted_differently;
    if (!cell.time) continue;
    if (!cell.time->resolved()) {
      ++sums.unresolved;
    } else {
      ++(cell.time->ratio() > 1 ? sums.slower : sums.faster);
    }
  }
  return sums;
}

std::vector<std::string> verdict(const Comparison& comparison,
                                 const std::vector<std::string>& failures) {
  const Tally sums = tally(comparison);
  const auto of = [](std::size_t count, const char* what) {
    return std::to_string(count) + ' ' + what;
  };
  std::vector<std::string> lines;
  for (const CellChange& cell : comparison.cells) {
    if (cell.wrong_after) lines.push_back("WRONG: " + cell.name + ": " + cell.failed_after);
  }
  for (const std::string& failure : failures) lines.push_back("FAILED: " + failure);
  lines.push_back(of(comparison.cells.size(), "cells compared: ") + of(sums.slower, "slower, ") +
                  of(sums.faster, "faster, ") + of(sums.unresolved, "not resolved (~); ") +
                  of(sums.counted_differently, "counted differently; ") +
                  of(comparison.count_lost(), "that were ok and failed"));
  const auto list = [&](const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) lines.push_back(what + join(names));
  };
  list("only in the old file: ", comparison.only_before);
  list("only in the new file: ", comparison.only_after);
  lines.insert(lines.end(), comparison.notes.begin(), comparison.notes.end());
  return lines;
}

TextTable overall_table(const Comparison& comparison) {
  TextTable table{{"solver", "cells", "time new/old", "95% interval"}};
  for (const Overall& mean : comparison.overall) {
    table.push_back({mean.of, std::to_string(mean.cells),
                     mean.resolved() ? ratio(mean.ratio.value) : kUnresolved,
                     ratio(mean.ratio.low) + " to " + ratio(mean.ratio.high)});
  }
  return table;
}

std::string changes(const std::vector<NumberChange>& counters) {
  std::string text;
  for (const NumberChange& change : counters) {
    text += (text.empty() ? "" : ", ") + change.name + ' ' + number(change.before, "%.0f") +
            " -> " + number(change.after, "%.0f");
  }
  return text.empty() ? "same" : text;
}

// A cell that failed is shown with why, never dropped.
std::vector<std::string> failed_row(const CellChange& cell) {
  const auto state = [](const std::string& failed) { return failed.empty() ? "ok" : failed; };
  return {cell.name, kAbsent,
          kAbsent,   kAbsent,
          kAbsent,   "old " + state(cell.failed_before) + "; new " + state(cell.failed_after)};
}

TextTable cell_table(const Comparison& comparison) {
  TextTable table{{"cell", "old ms", "new ms", "new/old", "memory new/old", "counters"}};
  for (const CellChange& cell : comparison.cells) {
    if (!cell.failed_before.empty() || !cell.failed_after.empty()) {
      table.push_back(failed_row(cell));
      continue;
    }
    const auto time = [&](auto show) { return cell.time ? show(*cell.time) : kAbsent; };
    table.push_back(
        {cell.name, time([](const TimeChange& t) { return number(t.before); }),
         time([](const TimeChange& t) { return number(t.after); }),
         time([](const TimeChange& t) { return t.resolved() ? ratio(t.ratio()) : kUnresolved; }),
         cell.memory ? ratio(cell.memory->ratio()) : kAbsent, changes(cell.counters)});
  }
  return table;
}

Json to_json(const NumberChange& change) {
  return {{"name", change.name}, {"old", change.before}, {"new", change.after}};
}

Json to_json(const CellChange& cell) {
  Json json{{"name", cell.name}, {"solver", cell.solver}};
  json["old_failed"] = cell.failed_before.empty() ? Json(nullptr) : Json(cell.failed_before);
  json["new_failed"] = cell.failed_after.empty() ? Json(nullptr) : Json(cell.failed_after);
  json["time"] = nullptr;
  if (cell.time) {
    json["time"] = {{"old_ms", cell.time->before},
                    {"new_ms", cell.time->after},
                    {"ratio", cell.time->ratio()},
                    {"p", cell.time->p},
                    {"resolved", cell.time->resolved()}};
  }
  json["memory"] = cell.memory ? to_json(*cell.memory) : Json(nullptr);
  json["counters"] = Json::array();
  for (const NumberChange& change : cell.counters) json["counters"].push_back(to_json(change));
  return json;
}

Json to_json(const Comparison& comparison, const std::vector<std::string>& failures) {
  Json json{{"failures", failures},
            {"notes", comparison.notes},
            {"only_old", comparison.only_before},
            {"only_new", comparison.only_after},
            {"overall", Json::array()},
            {"cells", Json::array()}};
  for (const Overall& mean : comparison.overall) {
    json["overall"].push_back({{"of", mean.of},
                               {"cells", mean.cells},
                               {"ratio", mean.ratio.value},
                               {"low", mean.ratio.low},
                               {"high", mean.ratio.high},
                               {"resolved", mean.resolved()}});
  }
  for (const CellChange& cell : comparison.cells) json["cells"].push_back(to_json(cell));
  return json;
}

}  // namespace

ReportFormat report_format_named(const std::string& name) {
  if (name == "text") return ReportFormat::text;
  if (name == "markdown") return ReportFormat::markdown;
  if (name == "json") return ReportFormat::json;
  throw HarnessError(unknown_name("format", name, {"text", "markdown", "json"}));
}

std::string report(const Comparison& comparison, const std::vector<std::string>& failures,
                   ReportFormat format) {
  if (format == ReportFormat::json) return to_json(comparison, failures).dump(2) + '\n';
  const bool markdown = format == ReportFormat::markdown;
  const auto show = markdown ? as_markdown : as_text;
  std::string text;
  for (const std::string& line : verdict(comparison, failures)) {
    text += (markdown ? "- " : "") + harmless(line) + '\n';
  }
  if (!comparison.overall.empty()) text += '\n' + show(overall_table(comparison));
  return text + '\n' + show(cell_table(comparison));
}

}  // namespace geodesic::harness
