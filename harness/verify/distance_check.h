// Checks of distances against other distances and against bounds that hold for every shortest path.
// Runs, properties and `solve --check` use only these functions.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Largest relative error of a distance that counts as exact.
inline constexpr double kExactTolerance = 1e-12;

/// Largest allowed error of a distance.
struct Tolerance {
  double relative = kExactTolerance;
  /// Errors of distances shorter than `least` are relative to `least`, in units of length.
  double least = 0;
};

/// An error in a solver's answer.
struct Violation {
  std::string what;  ///< one line
  /// Text that is the same for this error on another mesh: "asked again, too long". Empty: `what`
  /// without its numbers.
  std::string kind = {};
  Query query = {};              ///< with the wrong answer; empty when no single query has one
  std::vector<double> got = {};  ///< distances for the query, by given numbers; may be empty
  Index vertex = kNone;          ///< the wrong vertex that is nearest to the sources
};

/// Result of a check: a violation, or nothing when the check succeeds.
using Finding = std::optional<Violation>;

/// Puts the circumstances in front of a violation: "times 1024: 3 of 12 distances ..."
Finding in(const std::string& circumstances, Finding finding);

/// How distances must relate to expected ones.
enum class Relation {
  equal,          ///< up to the tolerance, infinite in the same places
  same_bits,      ///< the tolerance is ignored
  upper_bound,    ///< not less, infinite and 0 in the same places
  at_least,       ///< not less
  at_most,        ///< not more
  same_reach,     ///< infinite and 0 in the same places, any value elsewhere: heat methods give
                  ///< negative distances
  same_infinity,  ///< infinite in the same places: with several sources, heat methods give them
                  ///< distances other than 0
};

/// (got - expected) / max(expected, least); 0 when both distances are equal. Infinite, with a sign,
/// when one distance is infinite or the divisor is 0; NaN when one distance is NaN.
double relative_error(double got, double expected, double least = 0);

/// Checks that every distance has the relation to the expected one. The message names the wrong
/// vertex with the least expected distance, where the error began, and the largest error.
/// @param query the query that the distances answer, one per vertex; likewise in all checks
Finding check_distances(const Query& query, std::span<const double> got,
                        std::span<const double> expected, Relation relation = Relation::equal,
                        const Tolerance& tolerance = {});

/// Accuracy that a solver promises for its distances.
struct Promise {
  Exactness exactness = Exactness::exact;
  double bound = 0;  ///< largest relative error of a bounded solver

  static Promise of(const Description& solver);
};

/// Checks that distances keep the promise: exact ones equal the expected distances, bounded ones
/// differ by at most the bound, upper bounds are not below, and unbounded ones reach the same
/// vertices. If an inexact distance and the right one lie on different sides of the query's limit,
/// the one beyond the limit counts as the limit. Runs, properties and explanations use this check.
/// @param tolerance for rounding, in addition to a bound
Finding check_promise(const Promise& promise, const Query& query, std::span<const double> got,
                      std::span<const double> expected, Tolerance tolerance = {});

/// Checks that |d(u) - d(v)| <= |uv| for every edge, up to the tolerance, relative to the larger
/// distance. The message names the vertex with the largest excess.
Finding check_edges(const Mesh& mesh, const Query& query, std::span<const double> distances,
                    const Tolerance& tolerance = {});

/// Lengths of the straight lines from the nearest source to the vertices, by their given numbers.
std::vector<double> straight_lines(const Mesh& mesh, const Query& query);
std::vector<double> straight_lines(const TriangleSoup& soup, const Query& query);

/// Distances to compare others with, one per vertex.
struct NamedDistances {
  std::string by;  ///< a solver, or another source of distances (references.h)
  std::span<const double> values;
};

/// Absolute relative errors over the vertices that both distances reach. A vertex with an expected
/// distance of 0 counts only if the other distance is 0 too.
struct RelativeErrors {
  double max = 0, mean = 0, rms = 0;
  double p99 = 0;  ///< the least error that 99% of the vertices do not exceed
  std::uint64_t unreachable_mismatches = 0;  ///< vertices that only one of the two reaches, or
                                             ///< whose distance is not a number
};

RelativeErrors relative_errors(std::span<const double> got, std::span<const double> expected);

struct Verdict {
  std::string error = {};      ///< empty when the distances are right; otherwise one line
  RelativeErrors errors = {};  ///< against the reference, also when the distances are right
};

/// Checks a solver's distances before solves are timed, until one of these checks fails:
/// - the promise, against the reference;
/// - the straight line: no distance is less than the straight line to the nearest source;
/// - the edge graph: an exact or bounded distance is at most the distance along edges;
/// - the edges: exact distances of neighbours differ by at most the length of their edge.
/// All checks use kExactTolerance, plus the bound of a bounded solver. Only the first check applies
/// to an unbounded solver.
/// @param query without a limit
/// @param edge_graph distances by a solver of upper bounds; may be absent
Verdict verify_distances(const Mesh& mesh, const Query& query, const Promise& promise,
                         std::span<const double> distances, const NamedDistances& reference,
                         const std::optional<NamedDistances>& edge_graph);

}  // namespace geodesic::harness
