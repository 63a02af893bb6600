#include "harness/base/allocation_meter.h"

#include <malloc.h>
#include <sys/mman.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "harness/base/large_pages.h"

namespace {

// operator new reads these before any constructor has run, so they are constant-initialised.
constinit std::atomic<bool> metering{false};
constinit std::atomic<bool> large_pages{false};
constinit std::atomic<std::int64_t> live{0};
constinit std::atomic<std::int64_t> peak{0};

// Counts the requested size. The allocator may provide 16 bytes more, depending on its free blocks
// and therefore on earlier allocations.
std::int64_t counted(void* block, std::size_t asked) {
#ifdef __cpp_sized_deallocation
  return static_cast<std::int64_t>(asked > 0 ? asked : malloc_usable_size(block));
#else  // Blocks are released without their size.
  static_cast<void>(asked);
  return static_cast<std::int64_t>(malloc_usable_size(block));
#endif
}

void count_allocation(void* block, std::size_t asked) {
  const std::int64_t bytes = counted(block, asked);
  const std::int64_t now = live.fetch_add(bytes, std::memory_order_relaxed) + bytes;
  std::int64_t highest = peak.load(std::memory_order_relaxed);
  while (now > highest && !peak.compare_exchange_weak(highest, now, std::memory_order_relaxed)) {
  }
}

constexpr std::size_t kLargeBlock = std::size_t{4} << 20;

// A refusal is harmless: the pages are then small.
void ask_for_large_pages(void* block, std::size_t bytes) {
  constexpr std::uintptr_t kPage = 4096;
  const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(block) + kPage - 1) & ~(kPage - 1);
  const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(block) + bytes) & ~(kPage - 1);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): rounded to pages
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

void* allocate(std::size_t bytes, std::size_t alignment) {
  if (bytes == 0) bytes = 1;
  for (;;) {
    // aligned_alloc takes a multiple of the alignment.
    void* block = alignment <= alignof(std::max_align_t)
                      ? std::malloc(bytes)
                      : std::aligned_alloc(alignment, (bytes + alignment - 1) & ~(alignment - 1));
    if (block != nullptr) {
      if (metering.load(std::memory_order_relaxed)) [[unlikely]] {
        count_allocation(block, bytes);
      }
      if (bytes >= kLargeBlock && large_pages.load(std::memory_order_relaxed)) [[unlikely]] {
        ask_for_large_pages(block, bytes);
      }
      return block;
    }
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

// @param asked requested size; 0 where it is not known
void release(void* block, std::size_t asked = 0) noexcept {
  if (metering.load(std::memory_order_relaxed) && block != nullptr) [[unlikely]] {
    live.fetch_sub(counted(block, asked), std::memory_order_relaxed);
  }
  std::free(block);
}

}  // namespace

// The array forms of the standard library call these. The nothrow forms are replaced too, because a
// sanitizer has its own, and these deletes would not recognise their blocks.
void* operator new(std::size_t bytes) { return allocate(bytes, 1); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocate(bytes, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t bytes, const std::nothrow_t& /*tag*/) noexcept {
  try {
    return allocate(bytes, 1);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, const std::nothrow_t& /*tag*/) noexcept { release(block); }
void operator delete(void* block, std::align_val_t /*alignment*/) noexcept { release(block); }
void operator delete(void* block, std::size_t bytes) noexcept { release(block, bytes); }
void operator delete(void* block, std::size_t bytes, std::align_val_t /*alignment*/) noexcept {
  release(block, bytes);
}

namespace geodesic::harness {

AllocationMeter::AllocationMeter() {
  live = peak = 0;
  metering = true;
}
AllocationMeter::~AllocationMeter() { metering = false; }

LargePages::LargePages() { large_pages = true; }
LargePages::~LargePages() { large_pages = false; }

std::int64_t AllocationMeter::live_bytes() const { return live; }
std::int64_t AllocationMeter::peak_bytes() const { return peak; }

}  // namespace geodesic::harness
