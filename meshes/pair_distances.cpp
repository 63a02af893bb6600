#include "meshes/pair_distances.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "meshes/row_solver.h"
#include "meshes/threads.h"

namespace geodesic {

GroupedPairs::GroupedPairs(const Description& solver, std::span<const PointPair> pairs)
    : GroupedPairs(pairs, &PointPair::from, &PointPair::to) {
  if (solver.exactness != Exactness::exact) return;
  GroupedPairs reversed(pairs, &PointPair::to, &PointPair::from);
  if (reversed.sources_.size() < sources_.size()) *this = std::move(reversed);
}

GroupedPairs::GroupedPairs(std::span<const PointPair> pairs, SurfacePoint PointPair::*end,
                           SurfacePoint PointPair::*other)
    : numbers_(pairs.size()) {
  std::iota(numbers_.begin(), numbers_.end(), std::size_t{0});
  std::ranges::stable_sort(numbers_, {}, [&](std::size_t number) {
    const SurfacePoint& point = pairs[number].*end;
    return std::tuple(point.vertex, point.face, point.weights);
  });
  for (const std::size_t number : numbers_) {
    const PointPair& pair = pairs[number];
    if (sources_.empty() || pair.*end != sources_.back()) {
      begins_.push_back(targets_.size());
      sources_.push_back(pair.*end);
    }
    targets_.push_back(pair.*other);
  }
  begins_.push_back(targets_.size());
}

std::vector<double> GroupedPairs::distances(
    const Mesh& mesh, unsigned threads,
    const std::function<std::shared_ptr<PointSolver>()>& next_solver,
    const std::function<void()>& before_each) const {
  std::vector<double> distances(numbers_.size());
  do_in_threads(sources_.size(), threads, [&]() -> Worker {
    return [&, solver = next_solver(), at_vertices = std::vector<double>(mesh.vertex_count()),
            at_targets = std::vector<double>()](std::size_t i) mutable {
      before_each();
      const auto begin = static_cast<std::ptrdiff_t>(begins_[i]);
      const auto end = static_cast<std::ptrdiff_t>(begins_[i + 1]);
      const Query query{.sources = {{.at = sources_[i]}},
                        .targets = {targets_.begin() + begin, targets_.begin() + end},
                        .stop_at_targets = true};
      at_targets.resize(query.targets.size());
      solver->solve(query, at_vertices, at_targets);
      for (std::size_t k = 0; k < at_targets.size(); ++k) {
        distances[numbers_[begins_[i] + k]] = at_targets[k];
      }
    };
  });
  return distances;
}

std::vector<double> pair_distances(const Mesh& mesh, std::span<const PointPair> pairs,
                                   std::string_view solver, unsigned threads) {
  const GroupedPairs grouped(solver_named(solver), pairs);
  SolverForEachThread solvers(PointSolver(solver, mesh, grouped.sources(), grouped.targets()));
  return grouped.distances(mesh, threads, [&] { return solvers.next(); });
}

}  // namespace geodesic
