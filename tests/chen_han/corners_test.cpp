#include "solvers/chen_han/corners.h"

#include <gtest/gtest.h>

namespace geodesic::chen_han {
namespace {

constexpr double kResolution = 1e-6;
constexpr Window kWide{0, 1, 0.5, -1, 0};
constexpr Sides kLeft{true, false}, kRight{false, true}, kBoth{true, true};

TEST(ChenHanCorners, TheFirstWindowAndEveryNearerOneHaveTwoChildren) {
  Corners corners(1);
  EXPECT_EQ(corners.claim(0, kWide, 2.0, 0.5, kResolution), kBoth);
  EXPECT_EQ(corners.claim(0, kWide, 1.5, 0.2, kResolution), kBoth);
}

TEST(ChenHanCorners, AFartherWindowHasTheChildOnItsOwnSide) {
  Corners corners(1);
  corners.claim(0, kWide, 1.0, 0.5, kResolution);
  EXPECT_EQ(corners.claim(0, kWide, 2.0, 0.4, kResolution), kLeft);
  EXPECT_EQ(corners.claim(0, kWide, 2.0, 0.6, kResolution), kRight);
}

TEST(ChenHanCorners, EquallyNearWindowsOnDifferentSidesDoNotDropBoth) {
  Corners corners(1);
  EXPECT_EQ(corners.claim(0, kWide, 1.0, 0.5, kResolution), kBoth);
  EXPECT_EQ(corners.claim(0, kWide, 1.0, 0.6, kResolution), kRight);
}

TEST(ChenHanCorners, WindowsAlongTheOwnersLineKeepBothChildren) {
  Corners corners(1);
  corners.claim(0, kWide, 1.0, 0.5, kResolution);
  EXPECT_EQ(corners.claim(0, kWide, 1.0, 0.5 - 1e-16, kResolution), kBoth);
  EXPECT_EQ(corners.claim(0, kWide, 1.0, 0.5 + 1e-16, kResolution), kBoth);
}

TEST(ChenHanCorners, FartherWindowsAlongTheOwnersLineKeepOnlyWhatTheOwnersPathDoesNotBeat) {
  Corners corners(1);
  corners.claim(0, kWide, 1.0, 0.5, kResolution);
  const auto claim = [&](double begin, double end) {
    return corners.claim(0, {begin, end, 0.5, -1, 0}, 1.2, 0.5, kResolution);
  };
  EXPECT_EQ(claim(0.41, 0.59), (Sides{false, false}));
  EXPECT_EQ(claim(0.39, 0.59), kLeft);
  EXPECT_EQ(claim(0.41, 0.61), kRight);
  EXPECT_EQ(claim(0.39, 0.61), kBoth);
}

TEST(ChenHanCorners, ClearForgetsTheOwners) {
  Corners corners(2);
  corners.claim(1, kWide, 1.0, 0.5, kResolution);
  corners.clear();
  EXPECT_EQ(corners.claim(1, kWide, 9.0, 0.1, kResolution), kBoth);
}

}  // namespace
}  // namespace geodesic::chen_han
