// Reusable memory: slots for single items, and growing arrays.
//
// edge_based/window_lists.h has its own segments: they are linked by 32-bit handles, and their
// arrays follow a header, in blocks in which vector instructions may read beyond the last item.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// Numbered slots for items of one type. The slot released last is used next, while it is still in
/// the cache. Released slots form a list: each stores the number of the next one in place of its
/// item.
/// @tparam T trivially copyable
template <class T>
class Pool {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) >= sizeof(Index));

 public:
  /// Releases every slot and keeps the memory.
  void clear() {
    slots_.clear();
    free_ = kNone;
  }

  /// @return the number of the item's slot
  [[gnu::always_inline]] Index add(const T& item) {
    if (free_ == kNone) {
      slots_.push_back(item);
      return static_cast<Index>(slots_.size() - 1);
    }
    const Index slot = free_;
    std::memcpy(&free_, &slots_[slot], sizeof free_);
    prefetch(free_);  // for the next call
    slots_[slot] = item;
    return slot;
  }

  void release(Index slot) {
    std::memcpy(static_cast<void*>(&slots_[slot]), &free_, sizeof free_);
    free_ = slot;
  }

  /// Removes and returns an item.
  T take(Index slot) {
    const T item = slots_[slot];
    release(slot);
    return item;
  }

  /// The item of a slot that was given out since the last `clear`. In a released slot only the
  /// first four bytes have changed.
  T& operator[](Index slot) { return slots_[slot]; }
  const T& operator[](Index slot) const { return slots_[slot]; }

  /// Starts to load a slot; its number may be kNone.
  void prefetch(Index slot) const { __builtin_prefetch(slots_.data() + slot); }

  /// Calls visit(item) for every item, in the order of slots.
  template <class Visit>
  void for_each(Visit&& visit) const {
    std::vector<bool> is_free(slots_.size());
    for (Index slot = free_; slot != kNone;) {
      is_free[slot] = true;
      std::memcpy(&slot, &slots_[slot], sizeof slot);
    }
    for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
      if (!is_free[slot]) visit(slots_[slot]);
    }
  }

 private:
  std::vector<T> slots_;
  Index free_ = kNone;
};

/// Arrays of a few fixed capacities, cut from large chunks, for lists that grow. Arrays are
/// uninitialised; those given back are reused. No memory returns to the system before the pool is
/// destroyed. T is trivially copyable.
template <class T>
class SegmentPool {
 public:
  /// Capacities are 4, 6, 8, 12, 16, 24, ...: two per doubling, so that an array that only grows
  /// wastes a sixth of its room on average.
  static std::uint32_t capacity_for(std::uint32_t items) { return capacity(size_class(items)); }

  T* take(std::uint32_t capacity_wanted) {
    std::vector<T*>& free = free_[size_class(capacity_wanted)];
    if (free.empty()) return cut(capacity_wanted);
    T* segment = free.back();
    free.pop_back();
    return segment;
  }

  void give_back(T* segment, std::uint32_t its_capacity) {
    free_[size_class(its_capacity)].push_back(segment);
  }

  /// Takes all arrays back at once; the chunks stay for the next solve.
  void clear() {
    for (std::vector<T*>& free : free_) free.clear();
    oversized_.clear();
    chunk_ = 0;
    used_ = 0;
  }

 private:
  static constexpr std::uint32_t kChunk = 1u << 15;  // items per chunk
  static constexpr std::uint32_t kSmallest = 4;

  // Class 2 k holds 4 * 2^k items, class 2 k + 1 half as many again.
  static std::uint32_t capacity(std::size_t number) {
    return (number % 2 == 0 ? kSmallest : kSmallest + kSmallest / 2) << (number / 2);
  }
  static std::size_t size_class(std::uint32_t items) {
    if (items <= kSmallest) return 0;
    // items in (2^(k + 1), 2^(k + 2)], split in the middle.
    const std::size_t k = static_cast<std::size_t>(std::bit_width(items - 1)) - 2;
    const std::size_t below = 2 * k - 1;  // class of 3 * 2^k items
    return items <= capacity(below) ? below : below + 1;
  }

  T* cut(std::uint32_t items) {
    if (items > kChunk / 4) {
      oversized_.push_back(std::make_unique_for_overwrite<T[]>(items));
      return oversized_.back().get();
    }
    if (chunk_ < chunks_.size() && used_ + items > kChunk) {
      ++chunk_;
      used_ = 0;
    }
    if (chunk_ == chunks_.size()) chunks_.push_back(std::make_unique_for_overwrite<T[]>(kChunk));
    T* segment = chunks_[chunk_].get() + used_;
    used_ += items;
    return segment;
  }

  std::array<std::vector<T*>, 64> free_;  // by size class
  std::vector<std::unique_ptr<T[]>> chunks_;
  std::vector<std::unique_ptr<T[]>> oversized_;
  std::size_t chunk_ = 0;  // the chunk being cut
  std::size_t used_ = 0;   // items cut from it
};

}  // namespace geodesic
