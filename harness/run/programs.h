// Other builds of geodesic-bench whose solvers a run measures.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/run/request.h"

namespace geodesic::harness {

/// @throws HarnessError for a single program, two programs of the same name, a name that no file
///         can have, or a missing file
void check_programs(const std::vector<Program>& programs);

/// Returns the programs with their facts: runs each on a tetrahedron, and reads its result file.
/// @param folder of the run; each program writes `programs/<name>/` in it
/// @throws HarnessError when a program cannot do that
std::vector<Program> with_facts(std::vector<Program> programs, const std::filesystem::path& folder);

}  // namespace geodesic::harness
