// A ranking from start to end: a solver against others on every mesh of a suite.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "harness/cells/failures.h"
#include "harness/corpus/suite.h"

namespace geodesic::harness {

struct RankRequest {
  Suite suite;  ///< its first solver is the candidate, the others are its rivals
  std::filesystem::path manifest;
  std::optional<std::filesystem::path> out;  ///< by default `results/ranks/<UTC time>-<candidate>`
  int pairs = 9;                             ///< timed on each source, against each rival
  bool figure = true;
  std::string command;  ///< the command line, for the record
};

/// Measures and writes rank.json, rank.md, rank.tex and the figure. Whatever happens inside a cell
/// becomes a row and never ends the ranking. The files are there as soon as one mesh is finished
/// and are written anew with each; a mesh that was not finished is not in them. Progress goes to
/// standard error, rank.md to standard output.
/// @throws HarnessError when the request makes no sense or the folder cannot be written
RunResult measure_ranking(RankRequest request);

}  // namespace geodesic::harness
