#include "solvers/core/upcoming.h"

#include <gtest/gtest.h>

#include <vector>

namespace geodesic {
namespace {

TEST(Upcoming, tells_nothing_before_an_item_was_told) {
  const Upcoming<3> upcoming;
  for (std::size_t stage = 0; stage < 3; ++stage) EXPECT_EQ(upcoming[stage], kNone);
}

TEST(Upcoming, takes_every_item_through_every_stage_once) {
  Upcoming<4> upcoming;
  constexpr Index kItems = 50;
  std::vector<std::size_t> stages_passed(kItems, 0);
  for (Index turn = 0; turn < kItems + 20; ++turn) {
    upcoming.advance(turn < kItems ? turn : kNone);
    for (std::size_t stage = 4; stage-- > 0;) {
      const Index item = upcoming[stage];
      if (item == kNone) continue;
      EXPECT_EQ(stages_passed[item], stage) << "item " << item << " in turn " << turn;
      ++stages_passed[item];
    }
  }
  for (const std::size_t passed : stages_passed) EXPECT_EQ(passed, 4u);
}

TEST(Upcoming, forgets_everything_when_cleared) {
  Upcoming<2> upcoming;
  for (Index turn = 0; turn < 5; ++turn) upcoming.advance(turn);
  upcoming.clear();
  for (std::size_t stage = 0; stage < 2; ++stage) EXPECT_EQ(upcoming[stage], kNone);
}

}  // namespace
}  // namespace geodesic
