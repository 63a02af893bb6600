// Many sources, each a problem of its own, on several threads.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "harness/base/json.h"
#include "meshes/point_solver.h"

namespace geodesic::harness {

/// One solve among others.
struct SingleSolve {
  std::size_t number = 0;              ///< of its source
  std::span<const double> distances;   ///< overwritten by the thread's next solve
  std::span<const double> at_targets;  ///< the same
  double cpu_seconds = 0;              ///< of the thread that solved
  double real_seconds = 0;
  InstructionSet instruction_set = InstructionSet::plain;
};

/// What is kept of a solve.
struct Kept {
  Json json;         ///< numbers
  std::string text;  ///< distances, as they are written
};

/// Solves from every source by itself. Each thread has a solver object of its own; the mesh is
/// shared. Distances are the same bits for any number of threads.
/// @param inserted as of PointSolver
/// @param asked what is asked of every source: limit and targets; its sources are not used
/// @param keep called once a source by the thread that solved, perhaps by several at a time
/// @param deliver takes what `keep` returned, in the order of the sources, never two at a time
/// @throws what the solver, `keep` or `deliver` throws
void solve_each(const std::string& solver, const Mesh& mesh,
                const std::shared_ptr<const InsertedPoints>& inserted,
                std::span<const Source> sources, const Query& asked, unsigned threads,
                const std::function<Kept(const SingleSolve&)>& keep,
                const std::function<void(Kept)>& deliver);

}  // namespace geodesic::harness
