// Comparing distances. A failure names the wrong vertex with the least distance, where it went
// wrong first, and the largest error.
#pragma once

#include <span>

#include "harness/verify/finding.h"
#include "harness/verify/verify.h"

namespace geodesic::conformance {

using harness::kExactTolerance;  // what "exact" means throughout: the largest relative error

/// How far a distance may be off.
struct Tolerance {
  double relative = kExactTolerance;
  double least = 0;  ///< shorter distances may be off as much as this one, in units of length
};

/// (got - want) / want, or / `least` where that is more; 0 when they are equal; infinite when only
/// one of them is infinite, when either is not a number, and when something else than 0 was got for
/// 0 and `least` is 0 too.
double relative_error(double got, double want, double least = 0);

/// Every distance equals the expected one; infinities in the same places.
/// @param query that the distances answer, for the failure; so in all of these
Finding agree(const Query& query, std::span<const double> got, std::span<const double> want,
              const Tolerance& tolerance = {});

/// No distance is below the expected one; infinities in the same places.
Finding bound_from_above(const Query& query, std::span<const double> got,
                         std::span<const double> want, const Tolerance& tolerance = {});

/// The same bits, entry by entry.
Finding identical(const Query& query, std::span<const double> got, std::span<const double> want);

/// |d(u) - d(v)| <= |uv| along every edge, up to the tolerance.
Finding satisfies_edges(const Mesh& mesh, const Query& query, std::span<const double> distances,
                        const Tolerance& tolerance = {});

}  // namespace geodesic::conformance
