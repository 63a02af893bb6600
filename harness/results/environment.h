// What times depend on besides the program: the machine, its settings and its load.
#pragma once

#include <string>

#include "harness/base/json.h"

namespace geodesic::harness {

/// The processor's name from /proc/cpuinfo, "unknown" elsewhere.
std::string processor();

/// The environment of this process now, with the keys of context.geodesic_bench.environments
/// (results/README.md). A key is absent where the system does not tell.
Json environment();

/// Whether two environments are alike but for the time and load, which always change.
bool are_alike(Json one, Json other);

}  // namespace geodesic::harness
