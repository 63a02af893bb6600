#include "harness/measure/recorded_solve.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "harness/base/allocation_meter.h"
#include "harness/base/clock.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

constexpr double kLong = 2;  // seconds

struct FirstSolve {
  double seconds;  ///< of the wall clock
  std::int64_t peak_bytes;
};

// Repeats the timed solve: without a recording, by a new object, on fresh memory.
FirstSolve first_solve(const std::string& solver, const Mesh& mesh, const Query& query) {
  std::vector<double> distances(mesh.vertex_count());
  const AllocationMeter meter;
  const std::unique_ptr<Solver> fresh = make_solver(solver, mesh);
  const Stopwatch watch;
  fresh->solve(query, distances);
  return {watch.real_seconds(), meter.peak_bytes()};
}

// Solves with timers on a new object. After a short solve, solves again without timers.
std::optional<PhaseSeconds> time_phases(const std::string& solver, const Mesh& mesh,
                                        const Query& query, std::span<double> distances,
                                        double before) {
  Recording recording;
  recording.kind = RecordingKind::phase_times;
  make_solver(solver, mesh)->solve(query, distances, &recording);
  if (!recording.phase_times) return std::nullopt;
  // Drift of the machine matters less over a long solve.
  const double least =
      before < kLong ? std::min(before, first_solve(solver, mesh, query).seconds) : before;
  return phase_seconds(*recording.phase_times, least);
}

}  // namespace

RecordedSolve record_solve(const std::string& solver, const Mesh& mesh, const Query& query,
                           std::span<double> distances) {
  RecordedSolve recorded;
  Recording recording;
  {
    const AllocationMeter meter;
    make_solver(solver, mesh)->solve(query, distances, &recording);
    recorded.peak_bytes = meter.peak_bytes();
  }
  recorded.counters = counters_of(recording, mesh);
  // A solver that counts nothing has no phases either, and needs no more memory when recorded.
  if (recorded.counters != Counters()) {
    const FirstSolve first = first_solve(solver, mesh, query);
    recorded.peak_bytes = first.peak_bytes;
    std::vector<double> timed(distances.size());
    recorded.phases = time_phases(solver, mesh, query, timed, first.seconds);
    if (!identical(timed, distances)) std::ranges::copy(timed, distances.begin());
  }
  return recorded;
}

PhaseSeconds phase_seconds(const PhaseTimes& times, double untimed) {
  double timed = 0, readings = 0;
  for (const PhaseTimes::Share* share : {&times.propagation, &times.trimming, &times.queue}) {
    timed += share->seconds;
    readings += static_cast<double>(share->readings);
  }
  const double cost = std::max((timed - untimed) / std::max(readings, 1.0), 0.0);
  PhaseSeconds phases;
  const auto net = [&](const PhaseTimes::Share& share) {
    const double overhead = std::min(share.seconds, cost * static_cast<double>(share.readings));
    phases.timer_overhead += overhead;
    return share.seconds - overhead;
  };
  phases.propagation = net(times.propagation);
  phases.trimming = net(times.trimming);
  phases.queue = net(times.queue);
  return phases;
}

bool identical(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

}  // namespace geodesic::harness
