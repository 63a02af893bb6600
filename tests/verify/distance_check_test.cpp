#include "harness/verify/distance_check.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "tests/harness/expect_words.h"
#include "tests/verify/solver_test.h"

namespace geodesic::harness {
namespace {

using Values = std::vector<double>;

const Query kFromZero = from(0);

TEST(DistanceCheck, exact_distances_may_differ_by_rounding_only) {
  EXPECT_TRUE(nothing(
      check_distances(kFromZero, Values{0, 1 + 1e-13, kInfinity}, Values{0, 1, kInfinity})));
  EXPECT_FALSE(nothing(check_distances(kFromZero, Values{0, 1 + 1e-11}, Values{0, 1})));
  EXPECT_FALSE(nothing(check_distances(kFromZero, Values{0, 1 - 1e-11}, Values{0, 1})));
}

TEST(DistanceCheck, upper_bounds_may_be_farther_and_not_nearer) {
  const auto check = [](const Values& got, const Values& expected) {
    return check_distances(kFromZero, got, expected, Relation::upper_bound);
  };
  EXPECT_TRUE(nothing(check({0, 2, kInfinity}, {0, 1, kInfinity})));
  EXPECT_FALSE(nothing(check({0, 1 - 1e-11}, {0, 1})));
}

TEST(DistanceCheck, infinities_belong_in_the_same_places_and_everything_is_a_number) {
  for (const Relation relation : {Relation::equal, Relation::upper_bound, Relation::same_bits}) {
    const auto check = [&](const Values& got, const Values& expected) {
      return check_distances(kFromZero, got, expected, relation);
    };
    for (const double got : {kInfinity, std::nan("")}) {
      EXPECT_FALSE(nothing(check({0, got}, {0, 1}))) << got;
    }
    EXPECT_FALSE(nothing(check({0, 1}, {0, kInfinity})));
    EXPECT_FALSE(nothing(check({1e-300}, {0})));
    EXPECT_FALSE(nothing(check({0}, {0, 1})));
  }
}

TEST(DistanceCheck, bounds_hold_on_one_side_and_for_numbers_only) {
  const auto check = [](double got, double expected, Relation relation) {
    return check_distances(kFromZero, Values{got}, Values{expected}, relation);
  };
  for (const double far : {2.0, kInfinity}) {
    EXPECT_TRUE(nothing(check(far, 1, Relation::at_least))) << far;
    EXPECT_FALSE(nothing(check(1, far, Relation::at_least))) << far;
    EXPECT_TRUE(nothing(check(1, far, Relation::at_most))) << far;
    EXPECT_FALSE(nothing(check(far, 1, Relation::at_most))) << far;
  }
  for (const Relation relation : {Relation::at_least, Relation::at_most}) {
    EXPECT_FALSE(nothing(check(std::nan(""), 1, relation)));
    EXPECT_TRUE(nothing(check(1 + 1e-13, 1, relation)));
    EXPECT_TRUE(nothing(check(1 - 1e-13, 1, relation)));
  }
}

TEST(DistanceCheck, short_distances_may_be_off_as_much_as_the_least) {
  const auto check = [](double got, Relation relation) {
    return check_distances(kFromZero, Values{0, got}, Values{0, 1}, relation,
                           {.relative = 1e-3, .least = 10});
  };
  EXPECT_TRUE(nothing(check(1.009, Relation::equal)));
  EXPECT_FALSE(nothing(check(1.011, Relation::equal)));
  EXPECT_TRUE(nothing(check(0.991, Relation::upper_bound)));
  EXPECT_FALSE(nothing(check(0.989, Relation::upper_bound)));
}

TEST(DistanceCheck, a_limit_may_cut_off_inexact_distances_on_the_side_that_their_promise_leaves) {
  const Query query{.sources = {{0}}, .limit = 10};
  const auto holds = [&](Exactness exactness, const Values& got, const Values& expected) {
    const double bound = exactness == Exactness::bounded ? 0.1 : 0;
    return nothing(check_promise({exactness, bound}, query, got, expected));
  };
  const Values near_limit{0, 9.5}, far_below{0, 5}, cut_off{0, kInfinity};
  EXPECT_FALSE(holds(Exactness::exact, cut_off, near_limit));
  EXPECT_TRUE(holds(Exactness::bounded, cut_off, near_limit));
  EXPECT_TRUE(holds(Exactness::bounded, near_limit, cut_off));
  EXPECT_FALSE(holds(Exactness::bounded, cut_off, far_below));
  EXPECT_FALSE(holds(Exactness::bounded, far_below, cut_off));
  EXPECT_TRUE(holds(Exactness::upper_bound, cut_off, far_below));
  EXPECT_FALSE(holds(Exactness::upper_bound, near_limit, cut_off));
  EXPECT_TRUE(holds(Exactness::unbounded, cut_off, far_below));
  EXPECT_TRUE(holds(Exactness::unbounded, far_below, cut_off));
  for (const Exactness each : {Exactness::bounded, Exactness::upper_bound, Exactness::unbounded}) {
    EXPECT_FALSE(holds(each, {kInfinity, 5}, far_below));
  }
}

TEST(DistanceCheck, an_unbounded_solver_may_give_one_of_several_sources_another_distance_than_0) {
  const auto holds = [&](Exactness exactness, const Query& query, const Values& got) {
    return nothing(check_promise({exactness, 0}, query, got, Values{0, 0, 1}));
  };
  const Query one{.sources = {{0}}}, two{.sources = {{0}, {1}}};
  const Values shifted{0, -0.5, 1}, unreached{0, kInfinity, 1};
  EXPECT_TRUE(holds(Exactness::unbounded, two, shifted));
  EXPECT_FALSE(holds(Exactness::unbounded, one, shifted));
  EXPECT_FALSE(holds(Exactness::unbounded, two, unreached));
  EXPECT_FALSE(holds(Exactness::upper_bound, two, shifted));
}

TEST(DistanceCheck, same_bits_means_to_the_last_bit) {
  const auto check = [](double got, double expected) {
    return check_distances(kFromZero, Values{0, got}, Values{0, expected}, Relation::same_bits);
  };
  EXPECT_TRUE(nothing(check(1, 1)));
  EXPECT_FALSE(nothing(check(std::nextafter(1.0, 2.0), 1)));
  EXPECT_FALSE(nothing(check(-0.0, 0)));
}

TEST(DistanceCheck, failures_name_where_it_went_wrong_first_and_the_largest_error) {
  const Values want{3, 1, 2, 0}, got{3.5, 1, 2.5, 0};
  const Finding finding = check_distances(from(3), got, want);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->what,
            "2 of 4 distances are wrong from vertex 3, first at vertex 2: 2.5 instead of 2 "
            "(relative error 0.25, largest 0.25)");
  EXPECT_EQ(finding->got, got);
  EXPECT_EQ(finding->query.sources.front().at.vertex, 3u);
}

TEST(DistanceCheck, failures_count_distances_that_are_infinite_on_one_side_apart) {
  const auto what = [](const Values& got, const Values& want) {
    return check_distances(kFromZero, got, want).value().what.substr(std::strlen("2 of 3 dist"));
  };
  const std::string where = "ances are wrong from vertex 0, first at vertex 1: ";
  EXPECT_EQ(what({0, kInfinity, kInfinity}, {0, 1, 2}),
            where + "inf instead of 1 (infinite or undefined: 2)");
  EXPECT_EQ(what({0, 1.5, kInfinity}, {0, 1, 2}),
            where + "1.5 instead of 1 (relative error 0.5, largest 0.5, infinite or undefined: 1)");
}

TEST(DistanceCheck, no_edge_joins_distances_that_differ_by_more_than_it_is_long) {
  const Mesh mesh(TriangleSoup{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}});
  EXPECT_TRUE(nothing(check_edges(mesh, kFromZero, Values{0, 3, 4})));
  EXPECT_FALSE(nothing(check_edges(mesh, kFromZero, Values{0, 3.1, 4})));
  EXPECT_FALSE(nothing(check_edges(mesh, kFromZero, Values{0, 3, std::nan("")})));
}

// A flat square of 4 x 4 vertices: the exact distances are those in the plane.
class VerifyDistances : public ::testing::Test {
 protected:
  static constexpr Index kSide = 4;

  static TriangleSoup square() {
    TriangleSoup soup;
    for (Index y = 0; y < kSide; ++y) {
      for (Index x = 0; x < kSide; ++x) soup.positions.push_back({double(x), double(y), 0});
    }
    for (Index v = 0; v + kSide + 1 < kSide * kSide; ++v) {
      if (v % kSide + 1 == kSide) continue;
      soup.triangles.push_back({v, v + 1, v + kSide + 1});
      soup.triangles.push_back({v, v + kSide + 1, v + kSide});
    }
    soup.positions.push_back({9, 9, 9});  // isolated
    return soup;
  }

  VerifyDistances() {
    for (Index v = 0; v < kSide * kSide; ++v) {
      const Index column = v % kSide, row = v / kSide;
      const double x = column, y = row;
      exact_.push_back(std::hypot(x, y));
      // Edges lie along the axes and the rising diagonal.
      along_edges_.push_back(std::max(x, y) - std::min(x, y) + std::sqrt(2) * std::min(x, y));
    }
    exact_.push_back(kInfinity);
    along_edges_.push_back(kInfinity);
  }

  // The verdict on `distances`; the default reference is exact.
  Verdict verdict(const std::vector<double>& distances,
                  Exactness exactness = Exactness::exact) const {
    return verdict(distances, exact_, exactness);
  }
  Verdict verdict(const std::vector<double>& distances, const std::vector<double>& reference,
                  Exactness exactness = Exactness::exact) const {
    return verify_distances(mesh_, from(0), {exactness}, distances, {"oracle", reference},
                            NamedDistances{"edges", along_edges_});
  }

  std::vector<double> off_by(Index v, double factor) const {
    std::vector<double> distances = exact_;
    distances[v] *= factor;
    return distances;
  }

  const Mesh mesh_{square()};
  std::vector<double> exact_;
  std::vector<double> along_edges_;
};

TEST_F(VerifyDistances, AcceptsExactDistances) {
  const Verdict right = verdict(exact_);
  EXPECT_EQ(right.error, "");
  EXPECT_EQ(right.errors.max, 0);
}

TEST_F(VerifyDistances, NamesTheNearestWrongVertexBothDistancesAndTheError) {
  std::vector<double> distances = off_by(9, 1 + 1e-9);
  distances[7] *= 1 + 1e-10;
  const Verdict wrong = verdict(distances);
  expect_words(wrong.error,
               {"compared with oracle: 2 of 17 distances are wrong", "vertex 9: 2.2360679797",
                " instead of 2.2360679774", "relative error 1e-09"});
  EXPECT_NEAR(wrong.errors.max, 1e-9, 1e-12);
}

TEST_F(VerifyDistances, UpperBoundsMayBeLongerButNotShorter) {
  const Verdict longer = verdict(along_edges_, Exactness::upper_bound);
  EXPECT_EQ(longer.error, "");
  EXPECT_GT(longer.errors.max, 0.05);
  std::vector<double> shorter = along_edges_;
  shorter[9] = exact_[9] * (1 - 1e-9);
  expect_words(verdict(shorter, Exactness::upper_bound).error,
               {"vertex 9", "compared with oracle"});
}

// The reference has the same error, so that only the bounds can detect it.
TEST_F(VerifyDistances, CatchesLessThanTheStraightLine) {
  const std::vector<double> wrong = off_by(9, 1 - 1e-9);
  expect_words(verdict(wrong, wrong).error,
               {"less than the straight line", "vertex 9", "instead of 2.2360679"});
}

TEST_F(VerifyDistances, CatchesMoreThanAlongEdges) {
  const std::vector<double> wrong = off_by(3, 1 + 1e-9);
  expect_words(verdict(wrong, wrong).error,
               {"more than along edges (edges)", "vertex 3", "instead of 3"});
}

TEST_F(VerifyDistances, CatchesABrokenTriangleInequality) {
  along_edges_[15] = 100;  // otherwise this bound would detect the error first
  std::vector<double> wrong = exact_;
  wrong[15] = 9;
  expect_words(verdict(wrong, wrong).error,
               {"vertex 15 has distance 9", "their edge has length 1"});
}

TEST(RelativeErrors, AreFiniteWhereACodeWritesTheLargestNumber) {
  const double largest = std::numeric_limits<double>::max();
  const std::vector<double> got{0, largest, largest, 3}, expected{0, 2, 2, 2};
  const RelativeErrors errors = relative_errors(got, expected);
  EXPECT_TRUE(std::isfinite(errors.mean) && std::isfinite(errors.rms));
  EXPECT_DOUBLE_EQ(errors.max, largest / 2);
  EXPECT_DOUBLE_EQ(errors.mean, largest / 4);
  EXPECT_DOUBLE_EQ(relative_errors(std::vector{0.0, 3.0}, std::vector{0.0, 2.0}).rms,
                   std::sqrt(0.125));
}

}  // namespace
}  // namespace geodesic::harness
