#include "harness/compare/compare.h"

#include <algorithm>
#include <map>

#include "harness/base/error.h"
#include "harness/results/counters.h"
#include "harness/results/row.h"

namespace geodesic::harness {
namespace {

using Cells = std::map<std::string, const CellResult*>;

Cells by_name(const ResultFile& file) {
  Cells cells;
  for (const CellResult& cell : file.cells) cells[cell.name] = &cell;
  return cells;
}

void check_same_meshes(const ResultFile& before, const ResultFile& after) {
  const std::string corpus_before = before.ours().at("corpus");
  const std::string corpus_after = after.ours().at("corpus");
  if (corpus_before != corpus_after) {
    throw HarnessError("different corpora cannot be compared: '" + before.file.string() +
                       "' is of " + corpus_before + ", '" + after.file.string() + "' of " +
                       corpus_after);
  }
  std::map<std::string, std::string> hashes;
  for (const Json& mesh : before.ours().at("meshes")) hashes[mesh.at("name")] = mesh.at("sha256");
  for (const Json& mesh : after.ours().at("meshes")) {
    const auto known = hashes.find(mesh.at("name"));
    if (known != hashes.end() && known->second != mesh.at("sha256")) {
      throw HarnessError("mesh " + known->first + " is another file in '" + after.file.string() +
                         "' than in '" + before.file.string() +
                         "': what was measured on it cannot be compared");
    }
  }
}

std::vector<std::string> describe_differences(const ResultFile& before, const ResultFile& after) {
  std::vector<std::string> notes;
  for (const char* key : kComparedKeys) {
    const std::string old_value = before.ours().at(key), new_value = after.ours().at(key);
    if (old_value != new_value) {
      notes.push_back("the " + std::string(key) + " differs: " + old_value + " / " + new_value);
    }
  }
  return notes;
}

std::string failure(const CellResult& cell) {
  return cell.ok() ? "" : cell.outcome + ": " + cell.message;
}

// Numbers that are the same in every repetition are taken from the first.
std::optional<NumberChange> number_change(const std::string& key, const CellResult& before,
                                          const CellResult& after) {
  const std::vector<double> old_values = before.values(key), new_values = after.values(key);
  if (old_values.empty() || new_values.empty()) return std::nullopt;
  return NumberChange{key, old_values.front(), new_values.front()};
}

std::optional<TimeChange> time_change(const CellResult& before, const CellResult& after) {
  const std::vector<double> old_times = before.values("cpu_time");
  const std::vector<double> new_times = after.values("cpu_time");
  if (old_times.empty() || new_times.empty()) return std::nullopt;
  return TimeChange{.before = median(old_times),
                    .after = median(new_times),
                    .p = mann_whitney_p(old_times, new_times)};
}

CellChange cell_change(const CellResult& before, const CellResult& after, bool times) {
  CellChange change{.name = after.name,
                    .solver = after.solver,
                    .failed_before = failure(before),
                    .failed_after = failure(after),
                    .wrong_after = after.outcome == outcome::kWrongAnswer};
  if (times) change.time = time_change(before, after);
  for (const std::string& key : integer_counters()) {
    const auto changed = number_change(key, before, after);
    if (changed && changed->before != changed->after) change.counters.push_back(*changed);
  }
  change.memory = number_change("solver_peak_bytes", before, after);
  return change;
}

// A geometric mean needs times above 0.
std::vector<Overall> geometric_means(const Comparison& comparison, const Cells& before,
                                     const Cells& after) {
  std::map<std::string, std::vector<Pair>> samples;  // by solver
  std::vector<Pair> all;
  for (const CellChange& cell : comparison.cells) {
    if (!cell.time || cell.time->before <= 0 || cell.time->after <= 0) continue;
    all.emplace_back(before.at(cell.name)->values("cpu_time"),
                     after.at(cell.name)->values("cpu_time"));
    samples[cell.solver].push_back(all.back());
  }
  std::vector<Overall> overall;
  for (const auto& [solver, cells] : samples) {
    overall.push_back({solver, cells.size(), geometric_mean_ratio(cells)});
  }
  if (!all.empty()) overall.push_back({"all", all.size(), geometric_mean_ratio(all)});
  return overall;
}

template <class Predicate>
std::size_t count(const std::vector<CellChange>& cells, Predicate predicate) {
  return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), predicate));
}

}  // namespace

std::size_t Comparison::count_lost() const {
  return count(cells, [](const CellChange& cell) { return cell.lost(); });
}

std::size_t Comparison::count_wrong() const {
  return count(cells, [](const CellChange& cell) { return cell.wrong_after; });
}

Comparison compare(const ResultFile& before, const ResultFile& after) {
  check_same_meshes(before, after);
  Comparison comparison{.notes = describe_differences(before, after)};
  const bool times = before.ours().at("processor") == after.ours().at("processor");
  if (!times) comparison.notes.push_back("times of different processors are not compared");

  const Cells old_cells = by_name(before), new_cells = by_name(after);
  for (const CellResult& cell : after.cells) {
    const auto old_cell = old_cells.find(cell.name);
    if (old_cell == old_cells.end()) {
      comparison.only_after.push_back(cell.name);
    } else {
      comparison.cells.push_back(cell_change(*old_cell->second, cell, times));
    }
  }
  for (const CellResult& cell : before.cells) {
    if (!new_cells.contains(cell.name)) comparison.only_before.push_back(cell.name);
  }
  if (comparison.cells.empty()) {
    throw HarnessError("nothing to compare: '" + before.file.string() + "' and '" +
                       after.file.string() + "' have no cell in common");
  }
  const bool few =
      std::any_of(comparison.cells.begin(), comparison.cells.end(), [&](const auto& c) {
        return c.time && std::min(old_cells.at(c.name)->rows.size(),
                                  new_cells.at(c.name)->rows.size()) < kLeastRepetitions;
      });
  if (few) {
    comparison.notes.push_back("cells of fewer than " + std::to_string(kLeastRepetitions) +
                               " repetitions cannot be resolved: run with --repetitions " +
                               std::to_string(kLeastRepetitions));
  }
  comparison.overall = geometric_means(comparison, old_cells, new_cells);
  return comparison;
}

}  // namespace geodesic::harness
