#include "solvers/core/prefetch.h"

#include <gtest/gtest.h>

#include <vector>

namespace geodesic {
namespace {

TEST(PrefetchPipeline, is_empty_before_an_item_was_announced) {
  const PrefetchPipeline<3> pipeline;
  for (std::size_t stage = 0; stage < 3; ++stage) EXPECT_EQ(pipeline[stage], kNone);
}

TEST(PrefetchPipeline, takes_every_item_through_every_stage_once) {
  PrefetchPipeline<4> pipeline;
  constexpr Index kItems = 50;
  std::vector<std::size_t> stages_passed(kItems, 0);
  for (Index turn = 0; turn < kItems + 20; ++turn) {
    pipeline.advance(turn < kItems ? turn : kNone);
    for (std::size_t stage = 4; stage-- > 0;) {
      const Index item = pipeline[stage];
      if (item == kNone) continue;
      EXPECT_EQ(stages_passed[item], stage) << "item " << item << " in turn " << turn;
      ++stages_passed[item];
    }
  }
  for (const std::size_t passed : stages_passed) EXPECT_EQ(passed, 4u);
}

TEST(PrefetchPipeline, forgets_everything_when_cleared) {
  PrefetchPipeline<2> pipeline;
  for (Index turn = 0; turn < 5; ++turn) pipeline.advance(turn);
  pipeline.clear();
  for (std::size_t stage = 0; stage < 2; ++stage) EXPECT_EQ(pipeline[stage], kNone);
}

}  // namespace
}  // namespace geodesic
