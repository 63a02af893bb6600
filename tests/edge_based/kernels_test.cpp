// The vector kernels of every instruction set give the same bits as the plain ones, and these do
// what the strategies demand.
#include "solvers/edge_based/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/edge_based/steps.h"

namespace geodesic::edge_based {
namespace {

struct Problem {
  std::vector<Window> windows;
  FaceFrame face;
  double at_origin, at_head;
};

/// Windows along an edge, some of which protrude beyond the next one. Their sources are only
/// roughly in order.
Problem random_problem(Random& random, std::size_t count) {
  Problem problem{.windows = {}, .face = random_face(random), .at_origin = 0, .at_head = 0};
  problem.at_origin = random.between(0.8, 2.5);
  problem.at_head = random.between(0.8, 2.5);
  const double share = 1 / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double begin = (static_cast<double>(i) + random.between(0, 0.5)) * share;
    problem.windows.push_back({begin, begin + share * random.between(0.3, 3),
                               begin + random.between(-0.4, 0.4), random.between(-2, -0.5),
                               random.between(0, 0.3)});
    problem.windows.back().end = std::min(problem.windows.back().end, 1.0);
  }
  return problem;
}

/// Runs all kernels on one list of windows.
Steps run(const Problem& p, InstructionSet set = InstructionSet::plain) {
  const Kernels& kernels = kernels_of(set, Carried::nothing);
  WindowLists lists(1, fields_with(Carried::nothing), kernels.lanes);
  Segment* segment = lists.allocate(p.windows.size());
  for (const Window& w : p.windows) segment->add(w);
  const EndpointBounds bounds(p.face.length, p.at_origin, p.at_head);
  Batch batch(fields_with(Carried::nothing), kernels.lanes),
      trimmed(fields_with(Carried::nothing), kernels.lanes);
  kernels.gather(*segment, bounds, batch);
  kernels.gather(*segment, bounds, trimmed);
  const std::size_t count = batch.count;
  const auto windows_of = [](const auto& arrays) {
    std::vector<Window> list;
    for (std::size_t i = 0; i < arrays.count; ++i) list.push_back(window_of(arrays, i));
    return list;
  };
  const auto flags = [](const Marks& marks, std::size_t n) {
    std::vector<bool> bits;
    for (std::size_t i = 0; i < n; ++i) bits.push_back(marks[i]);
    return bits;
  };

  Steps steps;
  steps.gathered = windows_of(batch);
  if (count == 0) return steps;
  kernels.trim(trimmed, {p.face.length, p.face.apex_x, -p.face.apex_y});
  steps.trimmed = windows_of(trimmed);
  Segment *to_left = lists.allocate(count), *to_right = lists.allocate(count);
  steps.winner = kernels.unfold(batch, p.face, *to_left, *to_right);
  steps.to_left = windows_of(*to_left);
  steps.to_right = windows_of(*to_right);
  steps.left = flags(batch.passes_left, count);
  steps.right = flags(batch.passes_right, count);
  if (steps.winner.is_contested) steps.contested = flags(batch.contested, count);
  Marks odd_left(kernels.lanes), odd_right(kernels.lanes);
  odd_left.copy(batch.passes_left, count);
  odd_right.copy(batch.passes_right, count);
  for (std::size_t i = 0; i < count; i += 2) odd_left.clear(i), odd_right.clear(i);
  kernels.unfold_marked(batch, p.face, odd_left, odd_right, *to_left, *to_right);
  steps.odd_to_left = windows_of(*to_left);
  steps.odd_to_right = windows_of(*to_right);
  return steps;
}

/// Calls check(problem, steps) for lists of all lengths up to several vectors, and of some that are
/// longer than what is trimmed at once.
template <class Check>
void for_each_problem(std::uint64_t seed, Check&& check) {
  Random random(seed);
  for (std::size_t count = 1; count <= 3 * kTrimmedAtOnce; count += count < 40 ? 1 : 25) {
    for (int repetition = 0; repetition < 50; ++repetition) {
      const Problem problem = random_problem(random, count);
      check(problem, run(problem));
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(Kernels, of_all_vectors_give_the_bits_of_the_plain_ones) {
  int compared = 0;
  for (const InstructionSet set : kInstructionSets) {
    if (set == InstructionSet::plain || compiled_for(set) != set || !why_unavailable(set).empty()) {
      continue;
    }
    ++compared;
    for_each_problem(1, [&](const Problem& p, const Steps& plain) {
      ASSERT_EQ(bits_of(run(p, set)), bits_of(plain))
          << name_of(set) << ", " << p.windows.size() << " windows";
    });
  }
  if (compared == 0) GTEST_SKIP() << "one instruction set only";
}

TEST(Gather, keeps_what_no_path_over_an_end_of_the_edge_beats_everywhere) {
  for_each_problem(2, [](const Problem& p, const Steps& steps) {
    std::vector<Window> kept;
    for (const Window& w : p.windows) {
      const bool by_origin = p.at_origin + w.end < distance_at(w, w.end);
      const bool by_head = p.at_head + p.face.length - w.begin < distance_at(w, w.begin);
      if (!by_origin && !by_head) kept.push_back(w);
    }
    ASSERT_EQ(bits_of(steps.gathered), bits_of(kept));
  });
}

TEST(Trim, changes_a_list_only_if_neighbours_are_out_of_order) {
  int in_order = 0, changed = 0;
  for_each_problem(3, [&](const Problem&, const Steps& steps) {
    const bool any =
        std::ranges::adjacent_find(steps.gathered, out_of_order) != steps.gathered.end();
    const bool same = bits_of(steps.trimmed) == bits_of(steps.gathered);
    ASSERT_TRUE(any || same);
    in_order += !any;
    changed += !same;
  });
  EXPECT_GT(in_order, 100);
  EXPECT_GT(changed,
            500);  // of 2,350: `Kernels` compares instruction sets on lists that are trimmed
}

TEST(Classify, finds_the_least_distance_to_the_apex_and_the_windows_that_see_it) {
  for_each_problem(4, [](const Problem& p, const Steps& steps) {
    double least = kInfinity;
    for (std::size_t i = 0; i < steps.gathered.size(); ++i) {
      const Window& w = steps.gathered[i];
      const bool sees = right_of(w, w.begin, p.face.apex_x, p.face.apex_y) > 0 &&
                        right_of(w, w.end, p.face.apex_x, p.face.apex_y) < 0;
      ASSERT_EQ(steps.left[i] && steps.right[i], sees) << i;
      if (sees) least = std::min(least, distance_through(w, p.face.apex_x, p.face.apex_y));
    }
    ASSERT_EQ(steps.winner.distance, least);
  });
}

TEST(Classify, marks_all_windows_that_the_winner_may_take_lines_from) {
  int decided = 0;
  for_each_problem(6, [&](const Problem& p, const Steps& steps) {
    if (steps.winner.window == SIZE_MAX) return;
    const Window& best = steps.gathered[steps.winner.window];
    for (std::size_t i = 0; i < steps.gathered.size(); ++i) {
      if (i == steps.winner.window || (!steps.contested.empty() && steps.contested[i])) continue;
      const Sides seen{steps.left[i], steps.right[i]};
      ASSERT_EQ(sides_kept(steps.gathered[i], seen, steps.winner, best, p.face, 0), seen) << i;
      ++decided;
    }
  });
  EXPECT_GT(decided, 1000);
}

TEST(Unfold, gives_children_that_cover_what_their_parent_sees_and_nothing_else) {
  for_each_problem(5, [](const Problem& p, const Steps& steps) {
    std::size_t left = 0, right = 0;
    for (std::size_t i = 0; i < steps.gathered.size(); ++i) {
      const Window& w = steps.gathered[i];
      const FaceFrame& f = p.face;
      const bool both = steps.left[i] && steps.right[i];
      const auto expect_child = [&](const Window& child, double begin, double end,
                                    const Point2& source) {
        EXPECT_NEAR(child.begin, begin, 1e-14);
        EXPECT_NEAR(child.end, end, 1e-14);
        EXPECT_NEAR(child.x, source.x, 1e-14);
        EXPECT_NEAR(child.y, std::min(source.y, 0.0), 1e-14);
        EXPECT_EQ(child.sigma, w.sigma);
      };
      if (steps.left[i]) {
        ASSERT_LT(left, steps.to_left.size());
        expect_child(steps.to_left[left++], f.on_left(w, w.begin),
                     both ? f.left : f.on_left(w, w.end), f.to_left(w.x, w.y));
      }
      if (steps.right[i]) {
        ASSERT_LT(right, steps.to_right.size());
        expect_child(steps.to_right[right++], both ? 0 : f.on_right(w, w.begin),
                     f.on_right(w, w.end), f.to_right(w.x, w.y));
      }
    }
    EXPECT_EQ(left, steps.to_left.size());
    EXPECT_EQ(right, steps.to_right.size());
  });
}

TEST(Unfold, reaches_an_apex_that_lines_miss_by_rounding_over_the_end_of_the_interval) {
  const Window beside{0.2, 0.5 - 5e-11, 0.5, -1e-3, 0};
  const FaceFrame face = face_of({0.5, 0.5});
  for (const InstructionSet set : kInstructionSets) {
    if (compiled_for(set) != set || !why_unavailable(set).empty()) continue;
    const Steps steps = run({{beside}, face, 2, 2}, set);
    ASSERT_EQ(steps.gathered.size(), 1u);
    EXPECT_EQ(steps.winner.window, 0u);
    EXPECT_EQ(steps.winner.distance, distance_over(beside, beside.end, 0.5, 0.5));
    EXPECT_EQ(steps.winner.position, beside.end);
    EXPECT_TRUE(steps.left[0] && !steps.right[0]);
    ASSERT_EQ(steps.to_left.size(), 1u);
    EXPECT_EQ(steps.to_left[0].end, face.on_left(beside, beside.end));
    EXPECT_EQ(steps.to_right.size(), 0u);
  }
}

TEST(UnfoldMarked, gives_the_same_children_of_the_marked_windows_alone) {
  for_each_problem(7, [](const Problem&, const Steps& steps) {
    std::vector<Window> left, right;
    std::size_t to_left = 0, to_right = 0;
    for (std::size_t i = 0; i < steps.gathered.size(); ++i) {
      if (steps.left[i] && to_left++ < steps.to_left.size() && i % 2 == 1) {
        left.push_back(steps.to_left[to_left - 1]);
      }
      if (steps.right[i] && to_right++ < steps.to_right.size() && i % 2 == 1) {
        right.push_back(steps.to_right[to_right - 1]);
      }
    }
    ASSERT_EQ(bits_of(steps.odd_to_left), bits_of(left));
    ASSERT_EQ(bits_of(steps.odd_to_right), bits_of(right));
  });
}

}  // namespace
}  // namespace geodesic::edge_based
