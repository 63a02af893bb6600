// Other builds of geodesic-bench whose solvers a run measures.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/run/plan.h"
#include "harness/run/request.h"

namespace geodesic::harness {

/// @throws HarnessError for a single program, two of one name, a name that no file can have, and a
///         file that is not there
void check_programs(const std::vector<ProgramFile>& programs);

/// Lets each program measure a tetrahedron, for what its result file says of it.
/// @param folder of the run; each program leaves `programs/<name>/` in it
/// @throws HarnessError when a program cannot do that
std::vector<MeasuredProgram> measured_programs(const std::vector<ProgramFile>& programs,
                                               const std::filesystem::path& folder);

}  // namespace geodesic::harness
