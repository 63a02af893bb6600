// How the processes of cells and references end, as they tell it and as it is told of them.
#pragma once

#include <functional>
#include <string>

#include "harness/base/process.h"
#include "harness/corpus/suite.h"

namespace geodesic::harness {

/// Does the work of such a process. What it throws becomes a line on standard error and an exit
/// code that failure_of understands.
int exit_code_of(const std::function<void()>& work);

struct Failure {
  const char* outcome;  ///< results/outcome.h
  std::string why;
};

/// @param ended has not succeeded
/// @throws CannotWrite when that was its reason: whatever it computed is lost, and what comes after
///         it would be too
Failure failure_of(const Ended& ended, const ProcessLimits& limits);

/// What the suite allows the process of a cell.
ProcessLimits limits_of(const Suite& suite);

/// Gives the suite a memory limit, unless it has one: what the machine has to give, in equal parts.
/// @param processes that run at a time
void set_memory_limit(Suite& suite, unsigned processes);

}  // namespace geodesic::harness
