// Solver::solve as it is, with the fault that $GEODESIC_FAULT names around every solve.
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

// The faults. $GEODESIC_FAULT_AMOUNT says how much of the first three.
//   slower        per cent more time and no more instructions, as by more cache misses
//   instructions  more of them
//   memory        more bytes
//   windows       5% more propagations are counted
//   wrong         one distance of one solver is off by 1e-9
bool has_fault(std::string_view name) {
  static const char* const chosen = std::getenv("GEODESIC_FAULT");
  return chosen != nullptr && name == chosen;
}

constexpr const char* kWrongSolver = "mmp";  // the others are what it is verified by

double thread_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::size_t amount() {
  const char* text = std::getenv("GEODESIC_FAULT_AMOUNT");
  return text == nullptr ? 0 : std::strtoull(text, nullptr, 10);
}

// Under valgrind the clock runs differently, and what is modelled here costs no instructions.
void wait_for_percent_of(double seconds) {
  if (RUNNING_ON_VALGRIND) return;
  const double end = thread_seconds() + seconds * static_cast<double>(amount()) / 100;
  while (thread_seconds() < end) {
  }
}

void execute(std::size_t instructions) {
  for (std::size_t i = instructions / 2; i > 0; --i) asm volatile("");  // two each: sub, jne
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

// A macro is not expanded again inside of itself: the inner `run` is the solver's.
#define run(query, distances, recording) \
  run_with_fault([&] { run(query, distances, recording); }, description_, distances, recording)
#include "solvers/core/solver.cpp"  // NOLINT(bugprone-suspicious-include)
