// Many sources, each a problem of its own, on several threads.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "harness/base/json.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

/// One solve among others.
struct SingleSolve {
  Index source = kNone;
  std::span<const double> distances;  ///< overwritten by the thread's next solve
  double cpu_seconds = 0;             ///< of the thread that solved
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
/// @param keep called once a source by the thread that solved, perhaps by several at a time
/// @param deliver takes what `keep` returned, in the order of the sources, never two at a time
/// @throws what the solver, `keep` or `deliver` throws
void solve_each(const std::string& solver, const Mesh& mesh, const std::vector<Index>& sources,
                double limit, unsigned threads, const std::function<Kept(const SingleSolve&)>& keep,
                const std::function<void(Kept)>& deliver);

}  // namespace geodesic::harness
