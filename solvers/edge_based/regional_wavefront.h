// Edge-based propagation on several threads: a wavefront for each region of the mesh (regions.h).
//
// All regions work in steps. In a step, each that has mail or a vertex below the step's threshold
// has a turn: it takes the mail of the step before, advances its wavefront up to the threshold, and
// sends its neighbours what has become of them: windows that have landed on its portals, and
// shorter distances of shared vertices. The regions of a step are shared out among threads as these
// become free.
//
// Why distances are right: every copy of a vertex that gets a shorter distance is popped in its
// region, so that each face around it is entered. News that come late drop nothing that is
// shortest, since only what a real path beats is ever dropped (edge_based.cpp).
//
// Why they are the same bits on any number of threads: a turn depends on its region and on its
// mail, taken in the order of senders; the threshold on the regions alone. Which thread does it
// when enters nowhere. The serial wavefront takes windows in another order: where two paths are of
// the same length but for rounding, its distance may be the other one's.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solvers/core/instruction_set.h"
#include "solvers/core/query.h"
#include "solvers/edge_based/regions.h"

namespace geodesic::edge_based {

/// For meshes whose non-manifold edges are not crossed, and queries without an early end.
class RegionalWavefront {
 public:
  /// @param threads that a solve uses, as far as there are regions for them
  /// @param region_size vertices of a region, at most. Smaller ones divide the work more evenly,
  /// and
  ///        cost more mail.
  RegionalWavefront(const Mesh& mesh, InstructionSet set, unsigned threads, Index region_size);
  ~RegionalWavefront();

  /// Seconds of each turn, step by step.
  using TurnTimes = std::vector<std::vector<double>>;

  /// As Solver::run.
  /// @param times filled where given; of one thread only
  void run(const InternalQuery& query, std::span<double> distances, TurnTimes* times = nullptr);

 private:
  class Steps;
  class RegionAtWork;

  void begin_at(const InternalSource& source);

  const Mesh& mesh_;
  Regions regions_;
  std::unique_ptr<Steps> steps_;
  std::vector<std::unique_ptr<RegionAtWork>> at_work_;
  unsigned threads_;
};

}  // namespace geodesic::edge_based
