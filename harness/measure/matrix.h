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
  const Mesh& mesh;
  std::span<const Source> sources;  ///< the rows
  /// Its limit and targets are used, not its sources. Without targets, all vertices are columns.
  const Query& asked;
};

/// Solves the rows that the file lacks, several at a time, and shows the progress on standard
/// error. Each thread has its own solver with the same preparation. The rows have the same bits for
/// any number of threads.
/// @throws Interrupted when a signal has come (base/interruption.h), after the rows that were being
///         solved are kept; also throws the exceptions of the solver and the file
void solve_matrix(const MatrixProblem& problem, PointSolver solver, unsigned threads,
                  MatrixFile& file);

}  // namespace geodesic::harness
