// Which solvers verify which, from their descriptions alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Exact solvers that can verify another one, best first: the one that the user named, independent
/// oracles, other families, the faster ones (`Description::relative_time`, an unknown one last),
/// then by name. One that is `by_name_only` must be named. Which of them can do a mesh is for the
/// caller to see.
std::vector<const Description*> rank_references(const Description& verified,
                                                const std::vector<const Description*>& solvers,
                                                const std::optional<std::string>& named);

/// A solver whose distances are never too short, to bound exact ones from above; null if there is
/// none.
const Description* choose_upper_bound(const std::vector<const Description*>& solvers);

}  // namespace geodesic::harness
