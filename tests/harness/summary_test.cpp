#include "harness/run/summary.h"

#include <gtest/gtest.h>

namespace geodesic::harness {
namespace {

std::string line_of(double ms) {
  Row row;
  row.cpu_time = ms;
  return one_line({row});
}

TEST(OneLine, GivesFourDigitsOfATimeAlsoWhereRoundingAddsOneBeforeThePoint) {
  EXPECT_EQ(line_of(2.5), "ok  2.500 ms");
  EXPECT_EQ(line_of(9.9994), "ok  9.999 ms");
  EXPECT_EQ(line_of(9.99996), "ok  10.00 ms");
  EXPECT_EQ(line_of(99.9996), "ok  100.0 ms");
  EXPECT_EQ(line_of(0.0999996), "ok  100.0 us");
  EXPECT_EQ(line_of(99999.6), "ok  100.0 s");
  EXPECT_EQ(line_of(0), "ok  0.000 us");
}

}  // namespace
}  // namespace geodesic::harness
