// Other builds of geodesic-bench whose solvers a run measures.
#pragma once

#include <filesystem>
#include <vector>

#include "harness/run/plan.h"
#include "harness/run/request.h"

namespace geodesic::harness {

/// @throws HarnessError for a single program, two programs of the same name, a name that no file
///         can have, or a missing file
void check_programs(const std::vector<ProgramFile>& programs);

/// Runs each program on a tetrahedron, to read the facts about the program in its result file.
/// @param folder of the run; each program writes `programs/<name>/` in it
/// @throws HarnessError when a program cannot do that
std::vector<MeasuredProgram> measured_programs(const std::vector<ProgramFile>& programs,
                                               const std::filesystem::path& folder);

}  // namespace geodesic::harness
