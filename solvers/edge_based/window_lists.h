// The waiting windows on the half-edges of the wavefront, in spatial order, in pooled segments.
//
// A list is filled in batches (the windows that one face sends to one of its edges) and consumed as
// a whole. A batch is one segment, a structure of arrays. A list is a short chain of segments,
// stored as a ring, so that one link per half-edge reaches both ends. Batches that arrive through
// the edge next to the list's origin are prepended, others appended: windows stay in the order in
// which their lines meet the edge, without any search (thesis 5.2).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "solvers/core/geometry.h"
#include "solvers/core/window.h"

namespace geodesic::edge_based {

enum class Place { front, back };

/// The fields of a window: one array each in a segment or batch.
enum Field : unsigned { kBegin, kEnd, kX, kY, kSigma, kRoot, kDepth };

/// Additional fields of windows. A double represents whole numbers exactly.
enum class Carried : std::uint8_t {
  nothing,
  root,   ///< as in LastSegment; it does not change
  depth,  ///< the root, and the length of the window's strip: each crossed face adds 1
};

/// Number of arrays of a segment or batch.
constexpr unsigned fields_with(Carried carried) { return kRoot + static_cast<unsigned>(carried); }

/// Number of windows in the longest vectors.
inline constexpr std::size_t kMostLanes = 8;
/// Segments have room for a multiple of this many windows, or of a vector: they are whole units.
inline constexpr std::size_t kLeastRoom = 4;

/// Window i of a segment or batch.
template <class Arrays>
Window window_of(const Arrays& arrays, std::size_t i) {
  return {arrays.array(kBegin)[i], arrays.array(kEnd)[i], arrays.array(kX)[i], arrays.array(kY)[i],
          arrays.array(kSigma)[i]};
}

/// A header, followed in one block by arrays of `room` doubles each.
struct alignas(32) Segment {
  std::uint32_t count;
  std::uint32_t room;
  Index next;  // handle of the next segment; in the last segment, of the first one
  Index self;
  Place place;  // end of the list at which it was added

  double* array(std::size_t field) { return reinterpret_cast<double*>(this + 1) + field * room; }
  const double* array(std::size_t field) const {
    return reinterpret_cast<const double*>(this + 1) + field * room;
  }

  /// Appends a window without its additional fields. There must be room.
  void add(const Window& w) {
    array(kBegin)[count] = w.begin;
    array(kEnd)[count] = w.end;
    array(kX)[count] = w.x;
    array(kY)[count] = w.y;
    array(kSigma)[count] = w.sigma;
    ++count;
  }
};

class WindowLists {
 public:
  /// @param fields number of fields of a window (Field)
  /// @param lanes size of vectors, which are read and written whole
  WindowLists(Index half_edges, unsigned fields, std::size_t lanes = kMostLanes)
      : fields_(fields),
        room_bits_(static_cast<unsigned>(std::countr_zero(std::max(lanes, kLeastRoom)))),
        last_(half_edges, kNone) {}

  std::uint64_t window_count() const { return window_count_; }

  /// An empty segment for at least `windows` windows, one or more; it is in no list yet.
  [[gnu::always_inline]] Segment* allocate(std::size_t windows) {
    const unsigned bin = bin_of(windows);
    Index& head = free_[bin];
    if (head == kNone) return carve(bin);
    Segment* segment = at(head);
    head = segment->next;
    segment->count = 0;
    return segment;
  }

  void release(Segment* segment) {
    Index& head = free_[bin_of(segment->room)];
    segment->next = head;
    head = segment->self;
  }

  /// A copy of a segment, in no list yet.
  Segment* copy(const Segment& segment) {
    Segment* copy = allocate(segment.room);
    copy->count = segment.count;
    for (unsigned f = 0; f < fields_; ++f) {
      std::copy_n(segment.array(f), segment.count, copy->array(f));
    }
    return copy;
  }

  /// Adds a filled segment at one end of the list of h.
  void add(Index h, Segment* segment, Place place) {
    window_count_ += segment->count;
    segment->place = place;
    Index& last = last_[h];
    if (last == kNone) {
      segment->next = segment->self;
      last = segment->self;
      return;
    }
    Segment* end = at(last);
    segment->next = end->next;
    end->next = segment->self;
    if (place == Place::back) last = segment->self;
  }

  /// Calls visit for each segment of h in order, and releases it; the list is empty afterwards.
  template <class Visit>
  void consume(Index h, Visit&& visit) {
    const Index last = last_[h];
    if (last == kNone) return;
    last_[h] = kNone;
    Index s = at(last)->next;
    for (;;) {
      Segment* segment = at(s);
      const Index next = segment->next;
      window_count_ -= segment->count;
      visit(*segment);
      release(segment);
      if (s == last) break;
      s = next;
    }
  }

  template <class Visit>
  void for_each_segment(Index h, const Visit& visit) const {
    if (last_[h] == kNone) return;
    Index s = last_[h];
    do {
      s = at(s)->next;
      visit(*at(s));
    } while (s != last_[h]);
  }

  /// Frees the pool's memory. No windows may wait.
  void release_memory() {
    for (auto& blocks : spare_) blocks.clear();
    blocks_.clear();
    free_.fill(kNone);
    used_ = kBlockUnits;
  }

  /// Empties every list; the pool keeps its memory.
  void clear() {
    std::fill(last_.begin(), last_.end(), kNone);
    // Backwards, so that the next solve takes the blocks in the order in which this one did.
    for (; !blocks_.empty(); blocks_.pop_back()) {
      const unsigned bin = bin_of(first_segment(blocks_.back())->room);
      spare_[is_long(bin) ? bin : 0].push_back(std::move(blocks_.back()));
    }
    free_.fill(kNone);
    used_ = kBlockUnits;
    window_count_ = 0;
  }

 private:
  // Handles count units of 32 bytes; a block holds 2^10 of them, 32 KiB. A longer segment gets a
  // block of its own. No segment starts at unit 0.
  static constexpr std::size_t kUnit = 32;
  static constexpr unsigned kBlockBits = 10;
  static constexpr std::size_t kBlockUnits = std::size_t{1} << kBlockBits;
  static constexpr unsigned kBins = 30;
  struct alignas(2 * kUnit) CacheLine {
    std::byte bytes[2 * kUnit];
  };
  using Block = std::unique_ptr<CacheLine[]>;

  Segment* at(Index handle) const {
    std::byte* block = blocks_[handle >> kBlockBits][0].bytes;
    return reinterpret_cast<Segment*>(block + kUnit * (handle & (kBlockUnits - 1)));
  }

  static const Segment* first_segment(const Block& block) {
    return reinterpret_cast<const Segment*>(block[0].bytes + kUnit);
  }

  unsigned bin_of(std::size_t windows) const {
    return static_cast<unsigned>(std::bit_width((windows - 1) >> room_bits_));
  }

  std::size_t room_of(unsigned bin) const { return std::size_t{1} << (bin + room_bits_); }

  std::size_t units_of(unsigned bin) const {
    const std::size_t room = room_of(bin);
    const std::size_t units = (sizeof(Segment) + fields_ * room * sizeof(double)) / kUnit;
    // The arrays of each segment start on a cache line, behind its header.
    return room % kMostLanes == 0 ? units + units % 2 : units;
  }

  /// Whether a segment of this bin has a block of its own.
  bool is_long(unsigned bin) const { return units_of(bin) >= kBlockUnits; }

  Segment* carve(unsigned bin) {
    const std::size_t units = units_of(bin);
    if (used_ + units > kBlockUnits) open_block(bin);
    const Index handle = static_cast<Index>((blocks_.size() - 1) << kBlockBits | used_);
    used_ += units;
    Segment* segment = at(handle);
    segment->count = 0;
    segment->room = static_cast<std::uint32_t>(room_of(bin));
    segment->self = handle;
    return segment;
  }

  void open_block(unsigned bin) {
    std::vector<Block>& spare = spare_[is_long(bin) ? bin : 0];
    if (spare.empty()) {
      // Zeroed: vectors read the unused tail of an array.
      const std::size_t units = std::max(units_of(bin) + 2, kBlockUnits);
      blocks_.push_back(std::make_unique<CacheLine[]>(units / 2));
    } else {
      blocks_.push_back(std::move(spare.back()));
      spare.pop_back();
    }
    used_ = 1;
  }

  unsigned fields_;
  unsigned room_bits_;         // room is a multiple of 2 to this power
  std::vector<Index> last_;    // per half-edge, handle of the last segment; kNone when empty
  std::vector<Block> blocks_;  // in use, in the order of handles
  std::array<Index, kBins> free_ = [] {
    std::array<Index, kBins> none{};
    none.fill(kNone);
    return none;
  }();
  std::size_t used_ = kBlockUnits;  // used units of the last block
  std::uint64_t window_count_ = 0;
  // Blocks that `clear` kept: of long segments, by bin; all others, in bin 0.
  std::vector<std::vector<Block>> spare_{kBins};
};

}  // namespace geodesic::edge_based
