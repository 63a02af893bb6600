// Solves from many sources, or sets of them, each by itself, on several threads.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "harness/base/json.h"
#include "meshes/point_solver.h"

namespace geodesic::harness {

/// The result of one solve.
struct SingleSolve {
  std::size_t number = 0;              ///< index of its set of sources
  std::span<const double> distances;   ///< overwritten by the thread's next solve
  std::span<const double> at_targets;  ///< the same
  double cpu_seconds = 0;              ///< of its thread
  double real_seconds = 0;
  InstructionSet instruction_set = InstructionSet::plain;
};

/// The part of a result that is kept.
struct Kept {
  Json json;         ///< numbers of the solve
  std::string text;  ///< distances in the format of the file
};

/// Solves from every set of sources by itself. Each thread has its own solver object; the mesh and
/// the preparation are shared. Distances have the same bits for any number of threads.
/// @param asked limit and targets of every solve; its sources are not used
/// @param keep called once for each set by the thread that solved; calls may overlap
/// @param deliver called with the results of `keep` in the order of the sets, one at a time
/// @throws the exceptions of the solver, `keep` and `deliver`
void solve_each(PointSolver solver, const Mesh& mesh, std::span<const std::vector<Source>> sets,
                const Query& asked, unsigned threads,
                const std::function<Kept(const SingleSolve&)>& keep,
                const std::function<void(Kept)>& deliver);

}  // namespace geodesic::harness
