#include "harness/run/further_sources.h"

#include <algorithm>
#include <vector>

#include "harness/base/clock.h"
#include "harness/corpus/sources.h"
#include "harness/verify/distance_check.h"

namespace geodesic::harness {

FurtherSolves solve_further_sources(Solver& solver, std::span<const Index> sources,
                                    DistanceRows* exact) {
  const bool several_threads = solver.description().thread_count() > 1;
  std::vector<double> distances(solver.mesh().vertex_count());
  // Milliseconds of a solve, over the number of sources.
  const auto share_of_solve = [&](const Query& query) {
    const Stopwatch watch;
    solver.solve(query, distances);
    return 1e3 * (several_threads ? watch.real_seconds() : watch.cpu_seconds()) /
           static_cast<double>(sources.size());
  };

  FurtherSolves found{.times = {.sources = sources.size()}};
  FurtherErrors errors;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    Query query = query_from({sources[i]});
    found.times.time += share_of_solve(query);
    const std::span<const double> known =
        exact != nullptr ? exact->next() : std::span<const double>();
    if (exact != nullptr) {
      const Finding finding =
          in("from further source " + std::to_string(sources[i]),
             check_promise(Promise::of(solver.description()), query, distances, known));
      if (finding) {
        found.wrong = finding->what;
        return found;
      }
      const RelativeErrors of_source = relative_errors(distances, known);
      errors.mean += of_source.mean / static_cast<double>(sources.size());
      errors.max = std::max(errors.max, of_source.max);
    }

    const Index target = sources[(i + 1) % sources.size()];
    query.targets = {target};
    query.stop_at_targets = true;
    found.times.pair_time += share_of_solve(query);
    if (exact != nullptr) {
      const double error =
          relative_errors(std::span(distances).subspan(target, 1), known.subspan(target, 1)).max;
      errors.pair_mean += error / static_cast<double>(sources.size());
      errors.pair_max = std::max(errors.pair_max, error);
    }
  }
  if (exact != nullptr) found.errors = errors;
  return found;
}

}  // namespace geodesic::harness
