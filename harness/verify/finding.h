// What is wrong with a solver's answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solvers/core/solver.h"

namespace geodesic::conformance {

struct Failure {
  std::string what;  ///< one line
  /// What is the same when this happens on another mesh: "asked again, too long, at a boundary
  /// vertex". Empty: the line, whatever its numbers are.
  std::string kind = {};
  Query query = {};  ///< that was answered wrongly; empty when no single one was
  std::vector<double> got =
      {};                ///< its distances, in the case's numbering; empty when there are none
  Index vertex = kNone;  ///< where it went wrong first, in the case's numbering
};

/// Nothing when all is well.
using Finding = std::optional<Failure>;

/// The failure with its circumstances in front: "times 1024: 3 of 12 distances ..."
Finding in(const std::string& circumstances, Finding finding);

/// A failure unless the statement holds.
/// @param otherwise what to say then
Finding require(bool holds, const std::string& otherwise);

/// "limit 1.5e-7 of 12" becomes "limit # of #".
std::string without_numbers(const std::string& text);

/// The kind of a failure on this mesh, with the role of the vertex in it and without numbers.
std::string kind_of(const Failure& failure, const Mesh& mesh);

/// What the vertex is to paths from the query's sources: "source", "boundary vertex", "saddle
/// vertex", "isolated vertex", "ordinary vertex".
std::string role_of(Index v, const Mesh& mesh, const Query& query);

}  // namespace geodesic::conformance
