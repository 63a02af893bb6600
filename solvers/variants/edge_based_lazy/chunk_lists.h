// Lists of windows (edge_based/window_lists.h) in chunks of a few that cross faces as a whole.
//
// Of the chunks of a list, those at its front that pass the apex of the face beyond on the left,
// and those at its back that pass it on the right, are carried (passage.h). Only what is between is
// gathered, trimmed, split and unfolded: order is kept without any search, as ever. What is carried
// is neither filtered nor trimmed, which loses nothing: both only spare work.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "solvers/variants/edge_based_lazy/passage.h"

namespace geodesic::edge_based_lazy {

/// The windows of a list are cut into as few chunks of at most this many as there can be.
inline constexpr std::size_t kChunk = 8;

template <edge_based::Note note>
class ChunkLists : edge_based::WindowLists<note, Passage> {
  using Base = edge_based::WindowLists<note, Passage>;

 public:
  using Place = edge_based::Place;
  using Base::allocate, Base::Base, Base::clear, Base::empty, Base::prefetch, Base::release,
      Base::size;
  using typename Base::Segment;

  static constexpr bool kCarries = true;

  /// Puts a filled segment, of windows unfolded onto h, at one end of the list of h.
  void add(Index h, Segment* segment, Place place) {
    const std::size_t pieces = (segment->count + kChunk - 1) / kChunk;
    if (pieces == 1) return add_chunk(h, segment, place);
    for (std::size_t k = 0; k < pieces; ++k) {
      const std::size_t piece = place == Place::back ? k : pieces - 1 - k;
      const std::size_t first = segment->count * piece / pieces;
      const std::size_t last = segment->count * (piece + 1) / pieces;
      add_chunk(h, copy(*segment, first, last), place);
    }
    release(segment);
  }

  /// Carries what it can of the list of h across the face of h, and sets it apart.
  void carry(Index h, const FaceFrame& face) {
    taken_.clear();
    Base::take(h, [&](Segment& chunk) { taken_.push_back(&chunk); });
    left_ = 0;
    right_ = taken_.size();
    while (left_ < right_ && taken_[left_]->extra.carry(face, Side::left)) ++left_;
    while (left_ < right_ && taken_[right_ - 1]->extra.carry(face, Side::right)) --right_;
    for (std::size_t k = left_; k < right_; ++k) Base::add(h, taken_[k], Place::back);
  }

  /// Calls visit(chunk, faces) for what is set apart; it has been carried across so many faces.
  template <class Visit>
  void for_each_carried(Visit&& visit) const {
    for (std::size_t k = 0; k < taken_.size(); ++k) {
      if (k < left_ || k >= right_) visit(*taken_[k], taken_[k]->extra.faces());
    }
  }

  /// Puts what is set apart into the lists of the two half-edges beyond the face, kNone on the
  /// boundary, outside of what has been added to them since.
  void land_carried(Index left, Index right) {
    for (std::size_t k = left_; k-- > 0;) land(left, taken_[k], Place::front);
    for (std::size_t k = right_; k < taken_.size(); ++k) land(right, taken_[k], Place::back);
  }

  /// As in WindowLists, with windows that lie on the edge of h.
  template <class Visit>
  void consume(Index h, Visit&& visit) {
    Base::consume(h, [&](Segment& chunk) {
      arrive(chunk);
      visit(chunk);
    });
  }
  template <class Visit>
  void for_each_segment(Index h, Visit&& visit) {
    Base::for_each_segment(h, [&](const Segment& chunk) {
      Segment* there = copy(chunk, 0, chunk.count);
      there->extra = chunk.extra;
      arrive(*there);
      visit(*there);
      release(there);
    });
  }

 private:
  static void arrive(Segment& chunk) {
    const std::uint32_t faces = chunk.extra.faces();
    if (faces == 0) return;
    chunk.extra.arrive(chunk);
    if constexpr (note != edge_based::Note::none) {
      for (std::size_t i = 0; i < chunk.count; ++i) chunk.array(edge_based::kDepth)[i] += faces;
    }
  }

  void add_chunk(Index h, Segment* chunk, Place place) {
    chunk->extra = Passage(*chunk);
    Base::add(h, chunk, place);
  }

  void land(Index h, Segment* chunk, Place place) {
    if (h == kNone) {
      release(chunk);
    } else {
      Base::add(h, chunk, place);
    }
  }

  /// Windows [first, last) of a segment in one of their own.
  Segment* copy(const Segment& segment, std::size_t first, std::size_t last) {
    Segment* piece = allocate(last - first);
    piece->count = static_cast<std::uint32_t>(last - first);
    for (unsigned f = 0; f < edge_based::fields_with(note); ++f) {
      std::copy(segment.array(f) + first, segment.array(f) + last, piece->array(f));
    }
    return piece;
  }

  std::vector<Segment*> taken_;  // of the list being carried; set apart but for [left_, right_)
  std::size_t left_ = 0, right_ = 0;
};

}  // namespace geodesic::edge_based_lazy
