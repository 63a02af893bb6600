#include "harness/measure/path_measurement.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <vector>

#include "harness/base/clock.h"
#include "harness/corpus/sources.h"
#include "solvers/core/registry.h"
#include "solvers/paths/paths.h"

namespace geodesic::harness {
namespace {

constexpr std::size_t kTimes = 3;     // measurements of work, fewer if it takes long
constexpr double kAsLong = 1;         // seconds after which work is not repeated
constexpr std::size_t kAlone = 3;     // targets with a query of their own
constexpr double kSameLength = 1e-9;  // relative excess of a path that is a shortest one

// Solves, and then gives paths: those that the solver remembers, or those that it traces itself.
class PathSolver {
 public:
  PathSolver(const Description& solver, const Mesh& mesh)
      : remembers_(solver.abilities.paths),
        mesh_(mesh),
        solver_(make_solver(solver.name, mesh)),
        distances_(mesh.vertex_count()) {}

  void solve(const Query& query) {
    if (remembers_) {
      remembered_.emplace(solve_paths(*solver_, mesh_, query));
    } else {
      query_ = query;
      solver_->solve(query, distances_);
    }
  }

  Path to(Index vertex) {
    return remembers_ ? remembered_->to_vertex(vertex) : solver_->trace(query_, distances_, vertex);
  }

 private:
  bool remembers_;
  const Mesh& mesh_;
  std::unique_ptr<Solver> solver_;
  Query query_;
  std::vector<double> distances_;
  std::optional<Paths> remembered_;
};

bool leads(const Path& path, Index source, Index target) {
  return path.points.front().at == SurfacePoint(source) &&
         path.points.back().at == SurfacePoint(target);
}

bool keeps_to_the_surface(const Path& path) {
  return std::all_of(path.points.begin(), path.points.end() - 1,
                     [](const PathPoint& point) { return point.face != kNone; });
}

// The time of the work in milliseconds. For short work, the median of several times.
template <class Work>
double time_of(const Description& solver, const Work& work) {
  std::vector<double> times;
  const Stopwatch all;
  while (times.size() < kTimes && (times.empty() || all.real_seconds() < kAsLong)) {
    const Stopwatch watch;
    work();
    times.push_back(1e3 * (solver.thread_count() > 1 ? watch.real_seconds() : watch.cpu_seconds()));
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::ranges::nth_element(times, middle);
  return *middle;
}

// The time of a path that cannot be traced counts too.
void trace(PathSolver& solver, Index target) {
  try {
    solver.to(target);
  } catch (const std::exception&) {
  }
}

}  // namespace

PathNumbers measure_paths(const Description& solver, const Mesh& mesh, Index source,
                          std::size_t count, std::span<const double> exact) {
  std::vector<Index> targets = spread_vertices(mesh, source, count + 1, exact);
  targets.erase(targets.begin());  // the source
  PathNumbers numbers{.targets = targets.size()};
  if (targets.empty()) return numbers;
  const Query query{.sources = {{.at = source}}};

  PathSolver paths(solver, mesh);
  numbers.first_time = time_of(solver, [&] {
    paths.solve(query);
    trace(paths, targets.front());
  });
  numbers.further_time = time_of(solver,
                                 [&] {
                                   for (const Index target : targets) trace(paths, target);
                                 }) /
                         static_cast<double>(targets.size());
  for (const Index target : targets) {
    try {
      const Path path = paths.to(target);
      if (!leads(path, source, target)) {
        ++numbers.failed;
      } else if (!keeps_to_the_surface(path)) {
        ++numbers.off_surface;
      } else {
        const double excess = path.length() / exact[target] - 1;
        numbers.max_excess = std::max(numbers.max_excess, excess);
        numbers.mean_excess += excess;
        if (excess <= kSameLength) ++numbers.shortest;
      }
    } catch (const std::exception&) {
      ++numbers.failed;
    }
  }
  const std::size_t sound = targets.size() - numbers.failed - numbers.off_surface;
  if (sound > 0) numbers.mean_excess /= static_cast<double>(sound);

  const std::size_t alone = std::min(kAlone, targets.size());
  numbers.alone_time =
      time_of(
          solver,
          [&] {
            for (std::size_t i = 0; i < alone; ++i) {
              const Index target = targets[i * targets.size() / alone];
              paths.solve({.sources = query.sources, .targets = {target}, .stop_at_targets = true});
              trace(paths, target);
            }
          }) /
      static_cast<double>(alone);
  return numbers;
}

}  // namespace geodesic::harness
