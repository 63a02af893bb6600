// Runs every cell of a suite in a separate process and writes run.json from their results.
#pragma once

#include "harness/run/request.h"
#include "harness/run/summary.h"

namespace geodesic::harness {

/// Runs the suite. Every failure inside a cell becomes a row and never ends the run. Progress goes
/// to standard error, the path of run.json to standard output. A run that ends early, by an
/// exception or by being killed, keeps the cells that it has finished; the command that measures
/// the others goes to standard error.
/// @throws HarnessError when the request is invalid, the run folder cannot be written or
///         belongs to another run, or the run to resume had another request
/// @throws Interrupted (interruption.h)
RunResult run(RunRequest request);

}  // namespace geodesic::harness
