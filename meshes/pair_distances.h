// The distances between the two points of each of many pairs.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <thread>
#include <vector>

#include "meshes/point_solver.h"

namespace geodesic {

struct PointPair {
  SurfacePoint from, to;
};

/// Pairs, sorted into solves: one from each different point at one end of the pairs, which stops at
/// the farthest of its points at the other end.
class GroupedPairs {
 public:
  /// The solves begin at `from`. If fewer of them begin at `to` and the solver is exact, they begin
  /// there, since exact distances are symmetric up to rounding.
  GroupedPairs(const Description& solver, std::span<const PointPair> pairs);

  /// The source of each solve.
  std::span<const SurfacePoint> sources() const { return sources_; }
  /// The targets of all solves.
  std::span<const SurfacePoint> targets() const { return targets_; }

  /// Solves in several threads. Distances have the same bits for any number of threads.
  /// @param next_solver called once by each thread, for a solver on the mesh that supports all
  ///        sources and targets
  /// @param before_each called before each solve, by several threads; it may throw
  /// @return one distance a pair, in the order of the pairs; infinite where no path leads
  /// @throws the exceptions of the functions and of PointSolver::solve
  std::vector<double> distances(
      const Mesh& mesh, unsigned threads,
      const std::function<std::shared_ptr<PointSolver>()>& next_solver,
      const std::function<void()>& before_each = [] {}) const;

 private:
  /// @param end, other the ends of a pair at which the solves begin and end
  GroupedPairs(std::span<const PointPair> pairs, SurfacePoint PointPair::*end,
               SurfacePoint PointPair::*other);

  std::vector<SurfacePoint> sources_, targets_;
  std::vector<std::size_t> begins_;   // of each solve among the targets; then their number
  std::vector<std::size_t> numbers_;  // of the pair that each target belongs to
};

/// As above, with solvers of their own.
/// @param solver as in make_solver
/// @param threads by default the number of processors
/// @throws std::invalid_argument for the reasons of make_solver, and for a point that is not of
///         this mesh
std::vector<double> pair_distances(const Mesh& mesh, std::span<const PointPair> pairs,
                                   std::string_view solver = "edge-based",
                                   unsigned threads = std::thread::hardware_concurrency());
inline std::vector<double> pair_distances(const Mesh& mesh, std::initializer_list<PointPair> pairs,
                                          std::string_view solver = "edge-based",
                                          unsigned threads = std::thread::hardware_concurrency()) {
  return pair_distances(mesh, std::span(pairs.begin(), pairs.size()), solver, threads);
}

}  // namespace geodesic
