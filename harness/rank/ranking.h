// Who is faster: ratios on every mesh, their means, and the order that follows.
//
// Every ratio is the candidate's number over the rival's: below 1 the candidate takes less.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/compare/statistics.h"
#include "harness/rank/measurements.h"

namespace geodesic::harness {

struct TimeRatio {
  Interval ratio;
  std::size_t pairs;  ///< the fewest that a mesh has

  /// Whether they differ: the interval leaves out 1, and there were pairs enough for one.
  bool resolved() const { return pairs >= kLeastForInterval && (ratio.low > 1 || ratio.high < 1); }
};

/// One rival on one mesh.
struct MeshRatios {
  std::string mesh;
  TimeRatio time;  ///< median over pairs
  double least;    ///< of the pairs' ratios
  double most;
  double rival_ms;                ///< median over pairs
  std::optional<double> windows;  ///< of window_propagations, geometric mean over sources
  std::optional<double> memory;   ///< of solver_peak_bytes, likewise
};

struct Standing {
  std::string solver;
  std::size_t right = 0;                            ///< meshes that it solved rightly,
  std::size_t all = 0;                              ///< of so many
  std::optional<double> max_relative_error = {};    ///< over those
  std::vector<MeshRatios> meshes = {};              ///< where both could be timed
  std::optional<TimeRatio> time = {};               ///< geometric means over `meshes`;
  std::optional<double> windows = {}, memory = {};  ///< absent without any, and of the candidate
};

struct Ranking {
  std::string candidate;
  std::vector<Standing> standings = {};  ///< fastest first; those that have no mean last
  std::vector<std::string> remarks = {};

  const Standing& of_candidate() const;
};

/// The order is that of the means, the candidate's being 1. Geometric means are over those meshes
/// that both solvers did; remarks say where that is not every mesh, and what failed.
/// @param measurements at least one mesh
Ranking rank(const Measurements& measurements);

}  // namespace geodesic::harness
