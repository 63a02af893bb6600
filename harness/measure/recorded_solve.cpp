#include "harness/measure/recorded_solve.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "harness/measure/allocation_meter.h"
#include "harness/measure/phases.h"
#include "harness/results/counters.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
Json record_solve(const std::string& solver, const Mesh& mesh, const Query& query,
                  std::span<double> distances) {
  Recording recording;
  std::int64_t peak = 0;
  {
    const AllocationMeter meter;
    make_solver(solver, mesh)->solve(query, distances, &recording);
    peak = meter.peak_bytes();
  }
  Json json = counters(recording, mesh);
  // A solver that counts nothing tells no phases apart either.
  if (!json.empty()) {
    std::vector<double> timed(distances.size());
    if (const auto phases = time_phases(solver, mesh, query, timed))
      json["phase_seconds"] = *phases;
    if (!identical(timed, distances)) std::copy(timed.begin(), timed.end(), distances.begin());
  }
  json["solver_peak_bytes"] = peak;
  json["unreachable_vertices"] = unreachable_vertices(distances);
  return json;
}

bool identical(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

}  // namespace geodesic::harness
