// Whether distances are right: compared with others, and held against bounds that every shortest
// path obeys. Runs, properties and `solve --check` judge by these functions alone.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solvers/core/solver.h"

namespace geodesic::harness {

/// What "exact" means throughout: the largest relative error of a distance.
inline constexpr double kExactTolerance = 1e-12;

/// How far a distance may be off.
struct Tolerance {
  double relative = kExactTolerance;
  /// Errors of shorter distances are relative to this one, in units of length.
  double least = 0;
};

/// What is wrong with a solver's answer.
struct Violation {
  std::string what;  ///< one line
  /// What stays the same when this happens on another mesh: "asked again, too long". Empty: `what`
  /// without its numbers.
  std::string kind = {};
  Query query = {};              ///< that was answered wrongly; empty when no single one was
  std::vector<double> got = {};  ///< its distances in the order given; empty when there are none
  Index vertex = kNone;          ///< that is nearest to the sources of those with a wrong distance
};

/// Nothing when all is well.
using Finding = std::optional<Violation>;

/// The violation with its circumstances in front: "times 1024: 3 of 12 distances ..."
Finding in(const std::string& circumstances, Finding finding);

/// How distances must relate to expected ones.
enum class Relation {
  equal,          ///< up to the tolerance, infinite in the same places
  same_bits,      ///< whatever the tolerance
  upper_bound,    ///< not less, infinite and 0 in the same places
  at_least,       ///< not less
  at_most,        ///< not more
  same_reach,     ///< infinite and 0 in the same places, otherwise anything: heat methods give
                  ///< negative ones
  same_infinity,  ///< infinite in the same places: they give each of several sources another
                  ///< distance than 0
};

/// (got - expected) / expected, or / `least` where that is more; 0 when they are equal. Infinite,
/// with its sign, when one of them is infinite or the divisor is 0; not a number when one is not.
double relative_error(double got, double expected, double least = 0);

/// Every distance relates to the expected one as it must. The message names the wrong vertex with
/// the least expected distance, where it went wrong first, and the largest error.
/// @param query that the distances answer, one a vertex; so in all checks
Finding check_distances(const Query& query, std::span<const double> got,
                        std::span<const double> expected, Relation relation = Relation::equal,
                        const Tolerance& tolerance = {});

/// What a solver promises of its distances.
struct Promise {
  Exactness exactness = Exactness::exact;
  double bound = 0;  ///< relative error of a bounded one

  static Promise of(const Description& solver);
};

/// Distances keep the promise: exact ones equal the expected ones, bounded ones differ by no more
/// than the bound, upper bounds are not below them, and unbounded ones reach the same vertices.
/// Where an inexact distance and the right one lie on different sides of the query's limit, the one
/// beyond it counts as the limit. Runs, properties and explanations judge a solver by this.
/// @param tolerance of rounding, beside a bound
Finding check_promise(const Promise& promise, const Query& query, std::span<const double> got,
                      std::span<const double> expected, Tolerance tolerance = {});

/// |d(u) - d(v)| <= |uv| along every edge, up to the tolerance, relative to the larger distance.
/// The message names the vertex that exceeds it by most.
Finding check_edges(const Mesh& mesh, const Query& query, std::span<const double> distances,
                    const Tolerance& tolerance = {});

/// Through space from the nearest source to every vertex, in the order given: no path is shorter.
std::vector<double> straight_lines(const Mesh& mesh, const Query& query);
std::vector<double> straight_lines(const TriangleSoup& soup, const Query& query);

/// Distances that others are compared with, one a vertex.
struct NamedDistances {
  std::string by;  ///< a solver, or another source of distances (references.h)
  std::span<const double> values;
};

/// Sizes of relative errors, over the vertices that both reach and whose right distance is not 0
/// unless the distance is 0 too.
struct RelativeErrors {
  double max = 0, mean = 0, rms = 0;
  double p99 = 0;  ///< the least error that 99% of the vertices do not exceed
  std::uint64_t unreachable_mismatches = 0;  ///< vertices that one reaches and the other does not,
                                             ///< or whose distance is not a number
};

RelativeErrors relative_errors(std::span<const double> got, std::span<const double> expected);

struct Verdict {
  std::string error = {};      ///< empty when the distances are right; otherwise one line
  RelativeErrors errors = {};  ///< against the reference, right or wrong
};

/// The checks of a solver's distances before they are timed, until one fails:
/// - the promise, against the reference;
/// - the straight line: no vertex is nearer than its distance in space to the nearest source;
/// - the edge graph: an exact or bounded distance is at most that along edges;
/// - the edges: exact distances of neighbours differ by no more than their edge is long.
/// All with the tolerance of exact distances, and for a bounded solver with its bound. An unbounded
/// one promises nothing of lines and edges.
/// @param query without a limit
/// @param edge_graph from a solver of upper bounds; may be absent
Verdict verify_distances(const Mesh& mesh, const Query& query, const Promise& promise,
                         std::span<const double> distances, const NamedDistances& reference,
                         const std::optional<NamedDistances>& edge_graph);

}  // namespace geodesic::harness
