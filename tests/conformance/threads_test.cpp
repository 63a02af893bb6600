// Solver objects share nothing that changes: each may run in a thread of its own, over one mesh.
// Meant for the thread sanitizer (preset thread) as much as for what it compares.
#include <thread>

#include "tests/conformance/solver_test.h"
#include "tests/oracles/random_meshes.h"

namespace geodesic::conformance {
namespace {

class Threads : public SolverTest {};

TEST_P(Threads, with_a_solver_each_get_the_bits_of_one_alone) {
  const Mesh mesh(oracles::rough_terrain(61, 12, 12, 0.5));
  constexpr Index kThreads = 4;
  std::vector<std::vector<double>> got(kThreads), recorded(kThreads), timed(kThreads);
  {
    std::vector<std::jthread> threads;
    for (Index t = 0; t < kThreads; ++t) {
      threads.emplace_back([&, t] {
        const auto own = prepare(mesh);
        got[t] = ask(*own, mesh, from(t * 30));
        Recording counters, phases;
        phases.what = Record::phase_times;
        recorded[t] = ask(*own, mesh, from(t * 30), &counters);
        timed[t] = ask(*own, mesh, from(t * 30), &phases);
      });
    }
  }
  const auto solver = prepare(mesh);
  for (Index t = 0; t < kThreads; ++t) {
    const auto alone = ask(*solver, mesh, from(t * 30));
    EXPECT_TRUE(identical(got[t], alone)) << "from vertex " << t * 30;
    EXPECT_TRUE(identical(recorded[t], alone)) << "recorded, from vertex " << t * 30;
    EXPECT_TRUE(identical(timed[t], alone)) << "timed, from vertex " << t * 30;
  }
}

FOR_EVERY_SOLVER(Threads);

}  // namespace
}  // namespace geodesic::conformance
