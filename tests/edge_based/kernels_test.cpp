// The kernels, for every instruction set: they give the same bits, those of their scalar forms.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_AVX3 | HWY_SSE4 | HWY_SSSE3)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/edge_based/kernels_test.cpp"
#include <hwy/foreach_target.h>

#include "solvers/edge_based/kernels-inl.h"
#include "tests/edge_based/steps.h"

HWY_BEFORE_NAMESPACE();
namespace geodesic::edge_based::HWY_NAMESPACE {

/// All kernels over one list of windows.
inline Steps run_kernels(const std::vector<Window>& windows, const FaceFrame& face,
                         double at_origin, double at_head) {
  WindowLists<Note::none> lists(1);
  const auto segment_of = [&](const std::vector<Window>& list) {
    auto* segment = lists.allocate(list.size() + kLaneRoom);
    for (const Window& w : list) {
      const double fields[] = {w.begin, w.end, w.x, w.y, w.sigma};
      for (unsigned f = 0; f < kDepth; ++f) segment->array(f)[segment->count] = fields[f];
      ++segment->count;
    }
    return segment;
  };
  const auto windows_of = [](const auto& segment) {
    std::vector<Window> list;
    for (std::size_t i = 0; i < segment.count; ++i) {
      list.push_back({segment.array(kBegin)[i], segment.array(kEnd)[i], segment.array(kX)[i],
                      segment.array(kY)[i], segment.array(kSigma)[i]});
    }
    return list;
  };
  const auto flags = [](const std::vector<std::uint8_t>& masks, std::size_t count) {
    std::vector<bool> bits;
    for (std::size_t i = 0; i < count; ++i) bits.push_back(masks[i / kLanes] >> i % kLanes & 1);
    return bits;
  };

  Steps steps;
  Batch batch;
  gather<Note::none>(*segment_of(windows), EndPaths(face.length, at_origin, at_head), batch);
  steps.gathered = windows_of(batch);
  const std::size_t count = batch.count, groups = count / kLanes + 1;
  std::vector<std::uint8_t> suspects(groups), left(groups), right(groups);
  if (count > 1) find_suspects(batch, suspects.data());
  steps.suspects = flags(suspects, count > 0 ? count - 1 : 0);
  steps.separator = classify(batch, face, left.data(), right.data());
  steps.left = flags(left, count);
  steps.right = flags(right, count);
  auto *to_left = lists.allocate(count + kLaneRoom), *to_right = lists.allocate(count + kLaneRoom);
  unfold<LeftEdge, Note::none>(batch, face, left.data(), right.data(), *to_left);
  unfold<RightEdge, Note::none>(batch, face, right.data(), left.data(), *to_right);
  steps.to_left = windows_of(*to_left);
  steps.to_right = windows_of(*to_right);
  return steps;
}

}  // namespace geodesic::edge_based::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <gtest/gtest.h>

#include "solvers/core/instruction_set.h"

namespace geodesic::edge_based {
namespace {

struct Problem {
  std::vector<Window> windows;
  FaceFrame face;
  double at_origin, at_head;
};

/// Windows that share an edge in order, of sources that are hardly so.
Problem random_problem(Random& random, std::size_t count) {
  Problem problem{.windows = {}, .face = random_face(random), .at_origin = 0, .at_head = 0};
  problem.at_origin = random.between(0.8, 2.5);
  problem.at_head = random.between(0.8, 2.5);
  const double share = 1 / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double begin = static_cast<double>(i) * share;
    problem.windows.push_back({begin, begin + share * random.between(0.5, 1.2),
                               begin + random.between(-0.4, 0.4), random.between(-2, -0.5),
                               random.between(0, 0.3)});
    problem.windows.back().end = std::min(problem.windows.back().end, 1.0);
  }
  return problem;
}

Steps run(const Problem& p) {
  return HWY_STATIC_DISPATCH(run_kernels)(p.windows, p.face, p.at_origin, p.at_head);
}

/// Calls check(problem, steps) for lists of all lengths around those of vectors.
template <class Check>
void for_each_problem(std::uint64_t seed, Check&& check) {
  Random random(seed);
  for (std::size_t count = 1; count <= 40; ++count) {
    for (int repetition = 0; repetition < 50; ++repetition) {
      const Problem problem = random_problem(random, count);
      check(problem, run(problem));
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(Kernels, of_plain_and_of_vector_lanes_give_the_same_bits) {
#if (HWY_TARGETS & HWY_AVX2) != 0 && HWY_STATIC_TARGET != HWY_AVX2
  if (!why_unavailable(InstructionSet::avx2).empty()) GTEST_SKIP();
  for_each_problem(1, [](const Problem& p, const Steps& plain) {
    const Steps avx2 = N_AVX2::run_kernels(p.windows, p.face, p.at_origin, p.at_head);
    ASSERT_EQ(bits_of(avx2), bits_of(plain)) << p.windows.size() << " windows";
  });
#else
  GTEST_SKIP() << "one instruction set only";
#endif
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

TEST(FindSuspects, finds_the_pairs_that_are_not_in_order) {
  int found = 0;
  for_each_problem(3, [&](const Problem&, const Steps& steps) {
    for (std::size_t i = 0; i < steps.suspects.size(); ++i) {
      ASSERT_EQ(steps.suspects[i], !in_order(steps.gathered[i], steps.gathered[i + 1]));
      found += steps.suspects[i];
    }
  });
  EXPECT_GT(found, 1000);
}

TEST(Classify, finds_the_least_distance_to_the_apex_and_who_sees_it) {
  for_each_problem(4, [](const Problem& p, const Steps& steps) {
    double least = kInfinity;
    for (std::size_t i = 0; i < steps.gathered.size(); ++i) {
      const Window& w = steps.gathered[i];
      const bool sees = apex_side(w, w.begin, p.face) > 0 && apex_side(w, w.end, p.face) < 0;
      ASSERT_EQ(steps.left[i] && steps.right[i], sees) << i;
      if (sees) least = std::min(least, distance_through(w, p.face.apex_x, p.face.apex_y));
    }
    ASSERT_EQ(steps.separator.distance, least);
  });
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

}  // namespace
}  // namespace geodesic::edge_based
#endif
