// The answers of `solve`: each function solves, writes files, and returns what is printed.
#pragma once

#include <optional>
#include <string>

#include "harness/base/files.h"
#include "harness/commands/solving/distance_file.h"
#include "harness/commands/solving/problem.h"

namespace geodesic::harness {

/// Where results go. Opened before the work: a bad path costs no solve.
struct Outputs {
  std::optional<DistanceFile> distances;
  std::optional<AtomicFile> paths;
};

/// To be read by a user, on the error stream.
void warn(const std::string& warning);

/// From the nearest of the sources: distances, and paths.
/// @throws WrongAnswer, HarnessError; so all
Json solve_jointly(const Problem& problem, Outputs& outputs);

/// From each source by itself: its distances in a row.
Json solve_separately(const Problem& problem, Outputs& outputs);

/// The rows of a file (measure/matrix.h); without sources all vertices are, without targets all are
/// columns.
Json write_matrix(Problem& problem);

}  // namespace geodesic::harness
