// Comparing distances, with failures that name the worst vertex and both values.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "solvers/core/mesh.h"

namespace geodesic::conformance {

/// What "exact" means throughout: the largest relative error.
inline constexpr double kExact = 1e-12;

/// Every distance equals the expected one up to kExact relative; infinities in the same places.
::testing::AssertionResult agree(const std::vector<double>& got, const std::vector<double>& want);

/// No distance is below the expected one (up to kExact relative); infinities in the same places.
::testing::AssertionResult bound_from_above(const std::vector<double>& got,
                                            const std::vector<double>& want);

/// The same bits, entry by entry.
::testing::AssertionResult identical(const std::vector<double>& got,
                                     const std::vector<double>& want);

/// |d(u) - d(v)| <= |uv| along every edge, up to kExact of the distances.
::testing::AssertionResult satisfies_edges(const Mesh& mesh, const std::vector<double>& distances);

}  // namespace geodesic::conformance
