// A timed solve records nothing: what it calls does nothing, and it has no room for counters.
#include "solvers/core/recorders.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "solvers/chen_han/chen_han.h"
#include "solvers/edge_based/edge_based.h"
#include "solvers/mmp/mmp.h"
#include "tests/shapes.h"

namespace geodesic {
namespace {

const Mesh any_mesh(fan(3, 0, 1));
const Start any_start(any_mesh, {});

// A constant expression neither reads a clock nor changes anything but the objects that it makes,
// and these are empty.
consteval bool records() {
  NoRecorder recorder;
  const auto whole = recorder.enter(Phase::propagation);
  const auto trimming = recorder.enter(Phase::trimming);
  const auto queue = recorder.enter(Phase::queue);
  recorder.window_bytes(8);
  recorder.propagated(1, StripDepth{2});
  recorder.propagated(1, NoDepth().next());
  recorder.created(1);
  recorder.valid(1);
  recorder.reinserted(1);
  recorder.arrived(0, {0, 0, {0, 0}});
  recorder.crosses(0, Window{}, 0);
  NoRecorder::Count count = 3;
  recorder.wavefront_size(++count);
  recorder.wavefront_size(--count);
  recorder.wavefront_size(count += 2);
  NoRecorder::Progress progress;
  progress.start(any_mesh, any_start);
  progress.improved(kInfinity);
  recorder.sample(progress, [](const auto&) { throw "it visits windows"; });
  return progress.made_step();
}
template <class... Types>
constexpr bool kAllEmpty = (std::is_empty_v<Types> && ...);

TEST(TimedSolve, calls_only_what_does_nothing) {
  static_assert(!records());
  static_assert(kAllEmpty<NoRecorder, NoRecorder::Depth, NoRecorder::Progress, NoRecorder::Count,
                          LastSegmentOf<NoRecorder>, NoRecorder::NoScope>);
  static_assert(!kAllEmpty<TimingRecorder>);
}

TEST(TimedSolve, does_not_depend_on_what_it_would_have_counted) {
  static_assert(!std::is_convertible_v<NoRecorder::Count, std::uint64_t>);
}

struct WithCounts : NoRecorder {
  using Count = CountingRecorder::Count;
};
struct WithProgress : NoRecorder {
  using Progress = CountingRecorder::Progress;
};

/// Bytes by which the state of a solve with this recorder is larger than that of a timed one.
template <template <class> class State, class Recorder>
constexpr std::size_t kMore = sizeof(State<Recorder>) - sizeof(State<NoRecorder>);

template <class Recorder>
using EdgeBasedWith =
    edge_based::Wavefront<edge_based::ListCrossing, edge_based::ByDistance::Queue, Recorder>;
template <class Recorder>
using MmpWith = mmp::Propagation<mmp::ByDistance, Recorder>;
template <class Recorder>
using IchWith = chen_han::Propagation<chen_han::Ich, NoDepth, Recorder>;

TEST(TimedSolve, has_no_room_for_the_counts_and_the_progress_of_recorded_ones) {
  EXPECT_EQ((kMore<MmpWith, WithCounts>), 2 * sizeof(WithCounts::Count));
  EXPECT_EQ((kMore<IchWith, WithCounts>), sizeof(WithCounts::Count));
  EXPECT_EQ((kMore<MmpWith, WithProgress>), sizeof(Progress));
  EXPECT_EQ((kMore<IchWith, WithProgress>), sizeof(Progress));
  EXPECT_EQ((kMore<EdgeBasedWith, WithProgress>), sizeof(Progress));
}

}  // namespace
}  // namespace geodesic
