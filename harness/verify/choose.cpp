#include "harness/verify/choose.h"

#include <algorithm>
#include <tuple>

namespace geodesic::harness {

std::vector<const Description*> rank_references(const Description& verified,
                                                const std::vector<const Description*>& solvers,
                                                const std::optional<std::string>& named) {
  std::vector<const Description*> candidates;
  for (const Description* solver : solvers) {
    if (solver->exactness != Exactness::exact || solver->name == verified.name) continue;
    if (!solver->by_name_only || solver->name == named) candidates.push_back(solver);
  }
  const auto demerits = [&](const Description* solver) {
    const double time = solver->relative_time > 0 ? solver->relative_time : kInfinity;
    return std::tuple(solver->name != named, !solver->independent_oracle,
                      solver->family == verified.family, time, solver->name);
  };
  std::sort(candidates.begin(), candidates.end(),
            [&](const auto* a, const auto* b) { return demerits(a) < demerits(b); });
  return candidates;
}

const Description* choose_upper_bound(const std::vector<const Description*>& solvers) {
  const auto at = std::find_if(solvers.begin(), solvers.end(), [](const Description* solver) {
    return solver->exactness == Exactness::upper_bound;
  });
  return at == solvers.end() ? nullptr : *at;
}

}  // namespace geodesic::harness
