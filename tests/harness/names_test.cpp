#include <gtest/gtest.h>

#include "harness/error.h"

namespace geodesic::harness {
namespace {

TEST(UnknownName, ListsWhatExistsAndGuessesWhatWasMeant) {
  EXPECT_EQ(unknown_name("solver", "mpm", {"ch", "ich", "mmp"}),
            "no solver named 'mpm'; there are: ch, ich, mmp");
  EXPECT_EQ(unknown_name("solver", "edge-base", {"ch", "edge-based"}),
            "no solver named 'edge-base' (did you mean 'edge-based'?); there are: ch, edge-based");
}

TEST(UnknownName, SaysWhenThereIsNothing) {
  EXPECT_EQ(unknown_name("mesh", "horse", {}), "no mesh named 'horse'; there are: none");
}

}  // namespace
}  // namespace geodesic::harness
