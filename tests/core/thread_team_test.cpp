#include "solvers/core/thread_team.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "tests/delayed_pieces.h"

namespace geodesic {
namespace {

TEST(ThreadTeam, does_every_piece_once_and_then_what_follows) {
  constexpr std::size_t kPieces = 100;
  const DelayedPieces delayed;
  for (const unsigned threads : {1u, 2u, 5u}) {
    std::vector<int> done(kPieces, 0);
    int lists = 0;
    ThreadTeam::run(threads, kPieces, [&](ThreadTeam& team, unsigned thread) {
      for (int list = 1; list <= 8; ++list) {
        team.share(
            thread, kPieces, team.in_equal_parts(kPieces), [&](std::size_t i) { ++done[i]; },
            [&] { lists += std::ranges::count(done, list) == kPieces ? 1 : 0; });
      }
    });
    EXPECT_EQ(lists, 8) << threads << " threads";
  }
}

TEST(ThreadTeam, throws_what_a_piece_threw_when_all_threads_have_ended) {
  for (const unsigned threads : {1u, 4u}) {
    int after = 0;
    const auto solve = [&] {
      ThreadTeam::run(threads, 10, [&](ThreadTeam& team, unsigned thread) {
        while (!team.has_stopped()) {
          team.share(
              thread, 10, team.in_equal_parts(10),
              [&](std::size_t i) {
                if (i == 7) throw std::runtime_error("piece 7");
              },
              [&] { ++after; });
        }
      });
    };
    EXPECT_THROW(solve(), std::runtime_error) << threads << " threads";
    EXPECT_EQ(after, 0) << threads << " threads";
  }
}

TEST(ThreadTeam, throws_what_the_step_between_lists_threw) {
  const auto solve = [] {
    ThreadTeam::run(3, 1, [](ThreadTeam& team, unsigned thread) {
      while (!team.has_stopped()) {
        team.share(
            thread, 1, team.in_equal_parts(1), [](std::size_t) {},
            [] { throw std::runtime_error("between"); });
      }
    });
  };
  EXPECT_THROW(solve(), std::runtime_error);
}

}  // namespace
}  // namespace geodesic
