#include "harness/rank/ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/base/error.h"
#include "harness/results/row.h"

namespace geodesic::harness {
namespace {

// Absent when there is nothing to take it of, or something that has no logarithm.
std::optional<double> geometric_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += std::log(value);
  if (values.empty() || !std::isfinite(sum)) return std::nullopt;
  return std::exp(sum / static_cast<double>(values.size()));
}

std::optional<double> ratio(const MeasuredMesh& mesh, const std::string& above,
                            const std::string& below, const std::string& key) {
  const auto numerator = geometric_mean(mesh.numbers(above, key));
  const auto denominator = geometric_mean(mesh.numbers(below, key));
  if (!numerator || !denominator) return std::nullopt;
  return *numerator / *denominator;
}

// Over those meshes that have the ratio.
std::optional<double> mean(const std::vector<MeshRatios>& meshes,
                           std::optional<double> MeshRatios::*member) {
  std::vector<double> values;
  for (const MeshRatios& mesh : meshes) {
    if (mesh.*member) values.push_back(*(mesh.*member));
  }
  return geometric_mean(values);
}

MeshRatios compare_on(const MeasuredMesh& mesh, const std::string& candidate,
                      const PairedTimes& times) {
  const std::vector<double> ratios = times.ratios();
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  return {.mesh = mesh.mesh,
          .time = {median_interval(ratios), ratios.size()},
          .least = *least,
          .most = *most,
          .rival_ms = median(times.rival_ms),
          .windows = ratio(mesh, candidate, times.rival, "window_propagations"),
          .memory = ratio(mesh, candidate, times.rival, "solver_peak_bytes")};
}

void compare(const Measurements& measurements, Standing& standing) {
  std::vector<std::vector<double>> samples;
  std::size_t pairs = std::numeric_limits<std::size_t>::max();
  for (const MeasuredMesh& mesh : measurements.meshes) {
    const auto times = mesh.times(standing.solver);
    if (!times) continue;
    standing.meshes.push_back(compare_on(mesh, measurements.candidate, *times));
    samples.push_back(times->ratios());
    pairs = std::min(pairs, samples.back().size());
  }
  if (samples.empty()) return;
  standing.time = {geometric_mean_of_medians(samples), pairs};
  standing.windows = mean(standing.meshes, &MeshRatios::windows);
  standing.memory = mean(standing.meshes, &MeshRatios::memory);
}

Standing standing_of(const std::string& solver, const Measurements& measurements) {
  Standing standing{.solver = solver, .all = measurements.meshes.size()};
  for (const MeasuredMesh& mesh : measurements.meshes) {
    if (mesh.failure(solver) != nullptr) continue;
    ++standing.right;
    for (const double error : mesh.numbers(solver, "max_relative_error")) {
      standing.max_relative_error = std::max(standing.max_relative_error.value_or(0), error);
    }
  }
  if (solver != measurements.candidate) compare(measurements, standing);
  return standing;
}

// A large ratio is a fast rival. A candidate that is right nowhere has no place either.
double speed(const Standing& standing, const std::string& candidate) {
  if (standing.time) return standing.time->ratio.value;
  return standing.solver == candidate && standing.right > 0 ? 1 : 0;
}

void remark_on_failures(const Measurements& measurements, Ranking& ranking) {
  for (const MeasuredMesh& mesh : measurements.meshes) {
    for (const Standing& standing : ranking.standings) {
      const Json* row = mesh.failure(standing.solver);
      if (row == nullptr) continue;
      ranking.remarks.push_back(standing.solver + " has no time on " + mesh.mesh + ": " +
                                row->at("outcome").get<std::string>() + ": " +
                                row->at("error_message").get<std::string>());
    }
  }
}

void remark_on_means(const Measurements& measurements, Ranking& ranking) {
  const std::size_t all = measurements.meshes.size();
  bool few_pairs = false;
  for (const Standing& standing : ranking.standings) {
    if (!standing.time) continue;
    few_pairs |= standing.time->pairs < kLeastForInterval;
    if (standing.meshes.size() < all) {
      ranking.remarks.push_back(
          "the means against " + standing.solver + " are over " +
          std::to_string(standing.meshes.size()) + " of " + std::to_string(all) +
          " meshes: compare them with those of others on the same meshes only");
    }
  }
  if (few_pairs) {
    ranking.remarks.push_back("fewer than " + std::to_string(kLeastForInterval) +
                              " pairs resolve nothing (~): rank with more --pairs");
  }
  if (all == 1) ranking.remarks.push_back("one mesh says nothing of others");
  if (!measurements.unfinished.empty()) {
    ranking.remarks.push_back("not measured yet: " + join(measurements.unfinished));
  }
}

}  // namespace

const Standing& Ranking::of_candidate() const {
  return *std::find_if(standings.begin(), standings.end(),
                       [&](const Standing& standing) { return standing.solver == candidate; });
}

Ranking rank(const Measurements& measurements) {
  Ranking ranking{.candidate = measurements.candidate};
  ranking.standings.push_back(standing_of(measurements.candidate, measurements));
  for (const std::string& rival : measurements.rivals) {
    ranking.standings.push_back(standing_of(rival, measurements));
  }
  std::stable_sort(ranking.standings.begin(), ranking.standings.end(),
                   [&](const Standing& a, const Standing& b) {
                     return speed(a, ranking.candidate) > speed(b, ranking.candidate);
                   });
  remark_on_failures(measurements, ranking);
  remark_on_means(measurements, ranking);
  return ranking;
}

}  // namespace geodesic::harness
