#include "harness/measure/recorded_solve.h"

#include <cstring>
#include <memory>

#include "harness/measure/allocation_meter.h"
#include "harness/results/counters.h"
#include "solvers/registry.h"

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
  json["solver_peak_bytes"] = peak;
  json["unreachable_vertices"] = unreachable_vertices(distances);
  return json;
}

bool identical(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

}  // namespace geodesic::harness
