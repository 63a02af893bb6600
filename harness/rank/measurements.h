// What a ranking is made of: verified cells, and times taken in pairs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/base/json.h"
#include "solvers/core/geometry.h"

namespace geodesic::harness {

/// The candidate and a rival on one mesh from one source, by turns.
struct PairedTimes {
  std::string rival;
  std::vector<double> candidate_ms = {};  ///< CPU time of a solve, an entry a pair
  std::vector<double> rival_ms = {};      ///< as many

  std::vector<double> ratios() const;  ///< candidate / rival
};

struct MeasuredSource {
  Index source;
  /// The result row of every solver, the candidate's first; it is verified and counted, and its own
  /// time is of no pair. An error row also when it was a solve of a pair that failed.
  std::vector<Json> rows = {};
  std::vector<PairedTimes> pairs = {};  ///< of rivals that are right here, where the candidate is
};

struct MeasuredMesh {
  std::string mesh;
  Index vertices;
  std::vector<MeasuredSource> sources = {};

  /// The first row of the solver that failed here; null when none did.
  const Json* failure(const std::string& solver) const;
  /// A number of the solver's rows, one a source; empty unless all have it.
  std::vector<double> numbers(const std::string& solver, const std::string& key) const;
  /// Of all sources together; absent where one of the two failed.
  std::optional<PairedTimes> times(const std::string& rival) const;
};

struct Measurements {
  std::string candidate;
  std::vector<std::string> rivals;
  std::vector<MeasuredMesh> meshes = {};
  std::vector<std::string> unfinished = {};  ///< meshes still to be measured
};

}  // namespace geodesic::harness
