// Edge-based propagation on several threads, with a wavefront per region of the mesh (regions.h).
//
// All regions work in steps. In a step, each region that has mail or a vertex below the step's
// threshold has a turn: it reads the mail of the step before, advances its wavefront up to the
// threshold, and sends mail to its neighbours: windows that have landed on its portals, and shorter
// distances of shared vertices. Threads that become free take the next regions of the step.
//
// Distances are correct: every copy of a vertex that gets a shorter distance is popped in its
// region, so that each face around it is entered. Late mail drops no shortest path, since only
// lines that a real path beats are ever dropped (edge_based.cpp).
//
// They are the same bits on any number of threads: a turn depends only on its region and its mail,
// read in the order of senders, and the threshold only on the regions. No result depends on the
// thread or the time of a turn. The serial wavefront takes windows in another order: if two paths
// have the same length up to rounding, it may return the length of the other one.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solvers/core/instruction_set.h"
#include "solvers/core/start.h"
#include "solvers/edge_based/parallel/regions.h"

namespace geodesic::edge_based {

/// For meshes without crossed non-manifold edges, and queries without an early end.
class RegionalWavefront {
 public:
  /// @param threads threads of a solve, as far as there are regions for them
  /// @param region_size largest number of vertices of a region. Smaller regions divide the work
  ///        more evenly, but cost more mail.
  RegionalWavefront(const Mesh& mesh, InstructionSet set, unsigned threads, Index region_size);
  ~RegionalWavefront();

  /// Seconds of each turn, step by step.
  using TurnTimes = std::vector<std::vector<double>>;

  /// As Solver::run.
  /// @param times filled if not null; only with one thread
  void run(const Start& start, std::span<double> distances, TurnTimes* times = nullptr);

 private:
  class Steps;
  class RegionAtWork;

  void begin(const Start& start);

  const Mesh& mesh_;
  Regions regions_;
  std::unique_ptr<Steps> steps_;
  std::vector<std::unique_ptr<RegionAtWork>> at_work_;
  unsigned threads_;
};

}  // namespace geodesic::edge_based
