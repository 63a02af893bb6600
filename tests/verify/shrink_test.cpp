// Shrinking of cases with known failures: only the parts that the failure needs remain.
#include "harness/verify/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "meshes/oracles/random_meshes.h"

namespace geodesic::harness {
namespace {

constexpr double kLong = 60;  // seconds

Case terrain(const std::vector<Query>& queries) {
  return {"terrain", rough_terrain(1, 8, 8, 1), queries};
}

std::set<Vec3> places(const Case& given, const std::vector<Index>& vertices) {
  std::set<Vec3> all;
  for (const Index v : vertices) all.insert(given.soup.positions.at(v));
  return all;
}

// Whether the case has a face with corners at these positions.
bool has_face(const Case& given, const std::set<Vec3>& corners) {
  return std::ranges::any_of(given.soup.triangles, [&](const Triangle& t) {
    return places(given, {t.begin(), t.end()}) == corners;
  });
}

TEST(Shrink, leaves_the_faces_that_the_failure_needs_and_the_source) {
  const Case given = terrain({from(40)});
  std::vector<std::set<Vec3>> needed;
  for (const std::size_t f : {3u, 77u}) {
    const Triangle& t = given.soup.triangles[f];
    needed.push_back(places(given, {t.begin(), t.end()}));
  }
  const Case small = shrink(
      given, {}, [&](const Case& c) { return has_face(c, needed[0]) && has_face(c, needed[1]); },
      kLong);
  EXPECT_EQ(small.soup.triangles.size(), 2u);
  EXPECT_TRUE(has_face(small, needed[0]) && has_face(small, needed[1]));
  ASSERT_EQ(small.queries.size(), 1u);
  const Index source = small.queries[0].sources.at(0).at.vertex;
  EXPECT_EQ(small.soup.positions.at(source), given.soup.positions[40]);
  std::set<Index> used{source};
  for (const Triangle& t : small.soup.triangles) used.insert(t.begin(), t.end());
  EXPECT_EQ(used.size(), small.soup.positions.size()) << "a vertex is left that nothing needs";
}

TEST(Shrink, asks_the_suspect_alone_before_it_tries_others) {
  const Case given = terrain({from(0), from(1), from(2), from(3)});
  const Vec3 wrong = given.soup.positions[2];
  int attempts = 0;
  const Case small = shrink(
      given, from(2),
      [&](const Case& c) {
        if (++attempts == 1) {
          EXPECT_EQ(c.queries.size(), 1u);
        }
        return std::ranges::any_of(c.queries, [&](const Query& query) {
          return c.soup.positions.at(query.sources.at(0).at.vertex) == wrong;
        });
      },
      kLong);
  EXPECT_EQ(small.queries.size(), 1u);
  EXPECT_EQ(small.soup.triangles.size(), 1u) << "a mesh keeps a face";
}

TEST(Shrink, keeps_the_queries_before_the_one_that_fails_after_them) {
  const Case small = shrink(
      terrain({from(0), from(1), from(2), from(3)}), from(3),
      [](const Case& c) { return c.queries.size() >= 2; }, kLong);
  EXPECT_EQ(small.queries.size(), 2u);
}

TEST(Shrink, drops_sources) {
  const Case small = shrink(
      terrain({from({5, 6, 7, 8})}), {},
      [](const Case& c) { return c.queries.at(0).sources.size() >= 3; }, kLong);
  EXPECT_EQ(small.queries.at(0).sources.size(), 3u);
}

TEST(Shrink, keeps_vertices_without_faces_where_they_are_what_fails) {
  Case given = terrain({from(0)});
  given.soup.positions.push_back({9, 9, 9});
  const std::size_t vertices = given.soup.positions.size();
  const Case small = shrink(
      given, {}, [&](const Case& c) { return c.soup.positions.size() == vertices; }, kLong);
  EXPECT_EQ(small.soup.triangles.size(), 1u);
  EXPECT_EQ(small.soup.positions.size(), vertices);
}

TEST(Shrink, asks_few_faces_near_the_source_before_any_large_mesh) {
  const Case given{"terrain", rough_terrain(2, 60, 60, 1), {from(30), from(1800)}};
  std::size_t most = 0;
  const Case small = shrink(
      given, from(1800),
      [&](const Case& c) {
        most = std::max(most, c.soup.triangles.size());
        return c.soup.triangles.size() >= 20;
      },
      kLong);
  EXPECT_EQ(small.soup.triangles.size(), 20u);
  EXPECT_LT(most, 100u);
}

TEST(Shrink, without_time_gives_the_case_back) {
  const Case given = terrain({from(0), from(1)});
  const Case small = shrink(
      given, from(0), [](const Case&) { return true; }, 0);
  EXPECT_EQ(small.soup.triangles, given.soup.triangles);
  EXPECT_EQ(small.queries.size(), 2u);
}

}  // namespace
}  // namespace geodesic::harness
