// For the file recorded.cpp of a solver's folder and no other, so that what the compiler inlines
// into a timed solve does not depend on instrumentation: a timed solve takes 3% more instructions
// in one file with it. That file instantiates Recorded for the folder's policies.
// Needs Google Highway.
#pragma once

#include "solvers/edge_based/loops.h"
#include "solvers/edge_based/recorded.h"

namespace geodesic::edge_based {

template <class Policy>
std::unique_ptr<Propagator> Recorded<Policy>::make(const Mesh& mesh, InstructionSet set,
                                                   Record what) {
  switch (what) {
    case Record::counters:
      return make_loop<Policy, CountingRecorder>(mesh, set);
    case Record::phase_times:
      return make_loop<Policy, TimingRecorder>(mesh, set);
    case Record::wavefront:
      return make_loop<Policy, WavefrontRecorder>(mesh, set);
    case Record::windows:
      break;  // refused: this solver does not keep them
  }
  return nullptr;
}

}  // namespace geodesic::edge_based
