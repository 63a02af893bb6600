// A pool lends solvers to threads, and prepares once for all of them.
#include "python/native/solver_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "solvers/core/registry.h"

namespace geodesic::python {
namespace {

std::atomic<int> preparations = 0;

// Takes long to prepare, and shares its preparation.
class Slow final : public Solver {
 public:
  Slow(const Mesh& mesh, const Description& description) : Solver(mesh, description) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ++preparations;
  }
  std::unique_ptr<Solver> another() const override {
    return std::unique_ptr<Solver>(new Slow(mesh(), description(), 0));
  }

 private:
  Slow(const Mesh& mesh, const Description& description, int) : Solver(mesh, description) {}
  void run(const Start& start, std::span<double> distances) override {
    if (start.query.limit == 0) throw std::runtime_error("no limit, please");
    std::ranges::fill(distances, 1);
  }
};

const RegisterSolver<Slow> registered{{.name = "slow", .family = "test-only", .paper = "none"}};

std::shared_ptr<SolverPool> new_pool() {
  preparations = 0;
  return std::make_shared<SolverPool>(
      std::make_shared<const Mesh>(TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}),
      solver_named("slow"));
}

TEST(SolverPool, prepares_once_for_threads_that_need_a_solver_at_the_same_time) {
  const auto pool = new_pool();
  constexpr std::size_t kThreads = 6;
  std::vector<const PointSolver*> lent(kThreads);
  std::barrier all_have_one(kThreads);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < kThreads; ++i) {
      threads.emplace_back([&, i] {
        const BorrowedSolver solver(pool);
        lent[i] = &*solver;
        all_have_one.arrive_and_wait();
      });
    }
  }
  EXPECT_EQ(preparations, 1);
  EXPECT_EQ(std::set(lent.begin(), lent.end()).size(), kThreads);
}

TEST(SolverPool, prepares_once_on_a_mesh_with_inserted_points) {
  const auto pool = new_pool();
  const SurfacePoint middle = point_in_face(*pool->mesh(), 0, {1, 1, 1});
  EXPECT_EQ(pool_for(pool, {}, {}), pool);
  const auto finer = pool_for(pool, std::span(&middle, 1), {});
  ASSERT_NE(finer, pool);
  std::vector<double> distances(3);
  {
    const BorrowedSolver first(finer), second(finer);
    first->solve({.sources = {{middle}}}, distances, {});
    second->solve({.sources = {{middle}}}, distances, {});
  }
  EXPECT_EQ(preparations, 1);
}

TEST(SolverPool, lends_a_returned_solver_again_but_none_that_threw) {
  const auto pool = new_pool();
  std::vector<double> distances(3);
  const PointSolver* first = nullptr;
  const auto solve = [&](double limit) {
    const BorrowedSolver solver(pool);
    first = &*solver;
    solver->solve({.sources = {{Index{0}}}, .limit = limit}, distances, {});
  };
  solve(2);
  const PointSolver* const before = first;
  solve(2);
  EXPECT_EQ(first, before);
  EXPECT_THROW(solve(0), std::runtime_error);
  solve(2);
  EXPECT_NE(first, before);
  EXPECT_EQ(preparations, 1);
}

TEST(SolverPool, of_a_ready_solver_prepares_nothing) {
  const auto mesh = new_pool()->mesh();
  auto ready = make_solver("slow", *mesh);
  const Solver* const first = ready.get();
  const auto pool = std::make_shared<SolverPool>(mesh, std::move(ready));
  {
    const BorrowedSolver a(pool), b(pool);
    EXPECT_EQ(&a->solver(), first);
    EXPECT_NE(&b->solver(), first);
  }
  EXPECT_EQ(pool->solver().name, "slow");
  EXPECT_EQ(preparations, 1);
}

}  // namespace
}  // namespace geodesic::python
