// Distances from many sources, each by itself, as the rows of a file.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "harness/measure/matrix_file.h"
#include "meshes/point_solver.h"

namespace geodesic::harness {

struct MatrixProblem {
  std::string solver;
  const Mesh& mesh;
  std::shared_ptr<const InsertedPoints> inserted;  ///< as of PointSolver
  std::span<const Source> sources;                 ///< the rows
  /// Limit and targets: the columns; all vertices when there are none. Its sources are not used.
  const Query& asked;
};

/// Solves the rows that the file does not have, several at a time, and says on standard error how
/// far it is and how long it will take. Each thread has a solver of its own; the rows are the same
/// bits for any number of threads.
/// @throws Interrupted when a signal has come (base/interruption.h): after the rows that were being
///         solved, which are kept; and what the solver or the file throws
void solve_matrix(const MatrixProblem& problem, unsigned threads, MatrixFile& file);

}  // namespace geodesic::harness
