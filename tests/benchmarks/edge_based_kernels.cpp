// The steps of edge-based propagation over one list of windows, for every instruction set.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_AVX3 | HWY_SSE4 | HWY_SSSE3)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/benchmarks/edge_based_kernels.cpp"
#include <hwy/foreach_target.h>

#include "solvers/edge_based/kernels-inl.h"
#include "tests/benchmarks/microbench.h"

HWY_BEFORE_NAMESPACE();
namespace geodesic::edge_based::HWY_NAMESPACE {

inline void fill(Batch& batch, const std::vector<Window>& windows) {
  batch.reserve(windows.size());
  batch.count = windows.size();
  for (std::size_t i = 0; i < windows.size(); ++i) {
    batch.set_interval(i, windows[i]);
    batch.array(kX)[i] = windows[i].x;
    batch.array(kY)[i] = windows[i].y;
    batch.array(kSigma)[i] = windows[i].sigma;
  }
}

/// A batch, the face it crosses and room for what becomes of it.
struct Crossing {
  explicit Crossing(const benchmark::State& state)
      : windows(microbench::windows_in_order(static_cast<std::size_t>(state.range(0)))),
        lists(1),
        left(windows.size() / kLanes + 1),
        right(windows.size() / kLanes + 1),
        suspects(windows.size() / kLanes + 1) {
    fill(batch, windows);
    classify(batch, face, left.data(), right.data());
  }

  const std::vector<Window> windows;
  const FaceFrame face = microbench::crossed_face_frame();
  WindowLists<Note::none> lists;
  Batch batch;
  std::vector<std::uint8_t> left, right, suspects;
};

inline void gather_list(benchmark::State& state) {
  Crossing crossing(state);
  auto* segment = crossing.lists.allocate(crossing.windows.size());
  segment->count = static_cast<std::uint32_t>(crossing.windows.size());
  for (std::size_t i = 0; i < crossing.windows.size(); ++i) {
    for (unsigned f = 0; f < kDepth; ++f) segment->array(f)[i] = crossing.batch.array(f)[i];
  }
  const EndPaths ends(crossing.face.length, 2.2, 2.2);  // beaten by none
  for (auto _ : state) {
    crossing.batch.count = 0;
    gather<Note::none>(*segment, ends, crossing.batch);
    benchmark::DoNotOptimize(crossing.batch.count);
    benchmark::ClobberMemory();
  }
}

inline void find_suspects_in_list(benchmark::State& state) {
  Crossing crossing(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(find_suspects(crossing.batch, crossing.suspects.data()));
    benchmark::ClobberMemory();
  }
}

inline void classify_list(benchmark::State& state) {
  Crossing crossing(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        classify(crossing.batch, crossing.face, crossing.left.data(), crossing.right.data()));
    benchmark::ClobberMemory();
  }
}

inline void unfold_list(benchmark::State& state) {
  Crossing crossing(state);
  const std::size_t room = crossing.windows.size() + kLaneRoom - 1;
  auto *to_left = crossing.lists.allocate(room), *to_right = crossing.lists.allocate(room);
  for (auto _ : state) {
    unfold<LeftEdge, Note::none>(crossing.batch, crossing.face, crossing.left.data(),
                                 crossing.right.data(), *to_left);
    unfold<RightEdge, Note::none>(crossing.batch, crossing.face, crossing.right.data(),
                                  crossing.left.data(), *to_right);
    benchmark::ClobberMemory();
  }
}

inline constexpr microbench::Steps kSteps{gather_list, find_suspects_in_list, classify_list,
                                          unfold_list};

}  // namespace geodesic::edge_based::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "solvers/core/instruction_set.h"

namespace geodesic::edge_based {
namespace {

void add(const std::string& name, void (*step)(benchmark::State&)) {
  const auto with_time_per_window = [step](benchmark::State& state) {
    step(state);
    microbench::report_per_item(state, "per_window", state.range(0));
  };
  auto* benchmark = benchmark::RegisterBenchmark(name.c_str(), with_time_per_window);
  for (const int windows : {1, 4, 8, 17, 64}) benchmark->Arg(windows);
}

void add(const std::string& path, const microbench::Steps& steps) {
  add("gather/" + path, steps.gather);
  add("find_suspects/" + path, steps.find_suspects);
  add("classify/" + path, steps.classify);
  add("unfold/" + path, steps.unfold);
}

/// Two windows that overlap, their sources the wrong way round: one trims the other.
void trim_overlapping_pair(benchmark::State& state) {
  const Crossed face{1, 0.5, -0.8};
  const Window near{0.1, 0.7, 0.4, -1, 0}, far{0.4, 0.9, 0.2, -1.2, 0.3};
  for (auto _ : state) {
    Window first = near, second = far;
    benchmark::DoNotOptimize(first);
    trim_pair(first, second, face);
    benchmark::DoNotOptimize(first);
    benchmark::DoNotOptimize(second);
  }
}
BENCHMARK(trim_overlapping_pair);

const bool added = [] {
  add("plain", HWY_STATIC_DISPATCH(kSteps));
#if (HWY_TARGETS & HWY_AVX2) != 0 && HWY_STATIC_TARGET != HWY_AVX2
  if (why_unavailable(InstructionSet::avx2).empty()) add("avx2", N_AVX2::kSteps);
#endif
  return true;
}();

}  // namespace
}  // namespace geodesic::edge_based
#endif
