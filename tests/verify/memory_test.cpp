// An object holds no more memory after many solves than after the first ones.
#include "harness/base/allocation_meter.h"
#include "meshes/generators/generators.h"
#include "tests/verify/solver_test.h"

namespace geodesic::harness {
namespace {

class MemoryOfAnObject : public SolverTest {};

TEST_P(MemoryOfAnObject, is_the_same_after_the_same_solves_again) {
  const Mesh mesh(generate("involute", {{"corners", 1100}}));
  if (mesh.vertex_count() > abilities().max_vertices || description().independent_oracle ||
      description().by_name_only) {
    GTEST_SKIP() << "slow on this mesh";
  }
  std::vector<double> distances(mesh.vertex_count());
  const AllocationMeter meter;
  const auto solver = prepare(mesh);
  const auto bytes_after_round = [&] {
    for (const Index source : {0u, 1650u}) solver->solve({.sources = {{source}}}, distances);
    return meter.live_bytes();
  };
  bytes_after_round();
  const std::int64_t second = bytes_after_round(), third = bytes_after_round();
  EXPECT_EQ(third, second);
}

FOR_EVERY_SOLVER(MemoryOfAnObject);

}  // namespace
}  // namespace geodesic::harness
