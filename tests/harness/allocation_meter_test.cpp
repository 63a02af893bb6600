#include "harness/base/allocation_meter.h"

#include <benchmark/benchmark.h>
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <memory>
#include <vector>

#include "harness/base/clock.h"

namespace geodesic::harness {
namespace {

/// Allocates a block that the compiler cannot optimise away.
template <class T>
std::vector<T> allocated(std::size_t items) {
  std::vector<T> block(items);
  benchmark::DoNotOptimize(block.data());
  return block;
}

TEST(AllocationMeter, SeesThePeakAndWhatIsLeft) {
  const AllocationMeter meter;
  { const auto large = allocated<double>(100000); }
  const auto small = allocated<double>(1000);
  EXPECT_GE(meter.peak_bytes(), 800000);
  EXPECT_LT(meter.peak_bytes(), 810000);
  EXPECT_GE(meter.live_bytes(), 8000);
  EXPECT_LT(meter.live_bytes(), 9000);
}

// An allocator without a free block of the requested size returns a larger one.
TEST(AllocationMeter, CountsWhatIsAskedForWhateverHappenedBefore) {
  std::vector<std::vector<char>> blocks;
  for (std::size_t bytes = 8000; bytes < 8200; bytes += 8) {
    blocks.push_back(allocated<char>(bytes));
    const auto between = allocated<char>(24);
  }
  while (!blocks.empty()) {
    blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(blocks.size() / 2));
    const AllocationMeter meter;
    {
      const auto first = allocated<double>(1000), second = allocated<double>(10);
      EXPECT_EQ(meter.live_bytes(), 8080);
    }
    EXPECT_EQ(meter.live_bytes(), 0);
    EXPECT_EQ(meter.peak_bytes(), 8080);
  }
}

TEST(AllocationMeter, SeesOveralignedBlocks) {
  struct alignas(64) Line {
    double values[8];
  };
  const AllocationMeter meter;
  { const auto lines = allocated<Line>(1000); }
  EXPECT_GE(meter.peak_bytes(), 64000);
  EXPECT_EQ(meter.live_bytes(), 0);
}

// The memory is mapped and not from the heap: sanitizers keep freed blocks.
TEST(PeakResidentBytes, ForgetsWhatWasBeforeTheRestart) {
  constexpr std::size_t kBytes = 200 << 20;
  void* block = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE,
                     MAP_PRIVATE | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
  ASSERT_NE(block, MAP_FAILED);
  munmap(block, kBytes);
  const auto before = peak_resident_bytes();
  ASSERT_TRUE(before);
  EXPECT_GE(*before, std::int64_t{kBytes});
  restart_peak_resident_bytes();
  EXPECT_LT(*peak_resident_bytes(), *before - std::int64_t{kBytes} / 2);
}

}  // namespace
}  // namespace geodesic::harness
