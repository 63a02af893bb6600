// What a recorded solve counted, under the names that result files use (results/README.md).
#pragma once

#include <string>
#include <vector>

#include "harness/base/json.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Bytes of a window in the thesis's figures of space (section 5.5.4).
inline constexpr double kThesisWindowBytes = 80;

/// @return the counters that the solver has and those derived from them; absent where it has none
Json counters(const Recording& recording, const Mesh& mesh);

/// Every key that `counters` can have.
const std::vector<std::string>& counter_names();

/// The integers among them: the same on every run and machine, so that any change is the
/// algorithm's.
const std::vector<std::string>& integer_counters();

std::size_t unreachable_vertices(std::span<const double> distances);

}  // namespace geodesic::harness
