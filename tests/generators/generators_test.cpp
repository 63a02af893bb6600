// The generators: shapes, counts, reproducible bits, and one-line errors for wrong parameters.
#include "meshes/generators/generators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshes/defects.h"
#include "meshes/generators/families.h"
#include "tests/generators/generator_test.h"

namespace geodesic {
namespace {

/// A generated mesh and its expected properties.
struct Expected {
  std::string generator;
  GeneratorParameters parameters;
  std::size_t vertices;
  std::size_t faces;
  long euler_characteristic;
  std::size_t boundary_loops;
  std::uint64_t hash;
};

void PrintTo(const Expected& expected, std::ostream* out) {  // NOLINT: GoogleTest's name
  *out << expected.generator;
}

class Generated : public ::testing::TestWithParam<Expected> {};

/// Volume of a closed surface; positive if its faces are oriented outwards.
double volume_of(const TriangleSoup& soup) {
  double volume = 0;
  for (const auto& [a, b, c] : soup.triangles) {
    volume += dot(soup.positions[a], cross(soup.positions[b], soup.positions[c])) / 6;
  }
  return volume;
}

TEST_P(Generated, IsAnOrientedManifoldOfItsCountsTopologyAndBits) {
  const TriangleSoup soup = generate(GetParam().generator, GetParam().parameters);
  EXPECT_EQ(soup.positions.size(), GetParam().vertices);
  EXPECT_EQ(soup.triangles.size(), GetParam().faces);
  EXPECT_FALSE(find_defects(soup).has_errors());
  const MeshSummary summary = summarize(soup);
  EXPECT_EQ(euler_characteristic(summary), GetParam().euler_characteristic);
  EXPECT_EQ(summary.boundary_loops, GetParam().boundary_loops);
  EXPECT_GT(summary.edge_lengths->least, 0);
  if (summary.boundary_edges == 0) {
    EXPECT_GT(volume_of(soup), 0) << "faces look inwards";
  }
  EXPECT_EQ(hash_of(soup), GetParam().hash) << std::hex << "0x" << hash_of(soup);
}

const Expected kExpected[] = {
    {"box", {{"x-cells", 4}, {"y-cells", 5}, {"z-cells", 6}}, 150, 296, 2, 0, 0x50ce2630a5fda8e1u},
    {"box", {{"x-cells", 1}, {"y-cells", 1}, {"z-cells", 1}}, 8, 12, 2, 0, 0x336466114d116ed5u},
    {"capped-grid", {}, 137, 240, 1, 1, 0xb23e515ead65e0bdu},
    {"cone", {}, 1633, 3072, 1, 1, 0xd43e6656e1b28471u},
    {"cylinder", {}, 1200, 2304, 0, 2, 0xc8ea96d5623aac4bu},
    {"egg-carton", {}, 2401, 4608, 1, 1, 0x581b330a76157aaeu},
    {"grid", {{"columns", 7}, {"rows", 3}}, 32, 42, 1, 1, 0x9bba39b3af3c702au},
    {"grid", {{"rows", 3}, {"diagonal", "forward"}}, 132, 192, 1, 1, 0x687bdc36301b21e0u},
    {"grid", {{"rows", 3}, {"diagonal", "backward"}}, 132, 192, 1, 1, 0xd49cb9cadb9137e0u},
    {"holed-plate", {{"bulge", 0.3}}, 2068, 3672, -8, 10, 0x9873cc2bc22df8b3u},
    {"icosphere", {{"frequency", 1}}, 12, 20, 2, 0, 0x83769d3449146c45u},
    {"icosphere", {{"frequency", 2}}, 42, 80, 2, 0, 0xb96c7e983d058765u},
    {"icosphere", {}, 2562, 5120, 2, 0, 0xc63e16365c7ac5b9u},
    {"involute", {}, 130, 128, 1, 1, 0x2e6e135d18492900u},
    {"needles", {}, 2160, 3840, 0, 2, 0xa9df5e91fdee983eu},
    {"saddle-cone", {}, 1089, 2048, 1, 1, 0x7f672f909e426488u},
    {"square-with-hole", {}, 880, 1600, 0, 2, 0x1186ad5474c5c4a9u},
    {"terrain", {}, 3249, 6272, 1, 1, 0x19c76c10df2e6e9u},
    {"terrain", {{"seed", 2}}, 3249, 6272, 1, 1, 0x5ab26f6640c24104u},
    {"torus", {}, 2048, 4096, 0, 0, 0x88f74e02760a9af5u},
    {"torus-knot", {}, 28800, 57600, 0, 0, 0x8620a1e363923a7cu},
    {"torus-knot",
     {{"p", 3}, {"q", 5}, {"tube-radius", 0.1}},
     28800,
     57600,
     0,
     0,
     0x251f2cc8d32b7059u},
    {"two-components", {}, 1389, 2768, 5, 0, 0xf2ae8e519768971u},
};

INSTANTIATE_TEST_SUITE_P(Corpus, Generated, ::testing::ValuesIn(kExpected));

bool starts_from_a_file(const GeneratorDescription& generator) {
  return std::any_of(generator.parameters.begin(), generator.parameters.end(),
                     [](const ParameterDescription& parameter) { return parameter.is_required(); });
}

TEST(Generators, EveryOneThatStartsFromNothingIsAmongTheExpected) {
  for (const GeneratorDescription& generator : generator_descriptions()) {
    if (starts_from_a_file(generator)) continue;
    EXPECT_TRUE(std::any_of(std::begin(kExpected), std::end(kExpected), [&](const Expected& e) {
      return e.generator == generator.name;
    })) << generator.name;
  }
}

TEST(Generators, DescribeThemselvesInFull) {
  for (const GeneratorDescription& generator : generator_descriptions()) {
    EXPECT_FALSE(generator.description.empty()) << generator.name;
    for (const ParameterDescription& parameter : generator.parameters) {
      EXPECT_FALSE(parameter.description.empty()) << generator.name << ' ' << parameter.name;
      EXPECT_FALSE(parameter.range().empty()) << generator.name << ' ' << parameter.name;
    }
  }
}

TEST(Generators, AcceptTheirDefaultsWrittenOut) {
  for (const GeneratorDescription& generator : generator_descriptions()) {
    if (starts_from_a_file(generator)) continue;
    GeneratorParameters defaults;
    for (const ParameterDescription& parameter : generator.parameters) {
      defaults.insert_or_assign(parameter.name, parameter.default_value);
    }
    EXPECT_EQ(hash_of(generate(generator.name, defaults)), hash_of(generate(generator.name)))
        << generator.name;
  }
}

// Shapes whose exact distances tests rely on.

TEST(Generators, GridLiesExactlyOnItsLattice) {
  const TriangleSoup soup = generate("grid", {{"columns", 3}, {"rows", 2}, {"spacing", 0.1}});
  EXPECT_EQ(soup.positions[7], (Vec3{3 * 0.1, 0.1, 0}));
}

TEST(Generators, ConeAndSaddleHaveSlantEdgesOfTheirRings) {
  for (const char* const name : {"cone", "saddle-cone"}) {
    const TriangleSoup soup = generate(name, {{"rings", 4}, {"sectors", 10}});
    for (Index r = 1, first = 1; r <= 4; first += 10 * r++) {
      for (Index i = 0; i < 10; ++i) {
        const auto& [x, y, z] = soup.positions[first + i * r];
        EXPECT_NEAR(std::sqrt(x * x + y * y + z * z), r / 4.0, 1e-15)
            << name << ' ' << r << ' ' << i;
      }
    }
  }
}

TEST(Generators, SaddleConeOfEquilateralSectorsHasEqualEdges) {
  const MeshSummary summary = summarize(generate("saddle-cone", {{"sectors", 12}}));
  EXPECT_NEAR(summary.edge_lengths->least, 1.0 / 16, 1e-15);
  EXPECT_NEAR(summary.edge_lengths->greatest, 1.0 / 16, 1e-15);
  EXPECT_EQ(summary.saddle_vertices, 1u);
}

TEST(Generators, ConeHasTheTotalAngleAsked) {
  const TriangleSoup soup = generate("cone", {{"sectors", 5}, {"angle", 300}, {"rings", 1}});
  const Vec3 &a = soup.positions[1], &b = soup.positions[2];
  EXPECT_NEAR(a[0] * b[0] + a[1] * b[1] + a[2] * b[2], 0.5, 1e-15) << "cosine of 300 / 5 degrees";
}

TEST(Generators, SphereVerticesLieOnTheSphere) {
  for (const auto& [x, y, z] : generate("icosphere", {{"frequency", 9}}).positions) {
    EXPECT_NEAR(std::sqrt(x * x + y * y + z * z), 1, 1e-15);
  }
}

TEST(Generators, SaddleRichMeshesHaveManySaddles) {
  for (const char* const name : {"egg-carton", "torus-knot", "needles", "terrain"}) {
    const TriangleSoup soup = generate(name);
    EXPECT_GT(summarize(soup).saddle_vertices, soup.positions.size() * 2 / 5) << name;
  }
}

TEST(Generators, TwoComponentsHaveAnIsolatedVertexBetweenThem) {
  const MeshSummary summary = summarize(generate("two-components"));
  EXPECT_EQ(summary.components, 2u);
  EXPECT_EQ(summary.isolated_vertices, 1u);
}

TEST(Circle, AgreesWithTheLibraryAndHasExactSymmetries) {
  for (int k = -64; k <= 1000; ++k) {
    const double turns = k / 128.0 + (k % 8 == 0 ? 0 : 1e-3);
    const CirclePoint point = circle_point(turns);
    EXPECT_NEAR(point.cosine, std::cos(kTwoPi * turns), 1e-14) << turns;
    EXPECT_NEAR(point.sine, std::sin(kTwoPi * turns), 1e-14) << turns;
  }
  EXPECT_EQ(circle_point(0.25).cosine, 0);
  EXPECT_EQ(circle_point(0.5).sine, 0);
  EXPECT_EQ(circle_point(0.375).sine, -circle_point(0.875).sine);
}

// Wrong input gives one line that lists the valid choices.

TEST(GeneratorErrors, UnknownGeneratorListsAll) {
  const std::string message = refusal("gird", {});
  EXPECT_NE(message.find("'gird'"), std::string::npos) << message;
  EXPECT_NE(message.find("grid, holed-plate, icosphere"), std::string::npos) << message;
}

TEST(GeneratorErrors, UnknownParameterListsAll) {
  EXPECT_EQ(refusal("grid", {{"colums", 3}}),
            "grid: no parameter named 'colums' (did you mean 'columns'?); there are: columns, "
            "rows, spacing, "
            "diagonal");
}

TEST(GeneratorErrors, ValuesOutOfRangeNameTheRange) {
  const std::string range = "'; it must be an integer from 1 to 40000";
  for (const char* const value : {"0", "40001", "2.5", "nan", "inf", "", "12x", "0x10", "-3"}) {
    EXPECT_EQ(refusal("grid", {{"rows", value}}),
              "grid: parameter rows is '" + std::string(value) + range);
  }
  EXPECT_EQ(refusal("torus", {{"tube-radius", 1}}),
            "torus: parameter tube-radius is '1'; it must be a number from 0.001 to 0.99");
  EXPECT_EQ(refusal("torus", {{"diagonal", "up"}}),
            "torus: parameter diagonal is 'up'; it must be one of alternating, forward, backward");
}

TEST(GeneratorErrors, ImpossibleCombinationsAreRefused) {
  EXPECT_NE(refusal("torus-knot", {{"p", 4}, {"q", 6}}), "nothing was thrown");
  EXPECT_NE(refusal("saddle-cone", {{"sectors", 9}}), "nothing was thrown");
  EXPECT_NE(refusal("saddle-cone", {{"sectors", 6}}), "nothing was thrown")
      << "360 degrees are flat";
}

TEST(GeneratorErrors, MoreFacesThanCanBeNumberedAreRefusedAtOnce) {
  EXPECT_NE(refusal("grid", {{"columns", 40000}, {"rows", 40000}}).find("too large"),
            std::string::npos);
}

}  // namespace
}  // namespace geodesic
