// The windows that wait on the half-edges of the wavefront, in spatial order, in pooled segments.
//
// A list is filled in batches (the windows that one face sends to one of its edges) and consumed
// whole. A batch is one contiguous segment; a list is a short chain of segments. Batches that
// arrive through the edge next to the list's origin are prepended, those that arrive through the
// other one appended: windows stay in the order in which their lines meet the edge, without any
// search (thesis section 5.2).
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic::edge_based {

enum class Place { front, back };

template <class W>
class WindowLists {
 public:
  explicit WindowLists(Index half_edges) : lists_(half_edges) {}

  bool empty(Index h) const { return lists_[h].first == kNone; }
  std::uint64_t size() const { return size_; }

  /// Copies a batch to one end of the list of h; an empty batch does nothing.
  void add(Index h, std::span<const W> batch, Place place) {
    if (batch.empty()) return;
    const Index s = allocate(batch.size());
    std::copy(batch.begin(), batch.end(), windows_.begin() + segments_[s].start);
    segments_[s].count = static_cast<Index>(batch.size());
    segments_[s].next = kNone;
    List& list = lists_[h];
    if (list.first == kNone) {
      list = {s, s};
    } else if (place == Place::front) {
      segments_[s].next = list.first;
      list.first = s;
    } else {
      segments_[list.last].next = s;
      list.last = s;
    }
    size_ += batch.size();
  }

  /// Moves the whole list of h, in order, to the end of `into`; the list is empty afterwards.
  void take(Index h, std::vector<W>& into) {
    for_each_segment(h, [&](std::span<const W> part) {
      into.insert(into.end(), part.begin(), part.end());
      size_ -= part.size();
    });
    clear(h);
  }

  template <class Visit>
  void for_each_segment(Index h, Visit&& visit) const {
    for (Index s = lists_[h].first; s != kNone; s = segments_[s].next) {
      visit(std::span<const W>(windows_.data() + segments_[s].start, segments_[s].count));
    }
  }

  /// Empties every list; the pool keeps its memory.
  void clear() {
    for (List& list : lists_) list = {};
    windows_.clear();
    segments_.clear();
    for (std::vector<Index>& bin : free_) bin.clear();
    size_ = 0;
  }

 private:
  struct List {
    Index first = kNone;
    Index last = kNone;
  };
  struct Segment {
    std::uint32_t start;  // into windows_
    Index count;
    Index next;
    std::uint32_t bin;  // room for 2^bin windows
  };
  static constexpr std::size_t kBins = 32;

  Index allocate(std::size_t count) {
    const auto bin = static_cast<std::uint32_t>(std::bit_width(count - 1));
    if (!free_[bin].empty()) {
      const Index s = free_[bin].back();
      free_[bin].pop_back();
      return s;
    }
    const auto start = static_cast<std::uint32_t>(windows_.size());
    windows_.resize(windows_.size() + (std::size_t{1} << bin));
    segments_.push_back({start, 0, kNone, bin});
    return static_cast<Index>(segments_.size() - 1);
  }

  void clear(Index h) {
    for (Index s = lists_[h].first; s != kNone; s = segments_[s].next) {
      free_[segments_[s].bin].push_back(s);
    }
    lists_[h] = {};
  }

  std::vector<List> lists_;
  std::vector<W> windows_;
  std::vector<Segment> segments_;
  std::vector<Index> free_[kBins];  // segments of room 2^bin that are not in use
  std::uint64_t size_ = 0;
};

}  // namespace geodesic::edge_based
