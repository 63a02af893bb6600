// The answers of `solve`. Each function solves, writes files, and returns the JSON to print.
#pragma once

#include <optional>
#include <string>

#include "harness/base/files.h"
#include "harness/commands/solving/distance_file.h"
#include "harness/commands/solving/problem.h"

namespace geodesic::harness {

/// Output files. They are opened before the work, so that a bad path costs no solve.
struct Outputs {
  std::optional<DistanceFile> distances;
  std::optional<AtomicFile> paths, isolines;
};

/// Prints a warning for the user on the error stream.
void warn(const std::string& warning);

/// Computes the distances from the nearest of the sources, paths, and isolines.
/// @throws WrongAnswer, HarnessError, as the other functions do
Json solve_jointly(const Problem& problem, Outputs& outputs);

/// Solves each of the rows by itself: those of --each or of --sets.
Json solve_separately(const Problem& problem, Outputs& outputs);

/// Computes the distances between the points of each pair. They are in the file of distances if
/// there is one, otherwise in the JSON.
Json solve_pairs(const Problem& problem, Outputs& outputs);

}  // namespace geodesic::harness
