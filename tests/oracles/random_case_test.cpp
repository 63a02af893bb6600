// Random meshes depend only on seed and number, and are of every kind.
#include "meshes/oracles/random_case.h"

#include <gtest/gtest.h>

#include <set>

namespace geodesic {
namespace {

RandomCase made(std::uint64_t seed, std::uint64_t number) {
  return random_case(seed, number, ::testing::TempDir());
}

TEST(RandomCase, is_the_same_of_a_seed_and_a_number_every_time) {
  for (std::uint64_t number = 0; number < 40; ++number) {
    const RandomCase one = made(7, number), other = made(7, number);
    EXPECT_EQ(one.recipe, other.recipe);
    EXPECT_EQ(one.soup.positions, other.soup.positions) << one.recipe;
    EXPECT_EQ(one.soup.triangles, other.soup.triangles) << one.recipe;
  }
}

TEST(RandomCase, is_of_every_kind) {
  std::set<MeshKind> kinds;
  for (std::uint64_t number = 0; number < 200; ++number) {
    kinds.insert(kind_of(Mesh(made(8, number).soup)));
  }
  EXPECT_EQ(kinds.size(), kMeshKinds);
}

}  // namespace
}  // namespace geodesic
