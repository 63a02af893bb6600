// A solver object owns its state: it can be asked again, and gives the same bits every time.
#include "tests/conformance/solver_test.h"
#include "tests/oracles/random_meshes.h"

namespace geodesic::conformance {
namespace {

class Repetition : public SolverTest {
 protected:
  const Mesh mesh_{oracles::rough_torus(41, 20, 10, 0.3)};
};

TEST_P(Repetition, gives_the_same_bits) {
  const auto solver = prepare(mesh_);
  const auto first = ask(*solver, mesh_, from(0));
  EXPECT_TRUE(identical(ask(*solver, mesh_, from(0)), first));
  EXPECT_TRUE(identical(solve(mesh_, 0), first));
}

TEST_P(Repetition, of_another_source_is_as_if_it_were_the_first) {
  const auto solver = prepare(mesh_);
  ask(*solver, mesh_, from(0));
  EXPECT_TRUE(identical(ask(*solver, mesh_, from(77)), solve(mesh_, 77)));
  EXPECT_TRUE(identical(ask(*solver, mesh_, from(0)), solve(mesh_, 0)));
}

TEST_P(Repetition, after_a_limited_query_is_unlimited_again) {
  NEEDS(abilities().distance_limit);
  const auto solver = prepare(mesh_);
  Query limited = from(0);
  limited.limit = 1.5;
  ask(*solver, mesh_, limited);
  EXPECT_TRUE(identical(ask(*solver, mesh_, from(0)), solve(mesh_, 0)));
}

TEST_P(Repetition, after_a_refused_query_works) {
  const auto solver = prepare(mesh_);
  EXPECT_THROW(ask(*solver, mesh_, Query{}), std::invalid_argument);
  EXPECT_TRUE(identical(ask(*solver, mesh_, from(3)), solve(mesh_, 3)));
}

TEST_P(Repetition, two_objects_on_one_mesh_do_not_disturb_each_other) {
  const auto one = prepare(mesh_), other = prepare(mesh_);
  const auto first = ask(*one, mesh_, from(5));
  ask(*other, mesh_, from(90));
  EXPECT_TRUE(identical(ask(*one, mesh_, from(5)), first));
}

FOR_EVERY_SOLVER(Repetition);

}  // namespace
}  // namespace geodesic::conformance
