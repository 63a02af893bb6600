// Terrain from a grid of heights: the spline, the reader of .npy files, and the north direction.
#include <gtest/gtest.h>

#include <cmath>

#include "meshes/formats/npy.h"
#include "meshes/generators/families.h"
#include "tests/generators/generator_test.h"
#include "tests/harness/expect_error.h"

namespace geodesic {
namespace {

using harness::expect_error;

TEST(NaturalSpline, PassesThroughItsSamplesExactly) {
  const std::vector<double> samples = {3, -1, 4, 1, -5, 9, 2.25};
  const NaturalSpline spline(samples);
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    EXPECT_EQ(spline.at(i, 0), samples[i]);
    EXPECT_EQ(spline.at(i, 1), samples[i + 1]);
  }
  const std::vector<double> fine = spline.resampled(24);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(fine[4 * i], samples[i]);
}

TEST(NaturalSpline, ReproducesStraightLines) {
  std::vector<double> samples;
  for (int i = 0; i < 9; ++i) samples.push_back(2.5 * i - 7);
  for (const std::size_t count : {1u, 5u, 100u}) {
    const std::vector<double> values = NaturalSpline(samples).resampled(count);
    ASSERT_EQ(values.size(), count + 1);
    for (std::size_t k = 0; k <= count; ++k) {
      EXPECT_NEAR(values[k], 20.0 * static_cast<double>(k) / static_cast<double>(count) - 7, 1e-13);
    }
  }
  EXPECT_EQ(NaturalSpline({1, 3}).at(0, 0.25), 1.5) << "two samples: a line";
}

TEST(NaturalSpline, HasContinuousSlopeAndCurvatureAndNoneAtItsEnds) {
  const NaturalSpline spline({3, -1, 4, 1, -5, 9, 2});
  constexpr double kStep = 1e-4;
  const auto slope = [&](std::size_t i, double t) {
    return (spline.at(i, t + kStep) - spline.at(i, t - kStep)) / (2 * kStep);
  };
  const auto curvature = [&](std::size_t i, double t) {
    return (spline.at(i, t + kStep) - 2 * spline.at(i, t) + spline.at(i, t - kStep)) /
           (kStep * kStep);
  };
  for (std::size_t i = 0; i + 2 < 7; ++i) {
    EXPECT_NEAR(slope(i, 1), slope(i + 1, 0), 1e-5) << i;
    EXPECT_NEAR(curvature(i, 1), curvature(i + 1, 0), 1e-3) << i;
  }
  EXPECT_NEAR(curvature(0, 0), 0, 1e-3);
  EXPECT_NEAR(curvature(5, 1), 0, 1e-3);
}

template <class T>
std::string npy(const std::string& type, const std::string& shape, const std::vector<T>& numbers) {
  std::string bytes = npy_header("'" + type + "'", shape);
  for (const T number : numbers) append_little_endian(bytes, number);
  return bytes;
}

TEST(Npy, ReadsEveryNumberType) {
  const std::vector<double> expected = {1, -2, 3, 400, 5, -600};
  const auto expect_read = [&](const std::string& bytes) {
    const Array array = parse_npy(bytes, "heights.npy");
    EXPECT_EQ(array.rows, 2u);
    EXPECT_EQ(array.columns, 3u);
    EXPECT_EQ(array.values, expected);
    EXPECT_EQ(array.at(1, 0), 400);
  };
  expect_read(npy<std::int16_t>("<i2", "(2, 3)", {1, -2, 3, 400, 5, -600}));
  expect_read(npy<std::int32_t>("<i4", "(2, 3)", {1, -2, 3, 400, 5, -600}));
  expect_read(npy<float>("<f4", "(2, 3)", {1, -2, 3, 400, 5, -600}));
  expect_read(npy<double>("<f8", "(2, 3)", {1, -2, 3, 400, 5, -600}));
}

TEST(Npy, RefusesWhatItCannotReadInOneClearLine) {
  const std::vector<double> six(6, 1.0);
  const auto refused = [&](const std::string& bytes, const std::string& why) {
    expect_error([&] { parse_npy(bytes, "heights.npy"); }, {"heights.npy: ", why});
  };
  refused("", "not a .npy file");
  refused("PK\3\4 an archive", "not a .npy file");
  refused("\x93NUMPY\1", "truncated");
  const std::string good = npy("<f8", "(2, 3)", six);
  refused(good.substr(0, 30), "truncated within its header");
  refused(good.substr(0, good.size() - 1), "47 bytes of numbers, but 2 x 3 numbers of 8 bytes");
  refused(good + '\0', "49 bytes of numbers");
  std::string version_2 = good;
  version_2[6] = 2;
  refused(version_2, "version other than 1.0");
  for (const char* const type : {">i2", ">f8", "<i8", "|u1", "<c16", "|O", "<f88", ""}) {
    refused(npy(type, "(2, 3)", six), "numbers of type '" + std::string(type) + "'");
  }
  const auto with = [&](const std::string& part, const std::string& other) {
    return std::string(good).replace(good.find(part), part.size(), other);
  };
  refused(with("'<f8'", "[<f8]"), "numbers of type");
  refused(with("False", "True "), "not in C order");
  refused(with("'descr'", "'dtype'"), "no 'descr'");
  refused(with("'shape'", "'shade'"), "no 'shape'");
  for (const char* const shape : {"()", "(6,)", "(1, 2, 3)", "(2, -3)", "(2.0, 3)", "6", "(",
                                  "(2, ", "(2, 3", "(99999999999999999999999, 2)"}) {
    refused(npy("<f8", shape, six), "not an array of two dimensions");
  }
  refused(npy("<f8", "(1, 6)", six), "takes 2 x 2");
  refused(npy("<f8", "(6, 0)", six), "takes 2 x 2");
  refused(npy("<f8", "(4, 2)", std::vector<double>(9, 1.0)), "72 bytes of numbers");
  // Both products are 48 bytes modulo 2^64.
  refused(npy("<f8", "(2305843009213693954, 3)", six), "are announced");
  refused(npy("<f8", "(6, 2305843009213693953)", six), "are announced");
}

TEST(Npy, RefusesHeightsThatAreNotFiniteWithTheirPlace) {
  for (const double bad : {std::nan(""), kInfinity, -kInfinity}) {
    const std::string bytes = npy<double>("<f8", "(2, 3)", {1, 2, 3, 4, bad, 6});
    expect_error([&] { parse_npy(bytes, "heights.npy"); },
                 {"the number in row 1, column 1 (counted from 0) is not finite"});
  }
}

class Elevation : public InputFiles {
 protected:
  TriangleSoup terrain(const std::string& bytes, GeneratorParameters parameters) {
    parameters.insert_or_assign("input", write("heights.npy", bytes).string());
    return generate("elevation", parameters);
  }

  static Vec3 vertex(const TriangleSoup& soup, Index columns, Index i, Index j) {
    return soup.positions[j * (columns + 1) + i];
  }
};

TEST_F(Elevation, LiesLikeAMap) {
  // North-west 1, north-east 3, south-west 4, south-east 6.
  const std::string bytes = npy<std::int16_t>("<i2", "(2, 3)", {1, 2, 3, 4, 5, 6});
  const TriangleSoup soup =
      terrain(bytes, {{"columns", 2}, {"rows", 1}, {"spacing-x", 10}, {"spacing-y", 100}});
  EXPECT_EQ(vertex(soup, 2, 0, 0), (Vec3{0, 0, 4}));
  EXPECT_EQ(vertex(soup, 2, 2, 0), (Vec3{20, 0, 6}));
  EXPECT_EQ(vertex(soup, 2, 0, 1), (Vec3{0, 100, 1}));
  EXPECT_EQ(vertex(soup, 2, 2, 1), (Vec3{20, 100, 3}));
  for (const auto& [a, b, c] : soup.triangles) {
    const Vec3 &p = soup.positions[a], &q = soup.positions[b], &r = soup.positions[c];
    EXPECT_GT((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]), 0)
        << "clockwise from above";
  }
}

TEST_F(Elevation, SpansTheSameRectangleAtAnyResolution) {
  const std::string bytes = npy<float>("<f4", "(3, 5)", std::vector<float>(15, 7));
  for (const Index columns : {1u, 3u, 4u, 50u}) {
    const TriangleSoup soup =
        terrain(bytes, {{"columns", columns}, {"rows", 5}, {"spacing-x", 2}, {"spacing-y", 3}});
    EXPECT_EQ(soup.positions.size(), (columns + 1) * 6u);
    EXPECT_EQ(soup.triangles.size(), columns * 10u);
    EXPECT_NEAR(soup.positions.back()[0], 8, 1e-14);
    EXPECT_NEAR(soup.positions.back()[1], 6, 1e-14);
    for (const Vec3& position : soup.positions) EXPECT_NEAR(position[2], 7, 1e-14);
  }
}

TEST_F(Elevation, InterpolatesTheSamplesAndReproducesBilinearHeights) {
  std::vector<double> rough, bilinear;
  for (int row = 0; row < 7; ++row) {
    for (int column = 0; column < 9; ++column) {
      rough.push_back((row * 31 + column * 17) % 13);
      bilinear.push_back(2 + 3.0 * row - 0.5 * column + 0.25 * row * column);
    }
  }
  const GeneratorParameters finer = {{"columns", 8 * 3}, {"rows", 6 * 3}};
  const TriangleSoup soup = terrain(npy("<f8", "(7, 9)", rough), finer);
  for (Index row = 0; row < 7; ++row) {
    for (Index column = 0; column < 9; ++column) {
      EXPECT_NEAR(vertex(soup, 24, 3 * column, 18 - 3 * row)[2], rough[row * 9 + column], 1e-12);
    }
  }
  const TriangleSoup smooth = terrain(npy("<f8", "(7, 9)", bilinear), finer);
  for (const auto& [x, y, z] : smooth.positions) {
    EXPECT_NEAR(z, 2 + 3 * (6 - y) - 0.5 * x + 0.25 * (6 - y) * x, 1e-12);
  }
}

TEST_F(Elevation, MakesNoStairsOfIntegerHeights) {
  // A slope of 1 in 8, stored in whole metres.
  std::vector<std::int16_t> heights;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 64; ++column) {
      heights.push_back(static_cast<std::int16_t>((column + 4) / 8));
    }
  }
  const TriangleSoup soup =
      terrain(npy("<i2", "(8, 64)", heights), {{"columns", 63 * 8}, {"rows", 7}});
  double greatest_step = 0;
  for (Index i = 0; i < 63 * 8; ++i) {
    greatest_step =
        std::max(greatest_step, vertex(soup, 63 * 8, i + 1, 3)[2] - vertex(soup, 63 * 8, i, 3)[2]);
  }
  EXPECT_LT(greatest_step, 0.25) << "a stair is a metre high";
}

TEST_F(Elevation, HasTheCommittedBits) {
  const std::string bytes =
      npy<std::int16_t>("<i2", "(3, 4)", {3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8});
  const std::uint64_t hash = hash_of(
      terrain(bytes, {{"columns", 17}, {"rows", 11}, {"spacing-x", 74.57}, {"spacing-y", 92.48}}));
  EXPECT_EQ(hash, 0x4f7354e927a2ee1eu) << std::hex << "0x" << hash;
}

TEST_F(Elevation, NamesTheFileThatIsWrong) {
  expect_error([&] { terrain("no array", {}); }, {"heights.npy: not a .npy file"});
  expect_error(
      [] {
        generate("elevation", {{"input", "/no/such.npy"}});
      },
      {"/no/such.npy: no such file"});
}

}  // namespace
}  // namespace geodesic
