#include "harness/verify/verify.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geodesic::harness {
namespace {

// Four by four vertices of a flat square: the exact distances are those of the plane.
class Verify : public ::testing::Test {
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

  Verify() {
    for (Index v = 0; v < kSide * kSide; ++v) {
      const double x = v % kSide, y = v / kSide;
      exact_.push_back(std::hypot(x, y));
      // Edges lie along the axes and the rising diagonal.
      along_edges_.push_back(std::max(x, y) - std::min(x, y) + std::sqrt(2) * std::min(x, y));
    }
    exact_.push_back(kInfinity);
    along_edges_.push_back(kInfinity);
  }

  // The verdict on `distances`, with right ones to compare with unless others are given.
  Verdict verdict(const std::vector<double>& distances,
                  Exactness exactness = Exactness::exact) const {
    return verdict(distances, exact_, exactness);
  }
  Verdict verdict(const std::vector<double>& distances, const std::vector<double>& reference,
                  Exactness exactness = Exactness::exact) const {
    return verify(mesh_, std::vector<Index>{0}, exactness, distances, {"oracle", reference},
                  Distances{"edges", along_edges_});
  }

  std::vector<double> off_by(Index v, double factor) const {
    std::vector<double> distances = exact_;
    distances[v] *= factor;
    return distances;
  }

  void expect_error(const Verdict& verdict, const std::vector<std::string>& words) const {
    for (const std::string& word : words) {
      EXPECT_NE(verdict.error.find(word), std::string::npos)
          << "'" << word << "' is missing in: '" << verdict.error << "'";
    }
  }

  const Mesh mesh_{square()};
  std::vector<double> exact_;
  std::vector<double> along_edges_;
};

TEST_F(Verify, AcceptsExactDistances) {
  const Verdict right = verdict(exact_);
  EXPECT_EQ(right.error, "");
  EXPECT_EQ(right.max_relative_error, 0);
}

TEST_F(Verify, AcceptsRounding) {
  const Verdict right = verdict(off_by(9, 1 + 1e-13));
  EXPECT_EQ(right.error, "");
  EXPECT_NEAR(right.max_relative_error, 1e-13, 1e-15);
}

TEST_F(Verify, NamesTheWorstVertexBothDistancesAndTheError) {
  std::vector<double> distances = off_by(9, 1 + 1e-9);
  distances[7] *= 1 + 1e-10;
  const Verdict wrong = verdict(distances);
  expect_error(wrong, {"vertex 9 has distance 2.2360679797", "oracle has 2.2360679774",
                       "relative error 1e-09"});
  EXPECT_NEAR(wrong.max_relative_error, 1e-9, 1e-12);
}

TEST_F(Verify, CatchesTooShortAsWellAsTooLong) {
  expect_error(verdict(off_by(9, 1 - 1e-9)), {"vertex 9", "relative error 1e-09"});
}

TEST_F(Verify, CatchesAnotherUnreachableSet) {
  std::vector<double> distances = exact_;
  distances[5] = kInfinity;
  expect_error(verdict(distances), {"vertex 5 has distance inf"});
  distances = exact_;
  distances.back() = 1;
  expect_error(verdict(distances), {"vertex 16 has distance 1, oracle has inf"});
}

TEST_F(Verify, CatchesWhatIsNoDistance) {
  std::vector<double> distances = exact_;
  distances[3] = std::nan("");
  expect_error(verdict(distances), {"vertex 3 has distance nan"});
  distances[3] = -1;
  expect_error(verdict(distances), {"vertex 3 has distance -1"});
}

TEST_F(Verify, CatchesADistanceAtTheSource) {
  std::vector<double> distances = exact_;
  distances[0] = 1e-300;
  expect_error(verdict(distances), {"vertex 0 has distance"});
}

TEST_F(Verify, UpperBoundsMayBeLongerButNotShorter) {
  const Verdict longer = verdict(along_edges_, Exactness::upper_bound);
  EXPECT_EQ(longer.error, "");
  EXPECT_GT(longer.max_relative_error, 0.05);
  std::vector<double> shorter = along_edges_;
  shorter[9] = exact_[9] * (1 - 1e-9);
  expect_error(verdict(shorter, Exactness::upper_bound), {"vertex 9", "below the exact one"});
}

// With a reference that makes the same mistake, the bounds must catch it.
TEST_F(Verify, CatchesLessThanTheStraightLine) {
  const std::vector<double> wrong = off_by(9, 1 - 1e-9);
  expect_error(verdict(wrong, wrong), {"vertex 9", "less than the straight line 2.2360679"});
}

TEST_F(Verify, CatchesMoreThanAlongEdges) {
  const std::vector<double> wrong = off_by(3, 1 + 1e-9);
  expect_error(verdict(wrong, wrong), {"vertex 3", "more than along edges (edges) 3"});
}

TEST_F(Verify, CatchesABrokenTriangleInequality) {
  along_edges_[15] = 100;  // or that bound would catch it first
  std::vector<double> wrong = exact_;
  wrong[15] = 9;
  expect_error(verdict(wrong, wrong), {"vertex 15 has distance 9", "than their edge is long"});
}

TEST_F(Verify, CatchesAnUnreachableNeighbour) {
  std::vector<double> wrong = exact_;
  wrong[15] = kInfinity;
  expect_error(verdict(wrong, wrong), {"vertex 15 has distance inf"});
}

}  // namespace
}  // namespace geodesic::harness
