#include "harness/measure/phases.h"

#include <algorithm>
#include <vector>

#include "harness/base/clock.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

constexpr double kLong = 2;  // seconds

// Wall seconds of a first solve, on memory as fresh as that of the solve with timers.
double untimed_seconds(const std::string& solver, const Mesh& mesh, const Query& query) {
  std::vector<double> distances(mesh.vertex_count());
  const std::unique_ptr<Solver> fresh = make_solver(solver, mesh);
  const Stopwatch watch;
  fresh->solve(query, distances);
  return watch.real_seconds();
}

}  // namespace

Json phase_seconds(const PhaseTimes& times, double untimed) {
  double timed = 0, readings = 0;
  for (const PhaseTimes::Share* share : {&times.propagation, &times.trimming, &times.queue}) {
    timed += share->seconds;
    readings += static_cast<double>(share->readings);
  }
  const double cost = std::clamp((timed - untimed) / std::max(readings, 1.0), 0.0, times.reading);
  double overhead = 0;
  const auto net = [&](const PhaseTimes::Share& share) {
    const double taken_out = std::min(share.seconds, cost * static_cast<double>(share.readings));
    overhead += taken_out;
    return share.seconds - taken_out;
  };
  Json json{{"propagation", net(times.propagation)},
            {"trimming", net(times.trimming)},
            {"queue", net(times.queue)}};
  json["timer_overhead"] = overhead;
  return json;
}

std::optional<Json> time_phases(const std::string& solver, const Mesh& mesh, const Query& query,
                                std::span<double> distances) {
  const double before = untimed_seconds(solver, mesh, query);
  Recording recording;
  recording.what = Record::phase_times;
  make_solver(solver, mesh)->solve(query, distances, &recording);
  if (!recording.phase_times) return std::nullopt;
  // Drift of the machine matters less over a long solve.
  const double least =
      before < kLong ? std::min(before, untimed_seconds(solver, mesh, query)) : before;
  return phase_seconds(*recording.phase_times, least);
}

}  // namespace geodesic::harness
