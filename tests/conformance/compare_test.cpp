#include "harness/verify/compare.h"

#include <cmath>

#include "tests/conformance/solver_test.h"

namespace geodesic::conformance {
namespace {

using Values = std::vector<double>;

const Query kFromZero = from(0);

TEST(Compare, exact_distances_may_differ_by_rounding_only) {
  EXPECT_TRUE(nothing(agree(kFromZero, Values{0, 1 + 1e-13, kInfinity}, Values{0, 1, kInfinity})));
  EXPECT_FALSE(nothing(agree(kFromZero, Values{0, 1 + 1e-11}, Values{0, 1})));
  EXPECT_FALSE(nothing(agree(kFromZero, Values{0, 1 - 1e-11}, Values{0, 1})));
}

TEST(Compare, bounds_may_be_farther_and_not_nearer) {
  EXPECT_TRUE(
      nothing(bound_from_above(kFromZero, Values{0, 2, kInfinity}, Values{0, 1, kInfinity})));
  EXPECT_FALSE(nothing(bound_from_above(kFromZero, Values{0, 1 - 1e-11}, Values{0, 1})));
}

TEST(Compare, infinities_belong_in_the_same_places_and_everything_is_a_number) {
  using Compare = Finding(const Query&, std::span<const double>, std::span<const double>);
  Compare* const agreeing = [](auto& query, auto got, auto want) {
    return agree(query, got, want);
  };
  Compare* const above = [](auto& query, auto got, auto want) {
    return bound_from_above(query, got, want);
  };
  for (Compare* const compare : {agreeing, above, &identical}) {
    for (const double got : {kInfinity, std::nan("")}) {
      EXPECT_FALSE(nothing(compare(kFromZero, Values{0, got}, Values{0, 1}))) << got;
    }
    EXPECT_FALSE(nothing(compare(kFromZero, Values{0, 1}, Values{0, kInfinity})));
    EXPECT_FALSE(nothing(compare(kFromZero, Values{1e-300}, Values{0})));
    EXPECT_FALSE(nothing(compare(kFromZero, Values{0}, Values{0, 1})));
  }
}

TEST(Compare, short_distances_may_be_off_as_much_as_the_least) {
  const Tolerance tolerance{.relative = 1e-3, .least = 10};
  EXPECT_TRUE(nothing(agree(kFromZero, Values{0, 1.009}, Values{0, 1}, tolerance)));
  EXPECT_FALSE(nothing(agree(kFromZero, Values{0, 1.011}, Values{0, 1}, tolerance)));
  EXPECT_TRUE(nothing(bound_from_above(kFromZero, Values{0, 0.991}, Values{0, 1}, tolerance)));
  EXPECT_FALSE(nothing(bound_from_above(kFromZero, Values{0, 0.989}, Values{0, 1}, tolerance)));
}

TEST(Compare, identical_means_to_the_last_bit) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(nothing(identical(kFromZero, Values{0, 1}, Values{0, 1})));
  EXPECT_FALSE(nothing(identical(kFromZero, Values{0, next}, Values{0, 1})));
  EXPECT_FALSE(nothing(identical(kFromZero, Values{-0.0}, Values{0})));
}

TEST(Compare, failures_name_where_it_went_wrong_first_and_the_largest_error) {
  const Values want{3, 1, 2, 0}, got{3.5, 1, 2.5, 0};
  const Finding finding = agree(from(3), got, want);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->what,
            "2 of 4 distances are wrong from vertex 3, first at vertex 2: 2.5 instead of 2 "
            "(relative error 0.25, largest 0.25)");
  EXPECT_EQ(finding->got, got);
  EXPECT_EQ(finding->query.sources.front().vertex, 3u);
}

TEST(Compare, no_edge_joins_distances_that_differ_by_more_than_it_is_long) {
  const Mesh mesh(TriangleSoup{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}});
  EXPECT_TRUE(nothing(satisfies_edges(mesh, kFromZero, Values{0, 3, 4})));
  EXPECT_FALSE(nothing(satisfies_edges(mesh, kFromZero, Values{0, 3.1, 4})));
  EXPECT_FALSE(nothing(satisfies_edges(mesh, kFromZero, Values{0, 3, std::nan("")})));
}

}  // namespace
}  // namespace geodesic::conformance
