// Lists that the wavefront has passed are forgotten, and nothing else changes.
#include <gtest/gtest.h>

#include <bit>
#include <set>

#include "meshes/oracles/random_meshes.h"
#include "solvers/mmp/mmp.h"

namespace geodesic::mmp {
namespace {

struct Kept {
  std::vector<std::uint64_t> distances;  // as bits
  Recording recording;
  Index windows_kept = 0;
};

template <class Policy>
Kept solve(const Mesh& mesh, const Query& query, Keep keep) {
  Kept solved;
  Propagation<Policy, CountingRecorder> propagation(mesh, Policy::make_queue(mesh),
                                                    CountingRecorder(solved.recording));
  std::vector<double> distances(mesh.vertex_count(), kInfinity);
  propagation.run(Start(mesh, in_internal_numbers(mesh, query)), distances, keep);
  for (const double d : distances) solved.distances.push_back(std::bit_cast<std::uint64_t>(d));
  std::vector<Window> windows;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.twin(h) < h) continue;
    propagation.copy_windows(h, windows);
    solved.windows_kept += static_cast<Index>(windows.size());
  }
  return solved;
}

template <class Policy>
void expect_only_memory_to_change(const TriangleSoup& soup, const Query& query) {
  const Mesh mesh(soup);
  const Kept all = solve<Policy>(mesh, query, Keep::all);
  const Kept few = solve<Policy>(mesh, query, Keep::wavefront);
  EXPECT_EQ(few.distances, all.distances);
  EXPECT_EQ(few.recording, all.recording);
  EXPECT_EQ(all.windows_kept, *all.recording.window_limit);
  EXPECT_LT(few.windows_kept, all.windows_kept / 2) << "hardly any list was forgotten";
}

template <class Policy>
class PassedLists : public testing::Test {};
using Policies = testing::Types<ByDistance, ByBucket>;
TYPED_TEST_SUITE(PassedLists, Policies, );

TYPED_TEST(PassedLists, change_nothing_on_a_closed_surface_where_the_wavefront_meets_itself) {
  expect_only_memory_to_change<TypeParam>(rough_sphere(5, 5, 0.1), {{{0, 0}}});
}
TYPED_TEST(PassedLists, change_nothing_on_a_surface_with_handle_and_holes) {
  expect_only_memory_to_change<TypeParam>(with_holes(rough_torus(3, 60, 40, 0.2), 7, 6),
                                          {{{9, 0}}});
}
TYPED_TEST(PassedLists, change_nothing_when_a_source_begins_late_behind_the_wavefront) {
  expect_only_memory_to_change<TypeParam>(rough_terrain(2, 50, 50, 1.0),
                                          {{{0, 0}, {60, 20}, {1300, 25}, {2499, 0}}});
}
TYPED_TEST(PassedLists, change_nothing_among_collapsed_edges) {
  expect_only_memory_to_change<TypeParam>(
      with_collapsed_edges(rough_terrain(4, 50, 50, 0.7), 3, 40), {{{1275, 0}}});
}

TEST(OpenLists, are_looked_through_five_times_each_at_most) {
  OpenLists open;
  constexpr Index kLists = 100000;
  std::size_t looks = 0;
  // The worst case: no list is ever done.
  for (Index list = 0; list < kLists; ++list) {
    open.add(list);
    if (open.is_due()) open.look_through([&](Index) { return ++looks == 0; });
  }
  EXPECT_GT(looks, 0u);
  EXPECT_LE(looks, 5 * kLists);
}

TEST(OpenLists, are_shown_again_until_they_are_done) {
  OpenLists open;
  Index next = 0;
  const auto fill = [&] {
    while (!open.is_due()) open.add(next++);
  };
  std::set<Index> left;
  fill();
  open.look_through([](Index list) { return list % 3 != 0; });
  fill();
  open.look_through([&](Index list) { return left.insert(list).second; });
  for (Index list = 0; list < next; ++list) {
    const bool was_done = list % 3 != 0 && list < 1024;
    EXPECT_EQ(left.contains(list), !was_done) << list;
  }
}

}  // namespace
}  // namespace geodesic::mmp
