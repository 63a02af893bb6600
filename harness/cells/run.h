// A run: every cell of a suite in a process of its own, and run.json made of what they wrote.
#pragma once

#include "harness/cells/failures.h"
#include "harness/cells/request.h"

namespace geodesic::harness {

/// Runs the suite. Whatever happens inside a cell becomes a row and never ends the run. Progress
/// goes to standard error, the path of run.json to standard output. A run that ends early, by
/// exception or by being killed, keeps the cells that it has finished; it says how to go on.
/// @throws HarnessError when the request makes no sense, the run folder cannot be written or
///         belongs to another run, or a run is to be gone on with that was asked for something else
/// @throws Interrupted (interruption.h)
RunResult run(RunRequest request);

}  // namespace geodesic::harness
