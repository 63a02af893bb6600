// Compiles Solver::solve with a fault around every solve. $GEODESIC_FAULT names the fault.
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <vector>

#include "solvers/core/solver.h"

#if __has_include(<valgrind/valgrind.h>)
#include <valgrind/valgrind.h>
#else
#define RUNNING_ON_VALGRIND 0
#endif

namespace {

// The faults. A is the number in $GEODESIC_FAULT_AMOUNT.
//   slower        A per cent more time but no more instructions, as by more cache misses
//   instructions  A more instructions
//   memory        A more bytes
//   windows       5% more propagations are counted
//   wrong         one distance of one solver is off by 1e-9
bool has_fault(std::string_view name) {
  static const char* const chosen = std::getenv("GEODESIC_FAULT");
  return chosen != nullptr && name == chosen;
}

constexpr const char* kWrongSolver = "mmp";  // the other solvers verify it

double thread_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::size_t amount() {
  const char* text = std::getenv("GEODESIC_FAULT_AMOUNT");
  return text == nullptr ? 0 : std::strtoull(text, nullptr, 10);
}

// Does nothing under valgrind, where the clock differs; the wait stands for no instructions.
void wait_for_percent_of(double seconds) {
  if (RUNNING_ON_VALGRIND) return;
  const double end = thread_seconds() + seconds * static_cast<double>(amount()) / 100;
  while (thread_seconds() < end) {
  }
}

void execute(std::size_t instructions) {
  for (std::size_t i = instructions / 2; i > 0; --i) asm volatile("");  // two per turn: sub, jne
}

template <class Run>
void run_with_fault(const Run& run, const geodesic::Description& solver,
                    std::span<double> distances, geodesic::Recording* recording) {
  const std::vector<char> held(has_fault("memory") ? amount() : 0);
  const double start = thread_seconds();
  run();
  if (has_fault("slower")) wait_for_percent_of(thread_seconds() - start);
  if (has_fault("instructions")) execute(amount());
  if (has_fault("wrong") && solver.name == kWrongSolver) distances.back() *= 1 + 1e-9;
  if (has_fault("windows") && recording != nullptr && recording->window_propagations) {
    *recording->window_propagations += *recording->window_propagations / 20;
  }
}

}  // namespace

// A macro is not expanded inside itself: the inner `run` is the solver's.
#define run(start, distances) \
  run_with_fault([&] { run(start, distances); }, description_, distances, nullptr)
#define record(start, distances, recording)                                             \
  run_with_fault([&] { record(start, distances, recording); }, description_, distances, \
                 &(recording))
#include "solvers/core/solver.cpp"  // NOLINT(bugprone-suspicious-include)
